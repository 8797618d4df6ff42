// SPDX-License-Identifier: MIT
// Generators of bricks laid level on level: stack, wall, pyramid. See generators.h.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "sim/scene/generators.h"

namespace pabd {

namespace {

// Makes the bricks of an entry that was read.
struct BrickLayer {
  const spec::Bricks& bricks;
  std::string prefix;
  Vec3 size = *bricks.size, position = *bricks.position;
  double gap = *bricks.gap;

  BrickLayer(const spec::Bricks& entry, const GeneratorContext& context)
      : bricks(entry), prefix(entry.name.empty() ? context.prefix : entry.name) {}

  double height_of(std::int64_t level) const {
    return position.y() + gap * static_cast<double>(level + 1) +
           size.y() * (static_cast<double>(level) + 0.5);
  }

  BodySpec brick(std::string name, const Vec3& brick_size, double x, std::int64_t level) const {
    BodySpec body;
    body.name = std::move(name);
    body.shape = Box{0.5 * brick_size};
    body.mass = mass_of(bricks);
    body.c = Vec3(x, height_of(level), position.z());
    return body;
  }
};

double half_offset(std::int64_t i, std::int64_t n) {
  return static_cast<double>(i) - 0.5 * static_cast<double>(n - 1);
}

}  // namespace

void generate(const spec::Stack& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const BrickLayer bricks(entry.bricks, context);
  const double turn = *entry.rotate * (kPi / 180);
  if (!entry.masses.empty() && (in.has("mass") || in.has("density")))
    in.fail_key("masses", "expected one of mass, masses and density");
  out.reserve(entry.count, in);
  for (std::int64_t level = 0; level < entry.count; ++level) {
    BodySpec body =
        bricks.brick(fmt::format("{} {}", bricks.prefix, level), bricks.size, bricks.position.x(), level);
    if (!entry.masses.empty())
      body.mass.mass = entry.masses[static_cast<std::size_t>(level) % entry.masses.size()];
    if (turn != 0) {
      body.R = Eigen::AngleAxisd(std::remainder(turn * static_cast<double>(level), 2 * kPi), Vec3::UnitY())
                   .toRotationMatrix();
    }
    out.add(std::move(body), in);
  }
}

void generate(const spec::Wall& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const BrickLayer bricks(entry.bricks, context);
  const std::int64_t columns = entry.columns, rows = entry.rows;
  const double spacing = *entry.spacing;
  const bool half_blocks = *entry.half_blocks;
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

void generate(const spec::Pyramid& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const BrickLayer bricks(entry.bricks, context);
  const std::int64_t base = entry.base;
  const double pitch = bricks.size.x() + *entry.spacing;
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
