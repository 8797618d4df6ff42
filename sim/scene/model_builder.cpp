// SPDX-License-Identifier: MIT
// See model_builder.h.
#include "sim/scene/model_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/joint/auto_kappa.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

MassProperties solid_mass(const BodySpec& body, const Node& place) {
  const double v = volume(body.shape);
  const double density = body.mass.mass ? *body.mass.mass / v : body.mass.density;
  MassProperties p = mass_properties(body.shape, density);
  if (body.mass.mass) p.mass = *body.mass.mass;  // exactly what the file says, without the rounding of ρV
  if (!kMassRange.contains(p.mass)) {
    place.fail(fmt::format("the body {} has a mass of {} kg; expected {} to {}, change its size or density",
                           in_quotes(body.name), p.mass, kMassRange.lo, kMassRange.hi));
  }
  return p;
}

}  // namespace

MassSpec read_mass(const ObjectReader& in) {
  if (in.has("mass") && in.has("density")) {
    in.fail_key("mass", "a body has a mass or a density, not both; remove one of them");
  }
  MassSpec spec;
  spec.mass = in.optional_number("mass", kMassRange);
  if (!spec.mass) spec.density = in.number("density", kDensityRange, kDefaultDensity);
  return spec;
}

void ModelBuilder::reserve(std::int64_t count, const Node& place) {
  announced_ += count;
  if (announced_ > kMostBodies) {
    place.fail(fmt::format("the scene would have {} bodies; expected at most {}", announced_, kMostBodies));
  }
  const auto n = static_cast<std::size_t>(announced_);
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
  if (!(body.c.cwiseAbs().maxCoeff() <= kFarthest)) {
    place.fail(fmt::format("the body {} would be at [{}, {}, {}]; expected coordinates within {} m",
                           in_quotes(body.name), body.c.x(), body.c.y(), body.c.z(), kFarthest));
  }
  const MassProperties p = body.fixed ? MassProperties{0, Mat3::Zero()} : solid_mass(body, place);
  if (body.look != BodyLook{}) looks.emplace(body.name, body.look);
  model.name.push_back(std::move(body.name));
  model.shape.push_back(body.shape);
  model.mass.push_back(p.mass);
  model.J.push_back(p.J);
  model.fixed.push_back(body.fixed ? 1 : 0);
  state.c.push_back(body.c);
  state.R.push_back(body.R);
  state.v.push_back(body.v);
  state.omega.push_back(body.omega);
}

BodyNames ModelBuilder::names(const ReadContext& context, std::size_t listed) const {
  BodyNames seen;
  seen.reserve(model.name.size());
  for (std::size_t i = 0; i < model.name.size(); ++i) {
    const auto [first, fresh] = seen.emplace(model.name[i], static_cast<Index>(i));
    if (fresh) continue;
    fail_at(context, i < listed ? fmt::format("/bodies/{}/name", i) : "/generate",
            fmt::format("bodies {} and {} are both named {}; expected different names", first->second, i,
                        in_quotes(model.name[i])));
  }
  return seen;
}

void ModelBuilder::reserve_joints(std::int64_t count, const Node& place) {
  announced_joints_ += count;
  if (announced_joints_ > kMostJoints) {
    place.fail(
        fmt::format("the scene would have {} joints; expected at most {}", announced_joints_, kMostJoints));
  }
  const auto n = static_cast<std::size_t>(announced_joints_);
  model.joints.reserve(n);
  model.no_collide.reserve(n);
}

void ModelBuilder::add_joint(Joint&& joint, bool collide) {
  if (!collide && joint.i != kWorld && joint.j != kWorld) {
    model.no_collide.emplace_back(std::minmax(joint.i, joint.j));
  }
  model.joints.push_back(std::move(joint));
}

void ModelBuilder::finish_joints(const Vec3& gravity, std::size_t generated) {
  auto& pairs = model.no_collide;
  if (!std::is_sorted(pairs.begin(), pairs.end())) std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  auto& joints = model.joints;
  if (generated < joints.size()) {
    std::rotate(joints.begin(), joints.begin() + static_cast<std::ptrdiff_t>(generated), joints.end());
  }
  const JointLoad load = joint_load(model, gravity);
  for (Joint& joint : joints) {
    if (joint.law.kappa != kAutoKappa) continue;
    joint.law.kappa = auto_joint_kappa(model, load, joint);
    joint.limit_scale = kLimitScale;
  }
  if (joint_law.kappa == kAutoKappa) joint_law.kappa = auto_joint_kappa(load, joint_law);
}

}  // namespace pabd
