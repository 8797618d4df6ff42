// SPDX-License-Identifier: MIT
#include "sim/joint/action.h"

#include <algorithm>
#include <cmath>

#include "sim/math/so3.h"

namespace pabd {
namespace {

using HoldState = ActionHold::State;

constexpr int kMostChanges = 8;  // of a hold in a step

// P at u as its state has it.
BondSlope slope_of(const ActionHold& hold, double u) {
  const double k = hold.stiffness, f = hold.most;
  if (hold.state == HoldState::gives_way_up) return {f * u, f, 0};
  if (hold.state == HoldState::gives_way_down) return {-f * u, -f, 0};
  if (hold.state == HoldState::holds || k * std::abs(u) <= f) return {0.5 * k * u * u, k * u, k};
  // The parabola through both ends of the corner that is nowhere below it.
  return {f * (std::abs(u) - 0.5 * f / k), std::copysign(f, u), f / std::abs(u)};
}

// A table may fall: W'' is then no weight, and 0 does.
BondSlope spring_slope(double stiffness, const ForceTable* table, double x) {
  if (!table) return {0.5 * stiffness * x * x, stiffness * x, stiffness};
  const ForceTable::Value at = table->at(x);
  return {at.energy, at.force, std::max(0.0, at.slope)};
}

const ForceTable* table_of(const JointSpring& spring) {
  return spring.table.points.empty() ? nullptr : &spring.table;
}

// W without the ball's damper.
BondSlope slope_of(const ActionStep& action, double way) {
  const double beside = way - action.coasts;
  BondSlope sum{-action.force * way + 0.5 * action.damping * beside * beside,
                -action.force + action.damping * beside, action.damping};
  const BondSlope spring = spring_slope(action.spring, action.table, action.away + way);
  sum.value += spring.value;
  sum.first += spring.first;
  sum.second += spring.second;
  for (const ActionHold& hold : action.hold) {
    if (hold.most == 0) continue;
    const BondSlope part = slope_of(hold, way - hold.way);
    sum.value += part.value;
    sum.first += part.first;
    sum.second += part.second;
  }
  return sum;
}

// The angle, offset or length that W is about; null: the turn of a ball.
const JointMeasure* measure_of(const Joint& joint) {
  const JointTraits& traits = traits_of(joint.type);
  return traits.points ? &traits.measures.front() : moved_measure(traits);
}

Mat3 turn_of(const PlacedFrames& at) { return at.i.F.transpose() * at.j.F; }

// Of a ball: the rotation vector of j against i since it stood so; world, rad.
Vec3 turn_since(const Mat3& turned, const PlacedFrames& at) {
  return at.i.F * log_so3(turn_of(at) * turned.transpose());
}

// Δ.
double way_of(const JointMeasure& measure, const ActionStep& action, const PlacedFrames& at) {
  return way_from(measure, action.start, action.expected, at);
}

// From the spring's rest.
double way_from_rest(const JointMeasure& measure, const JointSpring& spring, const PlacedFrames& at) {
  const double way = measure.value(at.i, at.j) - spring.rest;
  return measure.of == JointMeasure::Of::angle ? std::remainder(way, 2 * kPi) : way;
}

// ∂φ/∂y of a point of j at e from the axis: φ turns with t · δe.
Vec3 way_of_angle(const PlacedFrames& at, const Vec3& e) {
  const double x = e.dot(at.i.F.col(1)), y = e.dot(at.i.F.col(2));
  return (x * at.i.F.col(2) - y * at.i.F.col(1)) / (x * x + y * y);
}

// A bond along `t`.
PointBondForce along(const Vec3& t, double energy, double first, double second) {
  return {energy, first * t, second * t * t.transpose(), second, 0};
}

// A torque about the axis is a pair of forces at ± arm beside it, along the way that j's points go with φ.
void add_torque(const Joint& joint, const BondSlope& w, const PlacedFrames& at, BondList& out) {
  const Vec3 e = at.j.F.col(1), t = way_of_angle(at, e);
  const double a = joint.arm;
  for (const double side : {1.0, -1.0}) {
    const Vec3 point = at.j.y + side * a * e;
    PointBondForce force = along(side * t, 0.5 * w.value, w.first / (2 * a), w.second / (2 * a * a));
    force.largest *= t.squaredNorm();
    out.add_given(point, point, force);
  }
  // The two alone would also hold the anchors together along t, which costs nothing.
  out.add_given(at.j.y, at.j.y, {0, Vec3::Zero(), -w.second / (a * a) * t * t.transpose(), 0, 0});
}

// ∂λ/∂y_j = n, at the anchor of i for both.
void add_push(const BondSlope& w, const PlacedFrames& at, BondList& out) {
  out.add_given(at.i.y, at.i.y, along(at.j.F.col(0), w.value, w.first, w.second));
}

void add_pull(const BondSlope& w, const PlacedFrames& at, BondList& out) {
  const Vec3 e = at.j.y - at.i.y;
  const double length = e.norm();
  if (!(length > 0)) return;
  const Vec3 n = e / length;
  PointBondForce force = along(n, w.value, w.first, w.second);
  // A pull turns with the line, a push is no help across it (bond/point_bond.h).
  const double across = std::max(0.0, w.first / length);
  force.weight += across * (Mat3::Identity() - n * n.transpose());
  force.largest = std::max(force.largest, across);
  out.add_given(at.i.y, at.j.y, force);
}

// c/(2h′) ‖θ‖²: the torque −c θ/h′, as forces at the corners a e_k of a tetrahedron; Σ a e_k × 3 (M × e_k)/(8a) = M.
void add_ball_damper(const Joint& joint, const ActionStep& action, const PlacedFrames& at, BondList& out) {
  if (joint.turn) return;  // its turn is prescribed
  const Vec3 theta = turn_since(action.coasted, at), moment = action.damping * theta;
  const double a = joint.arm, weight = 3 * action.damping / (8 * a * a);
  constexpr int kCorners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& c : kCorners) {
    const Vec3 e = at.j.F * Vec3(c[0], c[1], c[2]) / std::sqrt(3.0), point = at.j.y + a * e;
    out.add_given(
        point, point,
        {moment.dot(theta) / 8, 3 * moment.cross(e) / (8 * a), weight * Mat3::Identity(), weight, 0});
  }
  // As for a torque.
  out.add_given(at.j.y, at.j.y, {0, Vec3::Zero(), -4 * weight * Mat3::Identity(), 0, 0});
}

// One that gives way does not turn round at once: it may be able to hold.
HoldState due_state(const ActionHold& hold, double u, double doubt) {
  const double corner = hold.most / hold.stiffness;
  switch (hold.state) {
    case HoldState::gives_way_up:
      return u + doubt < corner ? HoldState::holds : hold.state;
    case HoldState::gives_way_down:
      return doubt - u < corner ? HoldState::holds : hold.state;
    default:
      if (std::abs(u) - doubt <= corner) return hold.state;
      return u > 0 ? HoldState::gives_way_up : HoldState::gives_way_down;
  }
}

// What turns by 1 rad more than free flight: inertia withstands by sin(1) inertia/h² there, further on by less and less.
double way_in_reach(double way, double coming, double stiffness, const ActionStart& start) {
  const double reach = 1 + std::sin(1.0) * start.inertia / (start.h * start.h * stiffness);
  return coming + std::clamp(way - coming, -reach, reach);
}

// Most steps begin as the last one ended: what moves far past its corner gives way.
HoldState first_state(const ActionHold& hold, double coming) {
  constexpr double kFar = 1.5;
  const double u = coming - hold.way;
  if (hold.most == 0 || !(std::abs(u) > kFar * hold.most / hold.stiffness)) return HoldState::holds;
  return u > 0 ? HoldState::gives_way_up : HoldState::gives_way_down;
}

// h′.
double h_of_speed(const ActionStart& start) { return start.coasting ? start.coasting->h : start.h; }

// Without a gain it holds a place: what coasts would be held beside it.
ActionHold motor_hold(const JointMotor& motor, double stiffness, double coasts, const ActionStart& start) {
  const double speed = motor.profile.at(start.time);
  if (motor.gain == 0) return {.way = start.h * speed, .stiffness = stiffness, .most = motor.most};
  const double h = h_of_speed(start);
  return {.way = coasts + h * speed, .stiffness = motor.gain / h, .most = motor.most, .follows = true};
}

// Δ₀ of the measure, and where a ball turns at no speed.
double coasts(const JointMeasure& measure, const ActionStep& action, const Coasting& predicted) {
  return way_of(measure, action, predicted.at) -
         way_of_motion(measure.of, predicted.at, predicted.i, predicted.j);
}
Mat3 coasted(const Coasting& predicted) {
  const Vec3 turn = predicted.at.i.F.transpose() * (predicted.j.turn - predicted.i.turn);
  return exp_so3(-turn) * turn_of(predicted.at);
}

}  // namespace

