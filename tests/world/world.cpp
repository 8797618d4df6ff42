// SPDX-License-Identifier: MIT
#include "tests/world/world.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/solver/step_summary.h"
#include "tests/support/hulls.h"

namespace pabd::world {

Setting::Setting(double h, double friction, double d_hat) : builder("world") {
  builder.params.h = h;
  builder.params.contact.mu_static = builder.params.contact.mu_dynamic = friction;
  builder.params.contact.d_hat = d_hat;
}

std::string Setting::add(spec::Body body) {
  if (body.name.empty()) body.name = "b" + std::to_string(bodies);
  ++bodies;
  builder.add(body);
  return body.name;
}

std::string Setting::add(const Shape& shape, double mass, const Vec3& at, const spec::Orientation& turn) {
  spec::Body body;
  body.shape = shape;
  body.fixed = mass == 0;
  if (mass > 0) body.mass = mass;
  body.position = at;
  body.orientation = turn;
  return add(body);
}

std::string Setting::add_hull(const std::vector<Vec3>& corners, double mass, const Vec3& origin) {
  const Hull hull = testing::hull_of(corners);
  return add(hull, mass, origin + hull.data->centroid);
}

std::string Setting::ground() { return slope(0); }

std::string Setting::slope(double degrees) {
  spec::Body body;
  body.shape = Plane{uphill_normal(degrees), 0};
  return add(body);
}

void Setting::join(JointType type, const std::string& i, const std::string& j, const Vec3& anchor,
                   const Vec3& axis) {
  spec::Joint joint{.type = type, .i = i, .j = j, .anchor = anchor};
  if (type != JointType::spherical && type != JointType::fixed) joint.axis = axis;
  builder.add(joint);
}

Vec3 downhill(double degrees) { return {std::cos(degrees * kDegree), -std::sin(degrees * kDegree), 0}; }
Vec3 uphill_normal(double degrees) { return {std::sin(degrees * kDegree), std::cos(degrees * kDegree), 0}; }

spec::Orientation about_z(double degrees) { return spec::AxisAngle{Vec3::UnitZ(), degrees}; }
spec::Orientation along_x() { return spec::AxisAngle{Vec3::UnitZ(), 90}; }
spec::Orientation along_z() { return spec::AxisAngle{Vec3::UnitX(), 90}; }

Run::Run(Scene of)
    : scene(std::move(of)),
      state(scene.initial),
      begin(kinetic() + potential_energy(scene.model, scene.params, state)) {}

void Run::go(double seconds, const std::function<void()>& each) {
  StepOptions options;
  options.report_contacts = options.report_joints = true;
  const auto end = steps + static_cast<int>(std::lround(seconds / scene.params.h));
  while (steps < end) {
    step(scene.model, scene.params, options, state, workspace_, report);
    REQUIRE(report.status != StepStatus::non_finite);
    work += report.drive_work;
    rise = std::max(rise, report.kinetic + report.potential + report.elastic - begin - work);
    joint_error = std::max(joint_error, report.max_joint_error);
    overlap = std::max(overlap, report.max_penetration);
    for (const Vec3& v : state.v) fastest = std::max(fastest, v.norm());
    held += report.held_bodies > 0 ? 1 : 0;
    halved += report.halved_bodies > 0 ? 1 : 0;
    ++steps;
    iterations += report.iterations;
    const bool limit = report.status != StepStatus::converged;
    at_limit += limit ? 1 : 0;
    unsolved += limit && !(report.residual <= 1e-3) ? 1 : 0;
    if (each) each();
  }
}

void Run::send(const std::string& name, const Vec3& v, const Vec3& omega) {
  const auto i = static_cast<std::size_t>((*this)[name]);
  state.v[i] = v;
  state.omega[i] = omega;
  begin = kinetic() + potential_energy(scene.model, scene.params, state) + report.elastic;
  work = rise = joint_error = overlap = fastest = 0;
  held = halved = steps = iterations = at_limit = unsolved = 0;
}

Index Run::operator[](const std::string& name) const {
  const auto& names = scene.model.name;
  const auto found = std::find(names.begin(), names.end(), name);
  REQUIRE(found != names.end());
  return static_cast<Index>(found - names.begin());
}

double Run::kinetic() const { return kinetic_energy(scene.model, state); }

double Run::weight() const {
  double mass = 0;
  for (const double m : scene.model.mass) mass += m;
  return mass * scene.params.gravity.norm();
}

Vec3 Run::momentum() const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < state.v.size(); ++i) sum += scene.model.mass[i] * state.v[i];
  return sum;
}

double Run::carried() const {
  double up = 0;
  const auto fixed = [&](Index i) { return scene.model.fixed[static_cast<std::size_t>(i)] != 0; };
  for (const ContactReport& contact : report.contact_reports) {
    const Vec3 on_b = contact.normal_force * contact.n + contact.friction;
    if (fixed(contact.a) && !fixed(contact.b)) up += on_b.y();
    if (fixed(contact.b) && !fixed(contact.a)) up -= on_b.y();
  }
  return up;
}

}  // namespace pabd::world
