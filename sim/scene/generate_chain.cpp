// SPDX-License-Identifier: MIT
// Generator of a chain: links one behind the other along a line, each joined to the next. See generators.h.
#include <fmt/format.h>

#include "sim/body/shape_kind.h"
#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/generators.h"

namespace pabd {

namespace {

// A link that is size.x long and size.y thick.
Shape link_shape(const ObjectReader& in, const ShapeKind& kind, const Vec3& size) {
  const Shape link = generated_shape(kind, size, size.x(), {size.x(), size.y()});
  if (kind.rod && !(kind.sizes_of(link)[1] >= kSizeRange.lo)) {
    in.fail_key("size", fmt::format("a {} {} m long and {} m thick has no straight part; expected the first "
                                    "number above the second",
                                    kind.name, size.x(), size.y()));
  }
  return link;
}

// The link's length, y of a rod and x of others, comes to lie along the first column of F.
Mat3 orientation(const ShapeKind& kind, const Mat3& F) {
  if (!kind.rod) return F;
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

void generate(const spec::Chain& entry, const GeneratorContext& context) {
  const ObjectReader& in = context.in;
  ModelBuilder& out = context.out;
  const std::string& prefix = entry.name.empty() ? context.prefix : entry.name;
  const std::int64_t links = entry.links;
  const ShapeKind& kind = generated_kind(entry.shape);
  const Vec3 &size = *entry.size, &start = *entry.position, &direction = *entry.direction;
  const JointType type = *entry.joint;
  if (in.has("axis") && traits_of(type).axes == 0)
    in.fail_key("axis", "only hinges have an axis; set \"joint\": \"hinge\" or remove this key");

  const Mat3 along_chain = frame_about(direction);
  const Mat3 F = joint_frame(type, *entry.axis, std::nullopt);
  const Shape shape = link_shape(in, kind, size);
  const double pitch = size.x() + *entry.gap;
  const auto first = static_cast<Index>(out.model.name.size());
  out.reserve(links, in);
  out.reserve_joints(links + 1, in);
  for (std::int64_t k = 0; k < links; ++k) {
    BodySpec body;
    body.name = fmt::format("{} {}", prefix, k);
    body.shape = shape;
    body.mass = mass_of(entry);
    if (entry.end_mass && k + 1 == links) body.mass.mass = entry.end_mass;
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
    out.add_joint(std::move(joint), *entry.collide);
  };
  if (entry.fixed != "none") join(kWorld, first, 0);
  const auto last = static_cast<Index>(first + links - 1);
  for (Index i = first; i < last; ++i) join(i, i + 1, i + 1 - first);
  if (entry.fixed == "both") join(last, kWorld, links);
}

}  // namespace pabd
