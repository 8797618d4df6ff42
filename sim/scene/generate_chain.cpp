// SPDX-License-Identifier: MIT
// Generator of a chain: links one behind the other along a line, each joined to the next. See generators.h.
#include <fmt/format.h>

#include "sim/body/shape_kind.h"
#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/generators.h"

namespace pabd {

namespace {

enum class Ends { none, first, both };

constexpr Choice kChainJoints[] = {{"spherical", static_cast<int>(JointType::spherical)},
                                   {"hinge", static_cast<int>(JointType::hinge)},
                                   {"fixed", static_cast<int>(JointType::fixed)}};
constexpr Choice kEnds[] = {{"none", static_cast<int>(Ends::none)},
                            {"first", static_cast<int>(Ends::first)},
                            {"both", static_cast<int>(Ends::both)}};

// A link that is size.x long and size.y thick.
Shape link_shape(const ObjectReader& in, int kind, const Vec3& size) {
  const Shape link = generated_shape(kind, size, size.x(), {size.x(), size.y()});
  if (is_rod(kind) && !(kind_of(link).sizes_of(link)[1] >= kSizeRange.lo)) {
    in.fail_key("size", fmt::format("a {} {} m long and {} m thick has no straight part; expected the first "
                                    "number above the second",
                                    kind_of(link).name, size.x(), size.y()));
  }
  return link;
}

// The link's length, y of a rod and x of others, comes to lie along the first column of F.
Mat3 orientation(int kind, const Mat3& F) {
  if (!is_rod(kind)) return F;
  Mat3 R;
  R << -F.col(1), F.col(0), F.col(2);
  return R;
}

// From the centre of mass to the middle of the link's length, in the body frame.
Vec3 middle(const Shape& link) {
  const Aabb box = bounds(link, Vec3::Zero(), Mat3::Identity());
  return 0.5 * (box.lo + box.hi);
}

}  // namespace

void generate_chain(const ObjectReader& in, const GeneratorContext& context, ModelBuilder& out) {
  std::string prefix = in.name("name");
  if (prefix.empty()) prefix = context.default_prefix;
  const std::int64_t links = in.integer("links", 1, kMostBodies);
  static const std::vector<Choice> kinds = generated_shapes();
  const int kind = in.choice("shape", kinds, 0);
  const Vec3 size = in.vec3("size", kSizeRange, {1, 0.1, 0.1});
  const Vec3 start = in.vec3("position", kPositionRange, Vec3::Zero());
  const double gap = in.number("gap", {0, 1e3, "m"}, 0);
  const auto along = in.find("direction");
  const Vec3 direction = along ? along->unit_vector() : Vec3(Vec3::UnitX());
  in.record("direction", direction);
  const auto type =
      static_cast<JointType>(in.choice("joint", kChainJoints, static_cast<int>(JointType::spherical)));
  const auto axis_node = in.find("axis");
  if (axis_node && traits_of(type).axes == 0) {
    axis_node->fail("only hinges have an axis; set \"joint\": \"hinge\" or remove this key");
  }
  const Vec3 axis = axis_node ? axis_node->unit_vector() : Vec3(Vec3::UnitZ());
  in.record("axis", axis);
  const auto ends = static_cast<Ends>(in.choice("fixed", kEnds, static_cast<int>(Ends::first)));
  const MassSpec mass = read_mass(in);
  const std::optional<double> end_mass = in.optional_number("end_mass", kMassRange);
  const bool collide = in.boolean("collide", false);

  const Mat3 along_chain = frame_about(direction);
  const Mat3 F = joint_frame(type, axis, std::nullopt);
  const Shape shape = link_shape(in, kind, size);
  const double pitch = size.x() + gap;
  const auto first = static_cast<Index>(out.model.name.size());
  out.reserve(links, in);
  out.reserve_joints(links + 1, in);
  for (std::int64_t k = 0; k < links; ++k) {
    BodySpec body;
    body.name = fmt::format("{} {}", prefix, k);
    body.shape = shape;
    body.mass = mass;
    if (end_mass && k + 1 == links) body.mass.mass = end_mass;
    body.R = orientation(kind, along_chain);
    body.c = start + ((static_cast<double>(k) + 0.5) * pitch) * direction - body.R * middle(shape);
    out.add(std::move(body), in);
  }
  const auto join = [&](Index i, Index j, std::int64_t place) {
    Joint joint;
    joint.type = type;
    joint.i = i;
    joint.j = j;
    joint.arm = 0.5 * bounding_radius(shape);
    joint.law = out.joint_law;
    attach(out.state, start + (static_cast<double>(place) * pitch) * direction, F, joint);
    out.add_joint(std::move(joint), collide);
  };
  if (ends != Ends::none) join(kWorld, first, 0);
  const auto last = static_cast<Index>(first + links - 1);
  for (Index i = first; i < last; ++i) join(i, i + 1, i + 1 - first);
  if (ends == Ends::both) join(last, kWorld, links);
}

}  // namespace pabd