double way_of_motion(JointMeasure::Of of, const PlacedFrames& at, const SmallMotion& i,
                     const SmallMotion& j) {
  switch (of) {
    case JointMeasure::Of::angle: {
      const Vec3 e = at.j.F.col(1);
      return e.cross(way_of_angle(at, e)).dot(j.turn - i.turn);
    }
    case JointMeasure::Of::offset:
      return at.j.F.col(0).dot(j.at(at.i.y) - i.at(at.i.y));
    case JointMeasure::Of::length: {
      const Vec3 e = at.j.y - at.i.y;
      const double length = e.norm();
      return length > 0 ? e.dot(j.at(at.j.y) - i.at(at.i.y)) / length : 0;
    }
  }
  return 0;
}

std::pair<Vec6, Vec6> gradient_of_way(JointMeasure::Of of, const PlacedFrames& at, const Vec3& c_i,
                                      const Vec3& c_j) {
  Vec6 i = Vec6::Zero(), j = Vec6::Zero();
  switch (of) {
    case JointMeasure::Of::angle: {
      const Vec3 e = at.j.F.col(1), axis = e.cross(way_of_angle(at, e));
      j.tail<3>() = axis;
      i.tail<3>() = -axis;
      break;
    }
    case JointMeasure::Of::offset: {
      const Vec3 n = at.j.F.col(0);
      j << n, (at.i.y - c_j).cross(n);
      i << -n, -(at.i.y - c_i).cross(n);
      break;
    }
    case JointMeasure::Of::length: {
      const Vec3 e = (at.j.y - at.i.y).normalized();
      j << e, (at.j.y - c_j).cross(e);
      i << -e, -(at.i.y - c_i).cross(e);
      break;
    }
  }
  return {i, j};
}

