// SPDX-License-Identifier: MIT
// Generators: a few lines in a file that stand for many bodies. One function each (generator_entries.h has
// their keys). Internal to sim/scene.
//
// Bodies start at rest and apart: by default bricks leave 0.95 d̂ between levels (a contact that already
// carries a little load) and d̂ sideways (no contact). Levels, rows and columns count from 0, as indices in a
// file do.
#pragma once

#include <string>

#include "sim/body/shape_kind.h"
#include "sim/scene/generator_entries.h"
#include "sim/scene/model_builder.h"

namespace pabd {

// Where the bodies of an entry go.
struct GeneratorContext {
  const ObjectReader& in;  // the entry, to be blamed
  double d_hat;            // contact thickness; m
  std::string prefix;      // of body names
  ModelBuilder& out;
};

void generate(const spec::Stack& entry, const GeneratorContext& context);
void generate(const spec::Wall& entry, const GeneratorContext& context);
void generate(const spec::Pyramid& entry, const GeneratorContext& context);
void generate(const spec::Pile& entry, const GeneratorContext& context);
void generate(const spec::Chain& entry, const GeneratorContext& context);
void generate(const spec::Net& entry, const GeneratorContext& context);

// Calls `visit` with an empty entry of each type.
void for_each_generator(auto&& visit) {
  visit(spec::Stack{});
  visit(spec::Wall{});
  visit(spec::Pyramid{});
  visit(spec::Pile{});
  visit(spec::Chain{});
  visit(spec::Net{});
}

// The row of the shape that a generator is told to make.
const ShapeKind& generated_kind(std::string_view word);

// A box of edges `box`, a sphere of that diameter, or a rod, its length along y.
struct RodSize {
  double length, thickness;  // m
};
Shape generated_shape(const ShapeKind& kind, const Vec3& box, double diameter, const RodSize& rod);

// What is thrown where an entry is refused while d̂ is only assumed: with the one that follows from the bodies there may
// be room for the gaps.
struct GapsInDoubt {};

// Runs every entry of "generate", in order.
void run_generators(const ObjectReader& scene, double d_hat, bool assumed, ModelBuilder& out);

}  // namespace pabd
