// SPDX-License-Identifier: MIT
// One entry of "joints" after the other. See read_joint.h.
#include "sim/scene/read_joint.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_set>

#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/scene/fields.h"
#include "sim/scene/rotation.h"
#include "sim/scene/start_pose.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

BondLaw law_of(const spec::Law& law) {
  return {.potential = *law.potential, .N = *law.N, .kappa = *law.kappa, .d_hat = *law.d_hat};
}

// What the entry leaves out has the value of `defaults`.
void read_law(const FieldReader& fields, const BondLaw& defaults, spec::Law& law) {
  law = {defaults.potential, defaults.kappa, defaults.N, defaults.d_hat};
  law.potential_field(fields);
  // A number for the other potential has another unit.
  if (law.potential != defaults.potential) law.kappa = kAutoKappa;
  law.number_fields(fields);
}

// What reading a joint needs of the rest of the scene.
struct Surroundings {
  const BodyNames& names;
  const ModelBuilder& scene;

  bool movable(Index body) const {
    return body != kWorld && !scene.model.fixed[static_cast<std::size_t>(body)];
  }

  Index end(const Node& node) const {
    if (node.value().is_null()) return kWorld;
    if (!node.value().is_string()) node.fail_expected("the name of a body, or null for the world");
    return body_of(node, names, scene.model);
  }

  void read_ends(const ObjectReader& in, Joint& joint) const {
    const Node node = in.require("bodies", "two names of bodies, null for the world");
    if (node.array_size() != 2) node.fail_expected("two names of bodies, null for the world");
    joint.i = end(node.element(0));
    joint.j = end(node.element(1));
    if (joint.i == joint.j && joint.i != kWorld)
      node.fail("a body cannot be joined to itself; expected two different bodies");
    if (!movable(joint.i) && !movable(joint.j))
      node.fail("neither of the two can move; expected at least one movable body");
    in.record("bodies", static_cast<double>(joint.i));
    in.record("bodies", static_cast<double>(joint.j));
  }
};

// The keys of a joint; its ends are numbers of bodies.
struct JointFields : FieldReader {
  JointFields(const ObjectReader& in, const Surroundings& scene, Joint& made)
      : FieldReader(in), around(scene), joint(made) {}
  using FieldReader::operator();
  void operator()(const Field&, std::string&, std::string&) const { around.read_ends(in_, joint); }
  const Surroundings& around;
  Joint& joint;
};

Mat3 axes_of(const spec::Joint& entry, const ObjectReader& in) {
  const int axes = traits_of(entry.type).axes;
  if (axes == 0) return Mat3::Identity();
  if (!entry.axis) in.fail_key("axis", "missing; expected the direction of the joint's axis");
  if (axes == 1) return frame_about(*entry.axis);
  if (!entry.second_axis)
    in.fail_key("second_axis", "missing; expected the direction of the joint's axis on the second body");
  constexpr double kSquare = 1e-6;  // rad
  const double cosine = entry.axis->dot(*entry.second_axis);
  if (std::abs(cosine) > kSquare) {
    in.fail_key("second_axis", fmt::format("it is {:.6g} degrees from \"axis\"; expected 90",
                                           std::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree));
  }
  return joint_frame(entry.type, *entry.axis, entry.second_axis);
}

// Both frames at one anchor and axis; or, in a scene that was saved in mid-run, each where it stands.
void put_in_place(const spec::Joint& entry, const ObjectReader& in, const State& state, Joint& joint) {
  if (!in.has("anchors") && !in.has("frames")) {
    if (!entry.anchor) in.fail_key("anchor", "missing; expected an array of 3 numbers");
    return attach(state, *entry.anchor, axes_of(entry, in), joint);
  }
  for (const std::string_view key : {"anchor", "axis", "second_axis"})
    if (in.has(key))
      in.fail_key(key, "\"anchors\" and \"frames\" say it all; remove this key or both of those");
  if (entry.anchors.empty()) in.fail_key("anchors", "missing; expected two points [a, b]");
  if (entry.frames.empty()) in.fail_key("frames", "missing; expected two unit quaternions [w, x, y, z]");
  for (const std::size_t end : {0, 1}) {
    in.record("anchors", entry.anchors[end]);
    record_orientation(in, "frames", entry.frames[end]);
    (end == 0 ? joint.on_i : joint.on_j) =
        frame_on(state, end == 0 ? joint.i : joint.j, entry.anchors[end], rotation_of(entry.frames[end]));
  }
}

