// SPDX-License-Identifier: MIT
// Generators: a few lines in a file that stand for many bodies. One function each. Internal to sim/scene.
//
// Bodies start at rest and apart: by default bricks leave 0.95 d̂ between levels (a contact that already
// carries a little load) and d̂ sideways (no contact). Levels, rows and columns count from 0, as indices in a
// file do.
#pragma once

#include <vector>

#include "sim/scene/model_builder.h"

namespace pabd {

// What a generator needs to know besides its own keys.
struct GeneratorContext {
  double d_hat;                // contact thickness; m
  std::string default_prefix;  // of body names when the file gives none
};

void generate_stack(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);
void generate_wall(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);
void generate_pyramid(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);
void generate_pile(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);
void generate_chain(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);
void generate_net(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out);

// Shapes that generators make, by their place in shape_kinds(): boxes, spheres and everything that may be a
// rod.
std::vector<Choice> generated_shapes();
bool is_rod(int kind);

// A box of edges `box`, a sphere of that diameter, or a rod, its length along y.
struct RodSize {
  double length, thickness;  // m
};
Shape generated_shape(int kind, const Vec3& box, double diameter, const RodSize& rod);

// What is thrown where an entry is refused while d̂ is only assumed: with the one that follows from the bodies there may
// be room for the gaps.
struct GapsInDoubt {};

// Runs every entry of "generate", in order.
void run_generators(const ObjectReader& scene, double d_hat, bool assumed, ModelBuilder& out);

}  // namespace pabd
