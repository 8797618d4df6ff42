// SPDX-License-Identifier: MIT
// See inspector_rows.h.
//
//   f          force of a contact on body b: f_n n + friction; on a the opposite    N
//   f          force of a joint on body j: −Σ ∂Ψ/∂y_j over its bonds S(1, 2, 5)     N
//   angle      φ of j against i about the axis n                                    degrees
#include "app/gui/inspector_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/visual/joint_glyphs.h"
#include "sim/body/shape_kind.h"
#include "sim/bond/point_bond.h"
#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

constexpr double kDegrees = 180 / kPi;

std::string in_unit(double x, const char* unit = "") {
  return fmt::format("{:.4g}{}{}", std::abs(x) < 1e-14 ? 0.0 : x, *unit ? " " : "", unit);
}
// Tenths of a millimetre where they fit, without a sign on zero.
std::string part(double x, int digits) {
  const double step = std::pow(10, -digits);
  if (std::abs(x) < 0.5 * step) x = 0;
  return std::abs(x) < 1e4 ? fmt::format("{:.{}f}", x, digits) : fmt::format("{:.3g}", x);
}
std::string in_unit(const Vec3& v, const char* unit, int digits = 3) {
  return fmt::format("{}  {}  {}{}{}", part(v.x(), digits), part(v.y(), digits), part(v.z(), digits),
                     *unit ? " " : "", unit);
}
std::string force_text(const Vec3& f) {
  const double least = 1e-6 * f.norm();
  const auto shown = [least](double x) { return fmt::format("{:.3g}", std::abs(x) < least ? 0.0 : x); };
  return fmt::format("{}  {}  {} N", shown(f.x()), shown(f.y()), shown(f.z()));
}

struct OnBody {
  int contacts = 0;
  Vec3 force = Vec3::Zero();
};
OnBody contact_force(const RunView& run, Index body) {
  OnBody out;
  for (const ContactReport& c : run.report.contact_reports) {
    if (c.a != body && c.b != body) continue;
    ++out.contacts;
    out.force += (c.b == body ? 1.0 : -1.0) * (c.normal_force * c.n + c.friction);
  }
  return out;
}

void add_pose(const RunView& run, std::size_t i, InspectorRows& rows) {
  const State& s = *run.state;
  rows.push_back({"pose", ""});
  rows.push_back({"position", in_unit(s.c[i], "m", 4), "Of the centre of mass, in the world"});
  Quat q(s.R[i]);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  rows.push_back(
      {"q", fmt::format("{}  {}  {}  {}", part(q.w(), 4), part(q.x(), 4), part(q.y(), 4), part(q.z(), 4)),
       "Orientation, body to world, as a unit quaternion w x y z"});
  const Vec3 turn = log_so3(s.R[i]);
  const double angle = turn.norm();
  rows.push_back({"turned by", fmt::format("{}°", part(angle * kDegrees, 3)), "Angle of the same rotation"});
  if (angle > 1e-9) rows.push_back({"about", in_unit(turn / angle, "", 4), "Its axis, unit"});
}

void add_motion(const RunView& run, Index body, InspectorRows& rows) {
  const auto i = static_cast<std::size_t>(body);
  const State& s = *run.state;
  const double mass = run.model->mass[i];
  rows.push_back({"motion and energy", ""});
  rows.push_back({"speed", in_unit(s.v[i].norm(), "m/s")});
  rows.push_back({"velocity", in_unit(s.v[i], "m/s")});
  rows.push_back({"ω", in_unit(s.omega[i], "rad/s"), "Angular velocity, world"});
  rows.push_back(
      {"kinetic energy", in_unit(kinetic_energy(*run.model, body, s.R[i], s.v[i], s.omega[i]), "J")});
  rows.push_back({"potential energy", in_unit(-mass * run.params.gravity.dot(s.c[i]), "J"), "−m g·c"});
  if (!run.model->external.empty() && run.model->external[i]) {
    const ExternalForce& external = *run.model->external[i];
    if (external.force)
      rows.push_back({"external force", in_unit(external.force_at(s.time), "N"), "From outside, world"});
    if (external.torque)
      rows.push_back({"external torque", in_unit(external.torque_at(s.time), "N m"), "From outside, world"});
  }
  if (i < run.report.body_reports.size()) {
    rows.push_back({"contact energy", in_unit(run.report.body_reports[i].contact_energy, "J"),
                    "Half of the energy of each contact of this body"});
  }
}