void put_points(spec::Joint& entry, const ObjectReader& in, const State& state, Joint& joint) {
  if (entry.points.empty()) in.fail_key("points", "missing; expected two points [a, b]");
  const Vec3 &a = entry.points[0], &b = entry.points[1];
  in.record("points", a);
  in.record("points", b);
  joint.on_i = frame_on(state, joint.i, a, Mat3::Identity());
  joint.on_j = frame_on(state, joint.j, b, Mat3::Identity());
  entry.length = (b - a).norm();
}

template <class Value>
Keyed<Value> in_si(const Keyed<Value>& profile, double unit) {
  Keyed<Value> out = profile;
  for (auto& [time, value] : out.keys) value = Value(value * unit);
  return out;
}

// Limits must include the place where the joint starts, where it is known; in the unit of the file.
JointRange range_of(const spec::Limits& limits, double unit, const std::optional<double>& stands_at,
                    const Node& place) {
  const auto [lo, hi] = limits;
  if (stands_at && (lo > *stands_at || hi < *stands_at))
    place.fail(
        fmt::format("the joint is at {0} at the start, outside {1} … {2}; expected limits that include {0}",
                    *stands_at, lo, hi));
  return {lo * unit, hi * unit};
}

JointMotor motor_of(const spec::Motor& entry, bool turns, const Node& node) {
  JointMotor motor;
  if (entry.force) {
    for (const char* key : {turns ? "max_torque" : "max_force", "gain"})
      if (node.value().contains(key))
        fail_at(node.context(), node.pointer() + '/' + key, "goes with \"speed\"; remove this key");
    motor.profile = *entry.force;
    return motor;
  }
  motor.gives = JointMotor::Gives::speed;
  motor.profile = in_si(*entry.speed, turns ? kDegree : 1);
  motor.most = entry.most.value_or(motor.most);
  motor.gain = entry.gain.value_or(motor.gain);
  return motor;
}

void set_action(const spec::Joint& entry, const ObjectReader& in, Joint& joint) {
  const bool turns = joint_keys(entry.type).torque;
  const double unit = turns ? kDegree : 1;
  for (const std::string_view key : {"motor", "damping", "friction", "spring"})
    if (in.has(key) && in.has("drive"))
      in.fail_key(
          key, fmt::format("a driven joint goes as its drive says; remove one of \"{}\" and \"drive\"", key));
  JointAction action;
  if (entry.motor) action.motor = motor_of(*entry.motor, turns, *in.find("motor"));
  action.damping = entry.damping.value_or(0);
  action.friction = entry.friction.value_or(0);
  if (entry.spring) {
    action.spring.stiffness = entry.spring->stiffness.value_or(0);
    action.spring.rest = unit * *entry.spring->rest;
    for (const auto& [x, force] : entry.spring->table)
      action.spring.table.points.emplace_back(unit * x, force);
  }
  if (action.motor || action.damping > 0 || action.friction > 0 || action.spring.pulls())
    joint.action = std::move(action);
}

std::uint8_t arms_of(std::string_view axes) {
  std::uint8_t bits = 0;
  for (const char axis : axes) bits = static_cast<std::uint8_t>(bits | 1 << (axis - 'x'));
  return bits;
}

// Limits, drives and what acts. A joint with frames of its own may stand anywhere, and says so by them.
void set_motion(const spec::Joint& entry, const ObjectReader& in, Joint& joint) {
  const JointKeys has = joint_keys(entry.type);
  const double unit = has.angle ? kDegree : 1;
  const bool anywhere = in.has("frames");
  if (has.moves && in.has("limits") && in.has("drive"))
    in.fail_key("limits", "a driven joint has no limits; remove one of \"limits\" and \"drive\"");
  if (entry.start && anywhere)
    in.fail_key("start", "\"frames\" say where the joint stands; remove one of the two");
  const std::optional<double> zero = anywhere ? std::nullopt : std::optional(0.0);
  if (entry.limits)
    joint.limits = range_of(*entry.limits, unit, entry.start ? entry.start : zero, *in.find("limits"));
  if (entry.drive) joint.drive = in_si(*entry.drive, unit);
  joint.twist = entry.twist.value_or(traits_of(entry.type).twist);
  if (entry.twist_limits) {
    const Node twist = *in.find("twist");
    joint.twist_limits =
        range_of(*entry.twist_limits, kDegree, zero, Node(twist.value().at("limits"), twist, "limits"));
  }
  if (entry.turn) {
    joint.turn = in_si(*entry.turn, kDegree);
    joint.arms = arms_of(entry.axes);
  } else if (in.has("axes")) {
    in.fail_key("axes", "says which arms a drive holds, but there is none; add \"drive\" or remove this key");
  }
  set_action(entry, in, joint);
}

