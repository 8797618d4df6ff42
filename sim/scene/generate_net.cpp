// SPDX-License-Identifier: MIT
// Generator of a net: rows and columns of bodies, each joined to its four neighbours. See generators.h.
#include <fmt/format.h>

#include <algorithm>

#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/generators.h"

namespace pabd {

namespace {

bool is_fixed(const spec::Net& net, std::int64_t row, std::int64_t column) {
  const bool row_end = row == 0 || row + 1 == net.rows, column_end = column == 0 || column + 1 == net.columns;
  if (net.fixed == "corners") return row_end && column_end;
  if (net.fixed == "edges") return row_end || column_end;
  return net.fixed == "top" && row == 0;
}

}  // namespace

void generate(const spec::Net& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const std::string& prefix = entry.name.empty() ? context.prefix : entry.name;
  const Vec3& size = *entry.size;
  const double gap = *entry.gap;
  const JointType type = *entry.joint;
  const Shape shape = entry.shape == "sphere" ? Shape(Sphere{size.minCoeff() / 2}) : Shape(Box{0.5 * size});
  const Vec3 across = (size.x() + gap) * Vec3::UnitX();
  const Vec3 down =
      *entry.upright ? Vec3(-(size.y() + gap) * Vec3::UnitY()) : Vec3((size.z() + gap) * Vec3::UnitZ());
  const auto first = static_cast<Index>(out.model.name.size());
  // Both factors are at most 4e6, so that no product overflows.
  out.reserve(entry.rows * entry.columns, in);
  out.reserve_joints(2 * entry.rows * entry.columns, in);
  for (std::int64_t row = 0; row < entry.rows; ++row) {
    for (std::int64_t column = 0; column < entry.columns; ++column) {
      BodySpec body;
      body.name = fmt::format("{} {}.{}", prefix, row, column);
      body.shape = shape;
      body.mass = mass_of(entry);
      body.fixed = is_fixed(entry, row, column);
      body.c = *entry.position +
               (static_cast<double>(column) - 0.5 * static_cast<double>(entry.columns - 1)) * across +
               (static_cast<double>(row) - 0.5 * static_cast<double>(entry.rows - 1)) * down;
      out.add(std::move(body), in);
    }
  }
  const auto join = [&](std::int64_t a, std::int64_t b) {
    Joint joint;
    joint.type = type;
    joint.i = static_cast<Index>(first + a);
    joint.j = static_cast<Index>(first + b);
    const auto i = static_cast<std::size_t>(joint.i), j = static_cast<std::size_t>(joint.j);
    if (out.model.fixed[i] && out.model.fixed[j]) return;
    const Vec3 y_i = out.state.c[i], y_j = out.state.c[j];
    joint.arm = 0.5 * bounding_radius(shape);
    joint.law = out.joint_law;
    if (traits_of(type).points) {
      joint.on_i = joint.on_j = {Vec3::Zero(), Mat3::Identity()};
      joint.length = (y_j - y_i).norm();
    } else {
      attach(out.state, 0.5 * (y_i + y_j), Mat3::Identity(), joint);
    }
    out.add_joint(std::move(joint), *entry.collide);
  };
  for (std::int64_t row = 0; row < entry.rows; ++row) {
    for (std::int64_t column = 0; column < entry.columns; ++column) {
      const std::int64_t here = row * entry.columns + column;
      if (column + 1 < entry.columns) join(here, here + 1);
      if (row + 1 < entry.rows) join(here, here + entry.columns);
    }
  }
}

}  // namespace pabd
