// SPDX-License-Identifier: MIT
// See model_builder.h.
#include "sim/scene/model_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/joint/auto_kappa.h"
#include "sim/joint/sliding_end.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

MassProperties solid_mass(const BodySpec& body, const Node& place) {
  const double v = volume(body.shape);
  const double density = body.mass.mass ? *body.mass.mass / v : body.mass.density;
  MassProperties p = mass_properties(body.shape, density);
  if (body.J) p.J = *body.J;
  if (body.mass.mass) p.mass = *body.mass.mass;  // exactly what the file says, without the rounding of ρV
  if (!kMassRange.contains(p.mass)) {
    place.fail(fmt::format("the body {} has a mass of {} kg; expected {} to {}, change its size or density",
                           in_quotes(body.name), p.mass, kMassRange.lo, kMassRange.hi));
  }
  return p;
}

// Exact the first time; then so that many small lists cost no more than one long one.
std::size_t room_for(std::int64_t announced, std::size_t capacity) {
  const auto n = static_cast<std::size_t>(announced);
  return n <= capacity ? n : std::max(n, 2 * capacity);
}

}  // namespace

Index body_of(const Node& node, const BodyNames& names, const Model& model) {
  if (!node.value().is_string()) node.fail_expected("the name of a body");
  const std::string name = node.text(100);
  if (const auto it = names.find(name); it != names.end()) return it->second;
  std::vector<std::string_view> near;
  for (std::size_t i = 0; i < model.name.size() && i < 1000; ++i) near.push_back(model.name[i]);
  node.fail(fmt::format("there is no body {}{}", in_quotes(name), did_you_mean(name, near)));
}

void require_near(const std::string& name, const Vec3& c, const Node& place) {
  if (c.cwiseAbs().maxCoeff() <= kFarthest) return;
  place.fail(fmt::format("the body {} would be at [{}, {}, {}]; expected coordinates within {} m",
                         in_quotes(name), c.x(), c.y(), c.z(), kFarthest));
}

void ModelBuilder::reserve(std::int64_t count, const Node& place) {
  announced_ += count;
  if (announced_ > kMostBodies) {
    place.fail(fmt::format("the scene would have {} bodies; expected at most {}", announced_, kMostBodies));
  }
  const std::size_t n = room_for(announced_, model.name.capacity());
  model.name.reserve(n);
  model.shape.reserve(n);
  model.mass.reserve(n);
  model.J.reserve(n);
  model.fixed.reserve(n);
  state.c.reserve(n);
  state.R.reserve(n);
  state.v.reserve(n);
  state.omega.reserve(n);
}

void ModelBuilder::add(BodySpec&& body, const Node& place) {
  require_near(body.name, body.c, place);
  const MassProperties p = body.fixed ? MassProperties{0, Mat3::Zero()} : solid_mass(body, place);
  if (body.look != BodyLook{}) looks.emplace(body.name, body.look);
  const std::size_t number = model.name.size();
  model.name.push_back(std::move(body.name));
  model.shape.push_back(body.shape);
  model.mass.push_back(p.mass);
  model.J.push_back(p.J);
  model.fixed.push_back(body.fixed ? 1 : 0);
  state.c.push_back(body.c);
  state.R.push_back(body.R);
  state.v.push_back(body.v);
  state.omega.push_back(body.omega);
  set_touch(number, body.touch, place);
  const auto give = [&](auto& own, auto& of_bodies) {
    if (!own) return;
    of_bodies.resize(number + 1);
    of_bodies[number] = std::move(own);
  };
  give(body.surface_velocity, model.surface_velocity);
  give(body.external, model.external);
}

int ModelBuilder::group_named(const std::string& name, const Node& place) {
  CollisionGroups& groups = model.groups;
  const auto at = std::find(groups.name.begin(), groups.name.end(), name) - groups.name.begin();
  if (at == std::ssize(groups.name)) {
    if (groups.name.size() == kMostGroups)
      place.fail(fmt::format("the group {} is one too many; expected at most {} groups", in_quotes(name),
                             kMostGroups));
    groups.name.push_back(name);
    groups.apart.push_back(0);
  }
  return static_cast<int>(at);
}

