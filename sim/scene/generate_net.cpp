// SPDX-License-Identifier: MIT
// Generator of a net: rows and columns of bodies, each joined to its four neighbours. See generators.h.
#include <fmt/format.h>

#include <algorithm>

#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/generators.h"

namespace pabd {

namespace {

enum class Kind { box, sphere };
enum class Edges { none, corners, edges, top };

constexpr Choice kKinds[] = {{"box", static_cast<int>(Kind::box)},
                             {"sphere", static_cast<int>(Kind::sphere)}};
constexpr Choice kNetJoints[] = {{"spherical", static_cast<int>(JointType::spherical)},
                                 {"distance", static_cast<int>(JointType::distance)}};
constexpr Choice kEdges[] = {{"none", static_cast<int>(Edges::none)},
                             {"corners", static_cast<int>(Edges::corners)},
                             {"edges", static_cast<int>(Edges::edges)},
                             {"top", static_cast<int>(Edges::top)}};

struct Grid {
  std::int64_t rows, columns;
  Edges edges;

  bool fixed(std::int64_t row, std::int64_t column) const {
    const bool row_end = row == 0 || row + 1 == rows, column_end = column == 0 || column + 1 == columns;
    switch (edges) {
      case Edges::none:
        return false;
      case Edges::corners:
        return row_end && column_end;
      case Edges::edges:
        return row_end || column_end;
      case Edges::top:
        break;
    }
    return row == 0;
  }
};

}  // namespace

void generate_net(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  std::string prefix = in.name("name");
  if (prefix.empty()) prefix = context.default_prefix;
  Grid grid;
  grid.rows = in.integer("rows", 1, kMostBodies);
  grid.columns = in.integer("columns", 1, kMostBodies);
  const auto kind = static_cast<Kind>(in.choice("shape", kKinds, static_cast<int>(Kind::box)));
  const Vec3 size = in.vec3("size", kSizeRange, Vec3::Ones());
  const Vec3 position = in.vec3("position", kPositionRange, Vec3::Zero());
  const double gap = in.number("gap", {0, 1e3, "m"}, context.d_hat);
  const bool upright = in.boolean("upright", false);
  const auto type =
      static_cast<JointType>(in.choice("joint", kNetJoints, static_cast<int>(JointType::spherical)));
  grid.edges = static_cast<Edges>(in.choice("fixed", kEdges, static_cast<int>(Edges::corners)));
  const MassSpec mass = read_mass(in);
  const bool collide = in.boolean("collide", false);

  const Shape shape = kind == Kind::sphere ? Shape(Sphere{size.minCoeff() / 2}) : Shape(Box{0.5 * size});
  const Vec3 across = (size.x() + gap) * Vec3::UnitX();
  const Vec3 down =
      upright ? Vec3(-(size.y() + gap) * Vec3::UnitY()) : Vec3((size.z() + gap) * Vec3::UnitZ());
  const auto first = static_cast<Index>(out.model.name.size());
  // Both factors are at most 4e6, so that no product overflows.
  out.reserve(grid.rows * grid.columns, in);
  out.reserve_joints(2 * grid.rows * grid.columns, in);
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    for (std::int64_t column = 0; column < grid.columns; ++column) {
      BodySpec body;
      body.name = fmt::format("{} {}.{}", prefix, row, column);
      body.shape = shape;
      body.mass = mass;
      body.fixed = grid.fixed(row, column);
      body.c = position +
               (static_cast<double>(column) - 0.5 * static_cast<double>(grid.columns - 1)) * across +
               (static_cast<double>(row) - 0.5 * static_cast<double>(grid.rows - 1)) * down;
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
    out.add_joint(std::move(joint), collide);
  };
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    for (std::int64_t column = 0; column < grid.columns; ++column) {
      const std::int64_t here = row * grid.columns + column;
      if (column + 1 < grid.columns) join(here, here + 1);
      if (row + 1 < grid.rows) join(here, here + grid.columns);
    }
  }
}

}  // namespace pabd