void add_solver(const RunView& run, std::size_t i, InspectorRows& rows) {
  if (i >= run.report.body_reports.size()) return;
  const BodyReport& r = run.report.body_reports[i];
  rows.push_back({"solver", ""});
  rows.push_back(
      {"component",
       r.island < 0 ? "none: nothing touches it" : fmt::format("{}, by {}", r.island, to_string(r.solver)),
       "Bodies that hang together through contacts or joints are solved together"});
  rows.push_back({"residual", fmt::format("{:.2g} d̂", r.residual),
                  "Of its component: the largest way of a body in the last iteration"});
  rows.push_back(
      {"‖A − R‖", in_unit(r.projection_change),
       "How far the affine matrix of the last iteration was from the rotation it became; sissm only"});
  rows.push_back({"det A", fmt::format("{:.6f}", r.det_A), "1 for a rotation", !(r.det_A > 0)});
}

void add_action(const Joint& joint, InspectorRows& rows) {
  const bool turns = acts_by_torque(traits_of(joint.type));
  const JointAction& action = *joint.action;
  if (action.motor) {
    const bool speed = action.motor->gives == JointMotor::Gives::speed;
    rows.push_back({"motor", speed ? "holds a speed" : turns ? "gives a torque" : "gives a force"});
  }
  if (action.damping > 0) rows.push_back({"damping", in_unit(action.damping, turns ? "N m s/rad" : "N s/m")});
  if (action.friction > 0) rows.push_back({"friction", in_unit(action.friction, turns ? "N m" : "N")});
  const JointSpring& spring = action.spring;
  if (!spring.pulls()) return;
  if (spring.table.points.empty())
    rows.push_back({"spring", in_unit(spring.stiffness, turns ? "N m/rad" : "N/m")});
  else
    rows.push_back({"spring", fmt::format("by a table of {} points", spring.table.points.size())});
  rows.push_back(
      {"its rest", turns ? fmt::format("{:.3f}°", kDegrees * spring.rest) : in_unit(spring.rest, "m")});
}

void add_coupling(const Model& model, const Joint& joint, InspectorRows& rows) {
  const JointCoupling& coupling = *joint.follows;
  const Joint& leader = model.joints[static_cast<std::size_t>(coupling.leader)];
  if (&leader == &joint) {
    rows.push_back(
        {"lead", in_unit(2 * kPi * coupling.ratio, "m"), "How far it moves along its axis in a turn"});
    return;
  }
  rows.push_back({"follows", leader.name});
  rows.push_back({"its ratio", fmt::format("{:.6g}", coupling.ratio),
                  "Of what it moves to what the other does; rad and m"});
}

// What a joint measures and what keeps it in range.
void add_measures(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, InspectorRows& rows) {
  const JointTraits& traits = traits_of(joint.type);
  for (const JointMeasure& measure : traits.measures) {
    const double value = measure.value(fi, fj);
    rows.push_back({measure.words,
                    measure.of == JointMeasure::Of::angle ? fmt::format("{:.3f}°", kDegrees * value)
                                                          : in_unit(value, "m"),
                    measure.help ? measure.help : ""});
  }
  const auto add_limits = [&](const char* words, Rare<JointRange> Joint::*limits) {
    const JointMeasure* measure = measure_with(traits, limits);
    if (!measure || !(joint.*limits)) return;
    const bool angle = measure->of == JointMeasure::Of::angle;
    const double scale = angle ? kDegrees : 1;
    rows.push_back({words, fmt::format("{:.4g} … {:.4g}{}", (joint.*limits)->lo * scale,
                                       (joint.*limits)->hi * scale, angle ? "°" : " m")});
  };
  add_limits("limits", &Joint::limits);
  add_limits("angle limits", &Joint::twist_limits);
  if (joint.drive || joint.turn) rows.push_back({"drive", "follows its time profile"});
  if (joint.action) add_action(joint, rows);
  if (traits.points) rows.push_back({"rest length", in_unit(joint.length, "m")});
}

}  // namespace

std::string body_title(const Model& model, Index body) {
  if (body == kWorld) return "the world";
  const auto i = static_cast<std::size_t>(body);
  return model.name[i].empty() ? fmt::format("body {}", body) : model.name[i];
}

std::string joint_title(const Model& model, Index joint) {
  const Joint& k = model.joints[static_cast<std::size_t>(joint)];
  if (!k.name.empty()) return k.name;
  return fmt::format("{}: {} – {}", to_string(k.type), body_title(model, k.i), body_title(model, k.j));
}