double way_from(const JointMeasure& measure, double start, double expected, const PlacedFrames& at) {
  const double way = measure.value(at.i, at.j) - start;
  if (measure.of != JointMeasure::Of::angle) return way;
  return expected + std::remainder(way - expected, 2 * kPi);
}

ActionStep start_action(const Joint& joint, const PlacedFrames& at, const ActionStart& start) {
  const JointAction& given = *joint.action;
  ActionStep action;
  action.damping = given.damping / h_of_speed(start);
  action.part = h_of_speed(start) / start.h;
  const JointMeasure* measure = measure_of(joint);
  if (!measure) {
    action.turned = turn_of(at);
    action.coasted = start.coasting ? coasted(*start.coasting) : action.turned;
    return action;
  }
  action.start = measure->value(at.i, at.j);
  action.spring = given.spring.stiffness;
  action.table = table_of(given.spring);
  if (given.spring.pulls()) action.away = way_from_rest(*measure, given.spring, at);
  const double coming = way_of_motion(measure->of, at, start.i, start.j);
  const bool turns = measure->of == JointMeasure::Of::angle;
  if (turns) action.expected = coming;
  if (start.coasting) action.coasts = coasts(*measure, action, *start.coasting);
  const double stiffness = start.stiffness * (turns ? 2 * joint.arm * joint.arm : 1);
  if (given.motor && given.motor->gives == JointMotor::Gives::force)
    action.force =
        given.motor->profile.at(start.coasting ? start.time : start.time - 0.5 * start.h);  // Euler: the mean
  else if (given.motor)
    action.hold[0] = motor_hold(*given.motor, stiffness, action.coasts, start);
  action.hold[1].stiffness = stiffness;
  action.hold[1].most = given.friction;
  for (ActionHold& hold : action.hold) {
    if (turns && hold.most > 0) hold.way = way_in_reach(hold.way, coming, hold.stiffness, start);
    hold.state = first_state(hold, coming);
  }
  return action;
}

void add_action(const Joint& joint, const ActionStep& action, const PlacedFrames& at, BondList& out) {
  const JointMeasure* measure = measure_of(joint);
  if (!measure) return add_ball_damper(joint, action, at, out);
  const BondSlope w = slope_of(action, way_of(*measure, action, at));
  switch (measure->of) {
    case JointMeasure::Of::angle:
      return add_torque(joint, w, at, out);
    case JointMeasure::Of::offset:
      return add_push(w, at, out);
    case JointMeasure::Of::length:
      return add_pull(w, at, out);
  }
}

double spring_energy(const Joint& joint, const PlacedFrames& at) {
  const JointMeasure* measure = measure_of(joint);
  if (!measure || !joint.action || !joint.action->spring.pulls()) return 0;
  const JointSpring& spring = joint.action->spring;
  return spring_slope(spring.stiffness, table_of(spring), way_from_rest(*measure, spring, at)).value;
}

double work_of_action(const Joint& joint, const ActionStep& action, const PlacedFrames& at) {
  const JointMeasure* measure = measure_of(joint);
  if (!measure) return -action.part * action.damping * turn_since(action.turned, at).squaredNorm();
  const double way = way_of(*measure, action, at);
  ActionStep lost = action;  // what the spring takes it gives back
  lost.spring = lost.coasts = 0;
  lost.table = nullptr;
  lost.damping *= action.part;
  for (ActionHold& hold : lost.hold)  // to u at the mean speed
    if (hold.follows) hold.way += (1 - action.part) * way - action.coasts;
  return -slope_of(lost, way).first * way;
}

void foresee_way(const Joint& joint, const PlacedFrames& at, const SmallMotion& i, const SmallMotion& j,
                 ActionStep& action) {
  const JointMeasure* measure = measure_of(joint);
  if (measure) action.ahead = way_of(*measure, action, at) + way_of_motion(measure->of, at, i, j);
}

bool settle_action(const Joint& joint, const PlacedFrames& at, double doubt, ActionStep& action) {
  const JointMeasure* measure = measure_of(joint);
  if (!measure) return true;
  if (action.ahead) doubt = 0;
  if (measure->of == JointMeasure::Of::angle) doubt /= joint.arm;
  const double way = action.ahead.value_or(way_of(*measure, action, at));
  bool settled = true;
  for (ActionHold& hold : action.hold) {
    if (hold.most == 0 || hold.state == HoldState::undecided) continue;
    const HoldState due = due_state(hold, way - hold.way, doubt);
    if (due == hold.state) continue;
    hold.state = ++hold.changes > kMostChanges ? HoldState::undecided : due;
    settled = false;
  }
  return settled;
}

}  // namespace pabd
