// SPDX-License-Identifier: MIT
// Generators of bricks laid level on level: stack, wall, pyramid. See generators.h.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "sim/scene/generators.h"

namespace pabd {

namespace {

constexpr Range kGapRange{0, 1e3, "m"};
constexpr double kRestingGap = 0.95;  // of d̂: between levels, so that they start in light contact

// What all three share.
struct Bricks {
  std::string prefix;
  Vec3 size;      // edge lengths; m
  Vec3 position;  // centre of the bottom, on the ground; m
  double gap;     // between levels and below the first; m
  MassSpec mass;

  Bricks(const ObjectReader& in, const GeneratorContext& context)
      : prefix(in.name("name")),
        size(in.vec3("size", kSizeRange, Vec3::Ones())),
        position(in.vec3("position", kPositionRange, Vec3::Zero())),
        gap(in.number("gap", kGapRange, kRestingGap * context.d_hat)),
        mass(read_mass(in)) {
    if (prefix.empty()) prefix = context.default_prefix;
  }

  double height_of(std::int64_t level) const {
    return position.y() + gap * static_cast<double>(level + 1) +
           size.y() * (static_cast<double>(level) + 0.5);
  }

  BodySpec brick(std::string name, const Vec3& brick_size, double x, std::int64_t level) const {
    BodySpec body;
    body.name = std::move(name);
    body.shape = Box{0.5 * brick_size};
    body.mass = mass;
    body.c = Vec3(x, height_of(level), position.z());
    return body;
  }
};

double half_offset(std::int64_t i, std::int64_t n) {
  return static_cast<double>(i) - 0.5 * static_cast<double>(n - 1);
}

}  // namespace

void generate_stack(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  Bricks bricks(in, context);
  const std::int64_t count = in.integer("count", 1, kMostBodies);
  const double turn = in.number("rotate", {-360, 360, "degrees"}, 0) * (kPi / 180);
  std::vector<double> masses;  // from the bottom up, repeated
  if (const auto list = in.find("masses")) {
    if (in.has("mass") || in.has("density"))
      in.fail_key("masses", "expected one of mass, masses and density");
    if (list->array_size() == 0) list->fail("expected at least one mass");
    for (std::size_t i = 0; i < list->array_size(); ++i) {
      masses.push_back(list->element(i).number(kMassRange));
      in.record("masses", masses.back());
    }
  }
  out.reserve(count, in);
  for (std::int64_t level = 0; level < count; ++level) {
    BodySpec body =
        bricks.brick(fmt::format("{} {}", bricks.prefix, level), bricks.size, bricks.position.x(), level);
    if (!masses.empty()) body.mass.mass = masses[static_cast<std::size_t>(level) % masses.size()];
    if (turn != 0) {
      body.R = Eigen::AngleAxisd(std::remainder(turn * static_cast<double>(level), 2 * kPi), Vec3::UnitY())
                   .toRotationMatrix();
    }
    out.add(std::move(body), in);
  }
}

void generate_wall(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  const Bricks bricks(in, context);
  const std::int64_t columns = in.integer("columns", 1, kMostBodies);
  const std::int64_t rows = in.integer("rows", 1, kMostBodies);
  const double spacing = in.number("spacing", kGapRange, context.d_hat);
  const bool half_blocks = in.boolean("half_blocks", true);
  if (half_blocks && rows > 1 && !((bricks.size.x() - spacing) / 2 >= kSizeRange.lo)) {
    in.fail(fmt::format(
        "half blocks of {} m bricks with {} m between them have no width; expected a smaller spacing, "
        "or \"half_blocks\": false",
        bricks.size.x(), spacing));
  }
  // Running bond: every odd row is shifted by half a pitch, with a half block at each end if wanted.
  const std::int64_t odd_rows = rows / 2, even_rows = rows - odd_rows;
  const std::int64_t odd_full = columns - 1, odd_count = odd_full + (half_blocks ? 2 : 0);
  out.reserve(even_rows * columns + odd_rows * odd_count, in);

  const double pitch = bricks.size.x() + spacing;
  const Vec3 half_size((bricks.size.x() - spacing) / 2, bricks.size.y(), bricks.size.z());
  const double half_x = 0.5 * (static_cast<double>(columns) * pitch - spacing - half_size.x());
  for (std::int64_t row = 0; row < rows; ++row) {
    const bool odd = row % 2 == 1;
    const std::int64_t full = odd ? odd_full : columns;
    std::int64_t piece = 0;
    const auto lay = [&](const Vec3& size, double x) {
      out.add(bricks.brick(fmt::format("{} {}.{}", bricks.prefix, row, piece++), size,
                           bricks.position.x() + x, row),
              in);
    };
    if (odd && half_blocks) lay(half_size, -half_x);
    for (std::int64_t i = 0; i < full; ++i) lay(bricks.size, half_offset(i, full) * pitch);
    if (odd && half_blocks) lay(half_size, half_x);
  }
}

void generate_pyramid(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  const Bricks bricks(in, context);
  const std::int64_t base = in.integer("base", 1, 2827);  // 2827·2828/2 is just below the largest scene
  const double pitch = bricks.size.x() + in.number("spacing", kGapRange, context.d_hat);
  out.reserve(base * (base + 1) / 2, in);
  for (std::int64_t row = 0; row < base; ++row) {
    const std::int64_t n = base - row;
    for (std::int64_t i = 0; i < n; ++i) {
      out.add(bricks.brick(fmt::format("{} {}.{}", bricks.prefix, row, i), bricks.size,
                           bricks.position.x() + half_offset(i, n) * pitch, row),
              in);
    }
  }
}

}  // namespace pabd