// `list`: "joints", whose first is joint `generated` of the model.
void move_bodies(const std::vector<JointStart>& starts, std::size_t generated, const Node& list,
                 ModelBuilder& out) {
  if (const auto problem = move_to_start(out.model, starts, out.state)) {
    if (problem->joint < generated) list.fail(problem->what);
    list.element(problem->joint - generated).fail(problem->what);
  }
  for (const Vec3& c : out.state.c) {
    if (!(c.cwiseAbs().maxCoeff() <= kFarthest))
      list.fail(fmt::format("a start moves a body to [{}, {}, {}]; expected coordinates within {} m", c.x(),
                            c.y(), c.z(), kFarthest));
  }
}

}  // namespace

std::span<const std::string_view> joint_words() {
  static const auto kWords = [] {
    std::array<std::string_view, kJointTypes.size()> words;
    for (std::size_t k = 0; k < words.size(); ++k) words[k] = to_string(kJointTypes[k]);
    return words;
  }();
  return kWords;
}

BondLaw read_joint_defaults(const ObjectReader& scene) {
  static const auto kKeys = keys_of_entry(spec::Law{});
  return with_section(scene, "joints_default", kKeys, [](const ObjectReader& in) {
    BondLaw usual;
    usual.kappa = kAutoKappa;
    spec::Law law;
    read_law(FieldReader(in), usual, law);
    return law_of(law);
  });
}

void read_joints(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out) {
  const auto list = scene.find("joints");
  const std::size_t count = list ? list->array_size() : 0;
  scene.record("joints", static_cast<double>(count));
  if (count > 0) out.reserve_joints(static_cast<std::int64_t>(count), *list);
  const Surroundings around{names, out};
  std::unordered_set<std::string> seen = out.included_joints;
  std::vector<JointStart> starts;
  std::vector<std::size_t> coupled;
  const std::size_t generated = out.model.joints.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Node node = list->element(k);
    spec::Joint entry;
    entry.type = kJointTypes[type_of_entry(node, joint_words())];
    const ObjectReader in(node, keys_of_joint(entry.type));
    in.record("type", to_string(entry.type));
    Joint joint;
    joint.type = entry.type;
    const JointFields fields(in, around, joint);
    entry.place_fields(fields);
    joint.name = entry.name;
    // Included ones may have had no name either.
    const bool named = !joint.name.empty();
    for (std::size_t n = k; !named && !seen.insert(joint.name = fmt::format("joint {}", n)).second;)
      n += count;
    if (named && !seen.insert(joint.name).second)
      in.fail_key("name", fmt::format("another joint is named {} too; expected different names",
                                      in_quotes(joint.name)));
    if (traits_of(entry.type).points) {
      put_points(entry, in, out.state, joint);
    } else {
      put_in_place(entry, in, out.state, joint);
      joint.usual_arm = !in.has("arm");
      entry.arm = default_arm(out.model, joint.i, joint.j);
    }
    entry.motion_fields(fields);
    joint.length = entry.length.value_or(joint.length);
    joint.arm = entry.arm.value_or(joint.arm);
    joint.symmetric = entry.symmetric.value_or(true);
    set_motion(entry, in, joint);
    if (entry.start)
      starts.push_back({generated + k, *entry.start * (joint_keys(entry.type).angle ? kDegree : 1)});
    if (in.has("follows") || in.has("lead")) coupled.push_back(k);
    read_law(fields, out.joint_law, entry.law);
    joint.law = law_of(entry.law);
    fields(spec::kCollide, entry.collide, false);
    out.add_joint(std::move(joint), entry.collide);
  }
  if (!starts.empty()) move_bodies(starts, generated, *list, out);
  if (!coupled.empty()) read_couplings(*list, generated, coupled, out);
}

}  // namespace pabd
