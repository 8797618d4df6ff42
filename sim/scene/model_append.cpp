// SPDX-License-Identifier: MIT
// The bodies and joints of an included scene, moved, turned and renamed, behind those that are there. See
// model_builder.h.
#include <fmt/format.h>

#include <utility>

#include "sim/body/shape_kind.h"
#include "sim/scene/model_builder.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kLongestName = 100;

std::string prefixed(const Placement& placement, const std::string& name, const Node& place) {
  std::string out = placement.prefix + name;
  if (out.size() > kLongestName)
    place.fail(fmt::format("the name {} would have {} bytes; expected at most {}, shorten \"prefix\"",
                           in_quotes(out), out.size(), kLongestName));
  return out;
}

// In the world of the scene that includes.
JointFrame moved(const JointFrame& frame, const Placement& placement) {
  return {placement.position + placement.R * frame.r, placement.R * frame.F};
}

}  // namespace

// Where they come to be; kWorld for planes.
std::vector<Index> ModelBuilder::append_bodies(ModelBuilder& part, const Placement& placement,
                                               const Node& place) {
  const std::size_t n = part.model.name.size();
  std::vector<Index> to(n, kWorld);
  std::int64_t count = 0;
  for (const Shape& shape : part.model.shape) count += is_plane(shape) ? 0 : 1;
  if (count == 0) place.fail("it has no bodies but planes, which are left out; expected others");
  reserve(count, place);
  for (std::size_t i = 0; i < n; ++i) {
    if (is_plane(part.model.shape[i])) continue;
    to[i] = model.size();
    std::string name = prefixed(placement, part.model.name[i], place);
    const Vec3 c = placement.position + placement.R * part.state.c[i];
    require_near(name, c, place);
    if (const auto look = part.looks.find(part.model.name[i]); look != part.looks.end())
      looks.emplace(name, look->second);
    model.name.push_back(std::move(name));
    model.shape.push_back(part.model.shape[i]);
    model.mass.push_back(part.model.mass[i]);
    model.J.push_back(part.model.J[i]);
    model.fixed.push_back(part.model.fixed[i]);
    state.c.push_back(c);
    state.R.push_back(placement.R * part.state.R[i]);
    state.v.push_back(placement.R * part.state.v[i]);
    state.omega.push_back(placement.R * part.state.omega[i]);
  }
  const auto bring = [&](const auto& own, auto& of_bodies) {
    if (own.empty()) return;
    of_bodies.resize(model.name.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      if (to[i] != kWorld) of_bodies[static_cast<std::size_t>(to[i])] = own[i];
  };
  bring(part.model.friction, model.friction);
  bring(part.model.restitution, model.restitution);
  bring(part.model.surface_velocity, model.surface_velocity);
  const std::size_t before = model.external.size();
  bring(part.model.external, model.external);
  for (std::size_t i = before; i < model.external.size(); ++i)
    if (model.external[i]) turn(placement.R, *model.external[i]);
  return to;
}

void ModelBuilder::append_groups(const CollisionGroups& groups, const std::vector<Index>& to,
                                 const Placement& placement, const Node& place) {
  if (groups.name.empty()) return;
  std::vector<int> here;
  for (const std::string& name : groups.name)
    here.push_back(group_named(prefixed(placement, name, place), place));
  const auto moved_bits = [&](std::uint64_t bits) {
    std::uint64_t out = 0;
    for (std::size_t g = 0; g < here.size(); ++g)
      if ((bits >> g & 1) != 0) out |= std::uint64_t{1} << here[g];
    return out;
  };
  for (std::size_t g = 0; g < here.size(); ++g)
    model.groups.apart[static_cast<std::size_t>(here[g])] |= moved_bits(groups.apart[g]);
  model.groups.of_body.resize(model.name.size());
  for (std::size_t i = 0; i < groups.of_body.size(); ++i)
    if (to[i] != kWorld)
      model.groups.of_body[static_cast<std::size_t>(to[i])] = moved_bits(groups.of_body[i]);
}

void ModelBuilder::append_joints(ModelBuilder& part, const std::vector<Index>& to, const Placement& placement,
                                 const Node& place) {
  const auto here = [&](Index i) { return i == kWorld ? kWorld : to[static_cast<std::size_t>(i)]; };
  reserve_joints(std::ssize(part.model.joints), place);
  const auto before = static_cast<Index>(model.joints.size());
  for (Joint& joint : part.model.joints) {
    if (joint.follows) joint.follows->leader += before;
    joint.i = here(joint.i);
    joint.j = here(joint.j);
    if (joint.i == kWorld) joint.on_i = moved(joint.on_i, placement);
    if (joint.j == kWorld) joint.on_j = moved(joint.on_j, placement);
    if (!joint.name.empty()) {
      joint.name = prefixed(placement, joint.name, place);
      if (!included_joints.insert(joint.name).second)
        place.fail(
            fmt::format("a joint {} is there already; give another \"prefix\"", in_quotes(joint.name)));
    }
    model.joints.push_back(std::move(joint));
  }
  for (auto pairs : {&Model::no_collide, &Model::stated_apart})
    for (const auto& [i, j] : part.model.*pairs)
      if (here(i) != kWorld && here(j) != kWorld) (model.*pairs).emplace_back(std::minmax(here(i), here(j)));
}

void ModelBuilder::append(ModelBuilder&& part, const Placement& placement, const Node& place) {
  const std::vector<Index> to = append_bodies(part, placement, place);
  append_groups(part.model.groups, to, placement, place);
  append_joints(part, to, placement, place);
}

}  // namespace pabd
