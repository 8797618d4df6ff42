// SPDX-License-Identifier: MIT
// See scene_text.h. Here z becomes y: (x, y, z) of the robot is (x, z, −y) of the scene.
#include "sim/import/scene_text.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/joint/attach.h"
#include "sim/scene/fields.h"

namespace pabd {
namespace {

constexpr double kMostTurn = 180;  // degrees: what limits of a hinge can say
constexpr double kMostWay = 1e6;   // m: the same of a slider
constexpr double kRounded = 0.01;  // degrees: 3.1416 is half a turn
constexpr double kRecovery = 0.1;  // m/s: what a file puts into each other comes apart without a leap
constexpr double kDead = 1;        // κ h²/(m d̂²) that leaves a tenth of the speed of a hit
constexpr double kCarried = 10;    // κ/(m g d̂) that carries a robot well inside of d̂

Mat3 upright() {
  Mat3 W;
  W << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return W;
}

// From the z axis of a robot's round geoms to the y axis of a scene's.
Mat3 y_to_z() {
  Mat3 Q;
  Q << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return Q;
}

// Zeros that are not quite are no information.
Vec3 clean(const Vec3& v, double scale) {
  return v.unaryExpr([scale](double x) { return std::abs(x) < 1e-15 * scale ? 0.0 : x; });
}

// Its matter is spread evenly: the centre of mass of hulls is where they are made to have it.
Vec3 centroid_of(const std::vector<std::vector<Vec3>>& parts) {
  std::vector<Hull> hulls;
  for (const auto& part : parts)
    if (HullResult result = make_hull(part); result.hull) hulls.push_back(Hull{std::move(result.hull)});
  return hulls.empty() ? Vec3::Zero() : make_compound(hulls).data->centroid;
}

struct Placed {
  OrderedJson shape;
  Vec3 c;
  Mat3 R;
  Mat3 I;
};

Placed place(const BodyPlan& body) {
  const Vec3& s = body.size;
  Placed out{OrderedJson::object(), body.c, body.R, body.I};
  switch (body.kind) {
    case GeomKind::box:
      out.shape = {{"type", "box"}, {"size", {2 * s.x(), 2 * s.y(), 2 * s.z()}}};
      return out;
    case GeomKind::sphere:
      out.shape = {{"type", "sphere"}, {"radius", s.x()}};
      return out;
    case GeomKind::capsule:
      out.shape = {{"type", "capsule"}, {"radius", s.x()}, {"length", 2 * s.y()}};
      break;
    case GeomKind::cylinder:
      out.shape = {{"type", "cylinder"}, {"radius", s.x()}, {"height", 2 * s.y()}};
      break;
    default: {
      const Vec3 shift = body.fixed ? centroid_of(body.parts) : Vec3::Zero();
      out.c += body.R * shift;
      OrderedJson parts = OrderedJson::array();
      for (const auto& part : body.parts) {
        OrderedJson corners = OrderedJson::array();
        for (const Vec3& corner : part) corners.push_back(json_of(Vec3(corner - shift)));
        parts.push_back(std::move(corners));
      }
      out.shape = {{"type", "mesh"}, {"parts", std::move(parts)}};
      return out;
    }
  }
  out.R = body.R * y_to_z();
  out.I = y_to_z().transpose() * body.I * y_to_z();
  return out;
}

// What a scene may say.
SurfaceFriction in_range(const SurfaceFriction& friction) {
  constexpr SurfaceFriction kMost{100, 100, 1e3, 1e3};
  return combined(FrictionRule::min, friction, kMost);
}

// The largest friction of a body that touches. Pairs have the larger one of two in MuJoCo.
std::optional<SurfaceFriction> largest_friction(const ScenePlan& plan) {
  std::optional<SurfaceFriction> most;
  for (const BodyPlan& body : plan.bodies)
    if (!body.ghost && body.friction)
      most = combined(FrictionRule::max, most.value_or(SurfaceFriction{0, 0}), in_range(*body.friction));
  return most;
}

OrderedJson with_shape(const spec::Body& body, const OrderedJson& shape) {
  OrderedJson out = json_of_entry(body);
  out["shape"] = shape;
  return out;
}

// `friction` is what the scene says for all; gravity with z up.
OrderedJson json_of_body(const BodyPlan& body, const std::optional<SurfaceFriction>& friction,
                         const Vec3& gravity) {
  spec::Body out{.name = body.name, .fixed = body.fixed};
  if (!body.ghost && body.friction && in_range(*body.friction) != *friction)
    out.friction = in_range(*body.friction);
  const Mat3 W = upright();
  if (body.kind == GeomKind::plane) {
    out.fixed = false;  // as it always is
    const Vec3 n = W * body.R.col(2);
    return with_shape(out,
                      {{"type", "plane"}, {"normal", json_of(clean(n, 1))}, {"offset", n.dot(W * body.c)}});
  }
  const Placed placed = place(body);
  if (!body.fixed) {
    out.mass = body.mass;
    const Mat3& I = placed.I;
    if (!body.even) out.inertia = {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
  }
  out.position = clean(W * placed.c, std::max(placed.c.norm(), 1e-3));
  if (!body.centre.isZero(0)) {
    out.position = W * (body.c + body.R * body.centre);
    out.center_of_mass = -(placed.R.transpose() * (body.R * body.centre));
  }
  out.orientation = orientation_of(W * placed.R);
  if (body.lifted != 0) out.force = Keyed<Vec3>{{{0, clean(W * (-body.lifted * gravity), 1)}}};
  if (body.color) out.color = spec::Color{*body.color};
  if (body.hidden) out.material = spec::Material{.opacity = 0};
  return with_shape(out, placed.shape);
}

// A hinge's limits are within half a turn of 0.
void add_range(const JointPlan& joint, double unit, spec::Joint& out, ImportNotes& notes) {
  if (!joint.range) return;
  double lo = joint.range->first / unit, hi = joint.range->second / unit;
  if (joint.kind == RobotJointKind::hinge) {
    if (lo < -kMostTurn - kRounded || hi > kMostTurn + kRounded || hi - lo >= 2 * (kMostTurn - kRounded))
      return notes.add("range of a joint goes beyond ±180°: not held", joint.place.file, joint.place.line);
    lo = std::max(lo, -kMostTurn);
    hi = std::min(hi, kMostTurn);
  } else if (lo < -kMostWay && hi > kMostWay) {
    return notes.add("range of a joint goes beyond 1000 km: not held", joint.place.file, joint.place.line);
  } else {
    lo = std::clamp(lo, -kMostWay, kMostWay);
    hi = std::clamp(hi, -kMostWay, kMostWay);
  }
  out.limits = {lo, hi};
}

// `unit` of the joint's angle or offset.
void add_action(const JointPlan& joint, double unit, spec::Joint& out, ImportNotes& notes) {
  const RobotAction& action = joint.action;
  if (!action.any()) return;
  if (joint.target) {
    notes.add("damping, friction, spring and motor of a joint that is held: not taken", joint.place.file,
              joint.place.line);
    return;
  }
  const bool slides = joint.kind == RobotJointKind::slide;
  if (action.force)
    out.motor = spec::Motor{.force = Profile{{{0, *action.force}}}};
  else if (action.speed)
    out.motor =
        spec::Motor{.speed = Profile{{{0, *action.speed / unit}}}, .most = action.most, .gain = action.gain};
  if (action.damping > 0) out.damping = action.damping;
  if (action.friction > 0) out.friction = action.friction;
  if (action.stiffness == 0) return;
  const double rest = action.rest / unit;
  if (!slides && std::abs(rest) > kMostTurn)
    return notes.add("spring of a joint rests beyond ±180°: not taken", joint.place.file, joint.place.line);
  out.spring = {action.stiffness, rest};
}

spec::Joint entry_of(const JointPlan& joint, const ScenePlan& plan, ImportNotes& notes) {
  const Mat3 W = upright();
  const auto body = [&](int k) {
    return k == kNoBody ? std::string() : plan.bodies[static_cast<std::size_t>(k)].name;
  };
  const bool hinge = joint.kind == RobotJointKind::hinge, ball = joint.kind == RobotJointKind::ball;
  spec::Joint out{.type = joint.weld ? JointType::fixed
                          : ball     ? JointType::spherical
                          : hinge    ? JointType::hinge
                                     : JointType::slider,
                  .i = body(joint.i),
                  .j = body(joint.j),
                  .name = joint.name};
  const Vec3 anchor = W * joint.anchor, axis = W * joint.axis;
  if (joint.arm > 0 && (joint.weld || !ball)) out.arm = joint.arm;
  if (joint.weld || ball) {
    out.anchor = clean(anchor, 1);
    add_action(joint, 1, out, notes);
    return out;
  }
  const double unit = hinge ? kDegree : 1;
  if (joint.start == 0) {
    out.anchor = clean(anchor, 1);
    out.axis = clean(axis, 1);
  } else {
    const Mat3 F = frame_about(axis);
    const Mat3 back =
        hinge ? Eigen::AngleAxisd(-joint.start, axis).toRotationMatrix() : Mat3(Mat3::Identity());
    const Vec3 from = hinge ? anchor : Vec3(anchor - joint.start * axis);
    out.anchors = {clean(from, 1), clean(anchor, 1)};
    out.frames = {orientation_of(back * F), orientation_of(F)};
  }
  if (joint.target) {
    const double target = *joint.target / unit, start = joint.start / unit;
    out.drive = target == start ? Profile{{{0, target}}} : Profile{{{0, start}, {0.5, target}}};
  } else {
    add_range(joint, unit, out, notes);
  }
  add_action(joint, unit, out, notes);
  if (const auto& follow = joint.follows)
    out.follows = {plan.joints[static_cast<std::size_t>(follow->leader)].name, follow->ratio,
                   follow->offset / unit};
  return out;
}

// Robots hardly bounce in other engines: as stiff as that takes (sim/accuracy.md), no stiffer, for the sake of friction,
// and at least what carries them. The legs of a robot weigh less than all of it, and bounce less. To three digits.
OrderedJson stiffness(const ScenePlan& plan, const SceneWords& words, double d_hat) {
  const double dead = kDead * std::pow(d_hat / words.time_step, 2);
  const double carried = kCarried * words.gravity.norm() * d_hat;
  const double kappa = plan.heaviest * std::max(dead, carried);
  return OrderedJson::parse(fmt::format("{:.3g}", std::clamp(kappa, 1e-12, 1e18)));
}

}  // namespace

std::string scene_text(const ScenePlan& plan, const SceneWords& words, ImportNotes& notes) {
  const double d_hat = plan.smallest > 0 ? std::clamp(0.05 * plan.smallest, 1e-4, 0.01) : 0.01;
  OrderedJson contact{{"d_hat", d_hat}};
  if (plan.heaviest > 0) contact["kappa"] = stiffness(plan, words, d_hat);
  contact["recovery_speed"] = kRecovery;
  const std::optional<SurfaceFriction> friction = largest_friction(plan);
  if (friction) contact["friction"] = json_of(*friction);
  std::vector<OrderedJson> bodies;
  if (words.ground) {
    OrderedJson plane{{"type", "plane"}, {"normal", {0, 1, 0}}, {"offset", plan.lowest - d_hat}};
    bodies.push_back({{"name", kGroundName}, {"shape", std::move(plane)}});
  }
  for (const BodyPlan& body : plan.bodies) bodies.push_back(json_of_body(body, friction, words.gravity));
  const auto has_own = [](const OrderedJson& body) { return body.contains("friction"); };
  if (std::any_of(bodies.begin(), bodies.end(), has_own)) contact["friction_rule"] = "max";
  std::vector<OrderedJson> joints;
  for (const JointPlan& joint : plan.joints) joints.push_back(json_of_entry(entry_of(joint, plan, notes)));
  std::vector<OrderedJson> apart;
  for (const auto& [a, b] : plan.apart)
    apart.push_back(OrderedJson::array(
        {plan.bodies[static_cast<std::size_t>(a)].name, plan.bodies[static_cast<std::size_t>(b)].name}));
  if (words.ground) {
    for (const BodyPlan& body : plan.bodies)
      if (body.ghost) apart.push_back(OrderedJson::array({kGroundName, body.name}));
  }

  std::string out = fmt::format(
      "{{\n  \"format\": \"pabd-scene\",\n  \"version\": 1,\n  \"name\": {},\n  \"description\": {},\n"
      "  \"gravity\": {},\n  \"time_step\": {},\n  \"contact\": {}",
      OrderedJson(words.name).dump(), OrderedJson(words.description()).dump(),
      json_of(clean(upright() * words.gravity, 1)).dump(), OrderedJson(words.time_step).dump(),
      contact.dump());
  out += list_text("bodies", bodies) + list_text("joints", joints) + list_text("no_collide", apart);
  return out + "\n}\n";
}

}  // namespace pabd
