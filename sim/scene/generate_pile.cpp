// SPDX-License-Identifier: MIT
// Generator of a pile: bodies on a jittered grid, randomly turned, in layers above the ground, ready to fall.
// See generators.h.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/scene/generators.h"
#include "sim/scene/random.h"

namespace pabd {

namespace {

constexpr int kMixed = -1;  // a box, a sphere or a capsule, the first three of the table

std::vector<Choice> choices() {
  std::vector<Choice> out = generated_shapes();
  out.push_back({"mixed", kMixed});
  return out;
}

// Fits into the box of that size: a sphere of its shortest edge, a rod three quarters as thick and as long as
// the longest.
Shape make_shape(int kind, const Vec3& size) {
  const double shortest = size.minCoeff(), longest = size.maxCoeff();
  return generated_shape(kind, size, shortest, {longest, 0.75 * shortest});
}

double reach(int kind, const Vec3& size) {
  if (kind == kMixed) return std::max(reach(0, size), reach(2, size));
  return bounding_radius(make_shape(kind, size));
}

}  // namespace

void generate_pile(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  std::string prefix = in.name("name");
  if (prefix.empty()) prefix = context.default_prefix;
  const std::int64_t count = in.integer("count", 1, kMostBodies);
  static const std::vector<Choice> kinds = choices();
  const int kind = in.choice("shape", kinds, 0);
  const Vec3 size = in.vec3("size", kSizeRange, Vec3::Ones());
  const Vec3 position = in.vec3("position", kPositionRange, Vec3::Zero());
  const MassSpec mass = read_mass(in);
  const double vary = in.number("vary", {0, 0.9}, 0);
  const std::int64_t default_columns =
      static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count)) - 1e-9));
  const std::int64_t columns = in.integer("columns", 1, kMostBodies, default_columns);
  const double widest = 2 * reach(kind, size) * (1 + vary);
  const double spacing = in.number("spacing", {0, 1e6, "m"}, 1.1 * widest + context.d_hat);
  const double seed_max = 9007199254740992.0;  // 2^53: what every JSON writer can hold
  Random random(static_cast<std::uint64_t>(in.integer("seed", 0, static_cast<std::int64_t>(seed_max), 1)));

  // What is left of a cell around a body, however it is turned, is the room to jitter in.
  const double room = 0.5 * (spacing - widest - context.d_hat);
  if (!(room >= 0)) {
    in.fail_key("spacing",
                fmt::format("expected {} m or more, so that bodies do not overlap at the start, got {}",
                            widest + context.d_hat, spacing));
  }
  out.reserve(count, in);
  const double middle = 0.5 * static_cast<double>(std::min(columns, count) - 1);
  for (std::int64_t i = 0; i < count; ++i) {
    const Vec3 cell(static_cast<double>(i % columns) - middle,
                    static_cast<double>(i / columns / columns) + 0.5,
                    static_cast<double>(i / columns % columns) - middle);
    const auto draw = static_cast<int>(random.bits() % 3);
    const double scale = 1 + vary * random.symmetric();
    const double jx = random.symmetric(), jy = random.symmetric(), jz = random.symmetric();
    BodySpec body;
    body.name = fmt::format("{} {}", prefix, i);
    body.shape = make_shape(kind == kMixed ? draw : kind, scale * size);
    body.mass = mass;
    body.c = position + cell * spacing + room * Vec3(jx, jy, jz);
    body.c.y() += 0.5 * context.d_hat;  // the lowest layer starts at least d̂ above the ground
    body.R = random.rotation();
    out.add(std::move(body), in);
  }
}

}  // namespace pabd