void ModelBuilder::set_touch(std::size_t first, const TouchSpec& touch, const Node& place) {
  const std::size_t n = model.name.size();
  const auto give = [&](const auto& own, auto& of_bodies) {
    if (!own) return;
    of_bodies.resize(n);
    std::fill(of_bodies.begin() + static_cast<std::ptrdiff_t>(first), of_bodies.end(), own);
  };
  give(touch.friction, model.friction);
  give(touch.restitution, model.restitution);
  if (touch.groups.empty()) return;
  std::uint64_t bits = 0;
  for (const std::string& name : touch.groups) bits |= std::uint64_t{1} << group_named(name, place);
  model.groups.of_body.resize(n);
  std::fill(model.groups.of_body.begin() + static_cast<std::ptrdiff_t>(first), model.groups.of_body.end(),
            bits);
}

BodyNames ModelBuilder::names(const ReadContext& context, std::size_t listed, std::size_t made) const {
  BodyNames seen;
  seen.reserve(model.name.size());
  for (std::size_t i = 0; i < model.name.size(); ++i) {
    const auto [first, fresh] = seen.emplace(model.name[i], static_cast<Index>(i));
    if (fresh) continue;
    const bool included = i >= made;
    fail_at(context,
            i < listed ? fmt::format("/bodies/{}/name", i)
            : included ? "/includes"
                       : "/generate",
            fmt::format("bodies {} and {} are both named {}; expected different names{}", first->second, i,
                        in_quotes(model.name[i]), included ? ", give another \"prefix\"" : ""));
  }
  return seen;
}

void ModelBuilder::reserve_joints(std::int64_t count, const Node& place) {
  announced_joints_ += count;
  if (announced_joints_ > kMostJoints) {
    place.fail(
        fmt::format("the scene would have {} joints; expected at most {}", announced_joints_, kMostJoints));
  }
  const std::size_t n = room_for(announced_joints_, model.joints.capacity());
  model.joints.reserve(n);
  model.no_collide.reserve(n);
}

void ModelBuilder::add_joint(Joint&& joint, bool collide) {
  joint.collide = collide;
  if (!collide && joint.i != kWorld && joint.j != kWorld)
    model.no_collide.emplace_back(std::minmax(joint.i, joint.j));
  model.joints.push_back(std::move(joint));
}

void ModelBuilder::keep_apart(Index i, Index j) {
  for (auto* pairs : {&model.no_collide, &model.stated_apart}) pairs->emplace_back(std::minmax(i, j));
}

void ModelBuilder::keep_groups_apart(int g, int h) {
  model.groups.apart[static_cast<std::size_t>(g)] |= std::uint64_t{1} << h;
  model.groups.apart[static_cast<std::size_t>(h)] |= std::uint64_t{1} << g;
}

void ModelBuilder::move_behind(std::size_t count) {
  auto& joints = model.joints;
  if (count >= joints.size()) return;
  std::rotate(joints.begin(), joints.begin() + static_cast<std::ptrdiff_t>(count), joints.end());
  const auto n = static_cast<Index>(joints.size()), moved = static_cast<Index>(count);
  for (Joint& joint : joints)
    if (joint.follows) joint.follows->leader = (joint.follows->leader + n - moved) % n;
}

void ModelBuilder::finish(const Vec3& gravity) {
  for (auto* pairs : {&model.no_collide, &model.stated_apart}) {
    if (!std::is_sorted(pairs->begin(), pairs->end())) std::sort(pairs->begin(), pairs->end());
    pairs->erase(std::unique(pairs->begin(), pairs->end()), pairs->end());
  }
  if (!model.friction.empty()) model.friction.resize(model.name.size());
  if (!model.restitution.empty()) model.restitution.resize(model.name.size());
  if (!model.surface_velocity.empty()) model.surface_velocity.resize(model.name.size());
  if (!model.external.empty()) model.external.resize(model.name.size());
  if (!model.groups.of_body.empty()) model.groups.of_body.resize(model.name.size());
  find_avoided(model.groups);

  settle_sliding_ends(model);
  const JointLoad load = joint_load(model, gravity);
  for (Joint& joint : model.joints) {
    if (joint.law.kappa != kAutoKappa) continue;
    joint.law.kappa = auto_joint_kappa(model, load, joint);
    joint.limit_scale = kLimitScale;
  }
  if (joint_law.kappa == kAutoKappa) joint_law.kappa = auto_joint_kappa(load, joint_law);
}

}  // namespace pabd
