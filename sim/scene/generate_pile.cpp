// SPDX-License-Identifier: MIT
// Generator of a pile: bodies on a jittered grid, randomly turned, in layers above the ground, ready to fall.
// See generators.h.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/scene/generators.h"
#include "sim/scene/random.h"

namespace pabd {

namespace {

constexpr std::string_view kMixed[] = {"box", "sphere", "capsule"};

// Fits into the box of that size: a sphere of its shortest edge, a rod three quarters as thick and as long as
// the longest.
Shape make_shape(const ShapeKind& kind, const Vec3& size) {
  const double shortest = size.minCoeff(), longest = size.maxCoeff();
  return generated_shape(kind, size, shortest, {longest, 0.75 * shortest});
}

double reach(std::string_view word, const Vec3& size) {
  if (word == "mixed") return std::max(reach("box", size), reach("capsule", size));
  return bounding_radius(make_shape(generated_kind(word), size));
}

}  // namespace

std::int64_t spec::Pile::usual_columns() const {
  return static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
}

double spec::Pile::widest() const { return 2 * reach(shape, *size) * (1 + *vary); }

void generate(const spec::Pile& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const std::string& prefix = entry.name.empty() ? context.prefix : entry.name;
  const std::int64_t count = entry.count, columns = *entry.columns;
  const double spacing = *entry.spacing, vary = *entry.vary, least = entry.widest() + context.d_hat;
  Random random(static_cast<std::uint64_t>(*entry.seed));

  // What is left of a cell around a body, however it is turned, is the room to jitter in.
  const double room = 0.5 * (spacing - entry.widest() - context.d_hat);
  if (!(room >= 0)) {
    in.fail_key("spacing",
                fmt::format("expected {} m or more, so that bodies do not overlap at the start, got {}",
                            least, spacing));
  }
  out.reserve(count, in);
  const double middle = 0.5 * static_cast<double>(std::min(columns, count) - 1);
  for (std::int64_t i = 0; i < count; ++i) {
    const Vec3 cell(static_cast<double>(i % columns) - middle,
                    static_cast<double>(i / columns / columns) + 0.5,
                    static_cast<double>(i / columns % columns) - middle);
    const std::string_view draw = kMixed[random.bits() % 3];
    const double scale = 1 + vary * random.symmetric();
    const double jx = random.symmetric(), jy = random.symmetric(), jz = random.symmetric();
    BodySpec body;
    body.name = fmt::format("{} {}", prefix, i);
    body.shape = make_shape(generated_kind(entry.shape == "mixed" ? draw : entry.shape), scale * *entry.size);
    body.mass = mass_of(entry);
    body.c = *entry.position + cell * spacing + room * Vec3(jx, jy, jz);
    body.c.y() += 0.5 * context.d_hat;  // the lowest layer starts at least d̂ above the ground
    body.R = random.rotation();
    out.add(std::move(body), in);
  }
}

}  // namespace pabd