InspectorRows body_rows(const RunView& run, Index body) {
  const auto i = static_cast<std::size_t>(body);
  const bool fixed = run.model->fixed[i] != 0;
  InspectorRows rows;
  rows.push_back({"number", std::to_string(body)});
  rows.push_back({"shape", text_of(run.model->shape[i])});
  rows.push_back({"mass", fixed ? "fixed: it never moves" : in_unit(run.model->mass[i], "kg")});
  if (const Plane* plane = std::get_if<Plane>(&run.model->shape[i])) {
    rows.push_back({"normal", in_unit(plane->normal, "")});
    rows.push_back({"offset", in_unit(plane->offset, "m")});
  } else {
    add_pose(run, i, rows);
  }
  if (!fixed) {
    add_motion(run, body, rows);
    add_solver(run, i, rows);
  }
  const OnBody on = contact_force(run, body);
  rows.push_back({"contacts", ""});
  rows.push_back({"number of contacts", std::to_string(on.contacts), "With d < d̂"});
  if (on.contacts > 0) {
    rows.push_back({"force", in_unit(on.force.norm(), "N"), "Size of the sum over its contacts"});
    rows.push_back({"as a vector", force_text(on.force)});
  }
  return rows;
}

InspectorRows joint_rows(const RunView& run, Index number) {
  const Model& model = *run.model;
  const Joint& joint = model.joints[static_cast<std::size_t>(number)];
  const Pose i = pose_of(*run.state, joint.i), j = pose_of(*run.state, joint.j);
  BondList bonds;
  expand(joint, i, j, run.state->time, bonds);
  double error = 0, energy = 0;
  Vec3 force = Vec3::Zero();
  for (int k = 0; k < bonds.count; ++k) {
    const PointBondForce f = evaluate(joint.law, bonds.bond[static_cast<std::size_t>(k)]);
    error = std::max(error, f.stretch);
    energy += f.energy;
    force -= f.gradient;
  }
  const bool soft = joint.law.potential == BondPotential::soft;
  InspectorRows rows;
  rows.push_back({"number", std::to_string(number)});
  rows.push_back({"type", to_string(joint.type)});
  rows.push_back({"i", body_title(model, joint.i)});
  rows.push_back({"j", body_title(model, joint.j)});
  rows.push_back(
      {"potential", soft ? "soft" : fmt::format("hard, N = {}, d̂ = {:.4g} m", joint.law.N, joint.law.d_hat)});
  rows.push_back({"κ", in_unit(joint.law.kappa, soft ? "N/m" : "J")});
  rows.push_back({"now", ""});
  rows.push_back({"error", in_unit(error, "m"), "Largest distance between two points that should meet"});
  add_measures(joint, place(joint.on_i, i), place(joint.on_j, j), rows);
  if (joint.follows) add_coupling(model, joint, rows);
  rows.push_back({"force", in_unit(force.norm(), "N"), "On j, summed over its bonds"});
  rows.push_back({"energy", in_unit(energy, "J")});
  return rows;
}

InspectorRows contact_rows(const RunView& run, Index number) {
  const ContactReport& c = run.report.contact_reports[static_cast<std::size_t>(number)];
  const double d_hat = run.params.contact.d_hat, friction = c.friction.norm();
  InspectorRows rows;
  rows.push_back({"a", body_title(*run.model, c.a), "Owns the normal"});
  rows.push_back({"b", body_title(*run.model, c.b)});
  rows.push_back({"gap", ""});
  rows.push_back({"d", in_unit(c.d, "m"), "Below 0 the two overlap", c.d < 0});
  rows.push_back({"d / d̂", fmt::format("{:.4f}", c.d / d_hat), "At 1 the barrier begins to push", c.d < 0});
  rows.push_back({"force", ""});
  rows.push_back({"normal force", in_unit(c.normal_force, "N"), "−Ψ'(d)"});
  rows.push_back({"friction force", in_unit(friction, "N")});
  if (c.normal_force > 0)
    rows.push_back({"friction / normal", fmt::format("{:.4f}", friction / c.normal_force), "At most μ"});
  rows.push_back({"state", c.sticking ? "sticks" : "slides"});
  rows.push_back({"place", ""});
  rows.push_back({"normal n", in_unit(c.n, "", 4), "Unit, from a to b"});
  rows.push_back({"point on a", in_unit(c.y_a, "m", 4)});
  rows.push_back({"point on b", in_unit(c.y_b, "m", 4)});
  return rows;
}

std::string force_text(double newton) {
  return newton >= 1000 ? fmt::format("{:.4g} kN", 1e-3 * newton) : fmt::format("{:.3g} N", newton);
}

std::string as_text(const std::string& title, const InspectorRows& rows) {
  std::string out = title + "\n";
  for (const InspectorRow& row : rows) out += row.name + (row.value.empty() ? "\n" : ": " + row.value + "\n");
  return out;
}

}  // namespace pabd
