// SPDX-License-Identifier: MIT
// One entry of "joints" after the other. See read_joint.h.
#include "sim/scene/read_joint.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_set>

#include "sim/joint/attach.h"
#include "sim/joint/joint_traits.h"
#include "sim/potential/barrier.h"
#include "sim/scene/keys.h"
#include "sim/scene/read_rotation.h"
#include "sim/scene/start_pose.h"
#include "sim/scene/text.h"

namespace pabd {

namespace {

constexpr Range kTurnsRange{-1e6, 1e6, "degrees"};  // a drive may go round many times

constexpr Choice kPotentials[] = {{"soft", static_cast<int>(BondPotential::soft)},
                                  {"hard", static_cast<int>(BondPotential::hard)}};
constexpr Choice kTwists[] = {{"free", static_cast<int>(Twist::free)},
                              {"locked", static_cast<int>(Twist::locked)}};
constexpr Choice kArms[] = {{"x", 1}, {"y", 2}, {"z", 4}, {"xy", 3}, {"xz", 5}, {"yz", 6}, {"xyz", 7}};

BondLaw read_law(const ObjectReader& in, const BondLaw& defaults) {
  BondLaw law = defaults;
  law.potential =
      static_cast<BondPotential>(in.choice("potential", kPotentials, static_cast<int>(law.potential)));
  // A number for the other potential has another unit.
  if (law.potential != defaults.potential) law.kappa = kAutoKappa;
  if (const auto kappa = in.find("kappa")) {
    const Range range{1e-12, 1e18, law.potential == BondPotential::soft ? "N/m" : "J"};
    if (!kappa->is_word("auto") && !kappa->value().is_number())
      kappa->fail_expected(range.text() + " or \"auto\"");
    law.kappa = kappa->is_word("auto") ? kAutoKappa : kappa->number(range);
  }
  in.record("kappa", law.kappa);
  law.N = static_cast<int>(in.integer("N", 2, kMaxOrder, law.N));
  law.d_hat = in.number("d_hat", {1e-9, 1e3, "m"}, law.d_hat);
  return law;
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

Vec3 read_anchor(const ObjectReader& in) { return in.vec3("anchor", kPositionRange); }

Mat3 read_axes(const ObjectReader& in, JointType type) {
  const int axes = traits_of(type).axes;
  if (axes == 0) return Mat3::Identity();
  const Vec3 axis = in.require("axis", "the direction of the joint's axis").unit_vector();
  in.record("axis", axis);
  if (axes == 1) return frame_about(axis);
  const Node node = in.require("second_axis", "the direction of the joint's axis on the second body");
  const Vec3 second = node.unit_vector();
  in.record("second_axis", second);
  constexpr double kSquare = 1e-6;  // rad
  if (std::abs(axis.dot(second)) > kSquare) {
    node.fail(fmt::format("it is {:.6g} degrees from \"axis\"; expected 90",
                          std::acos(std::clamp(axis.dot(second), -1.0, 1.0)) / kDegree));
  }
  return joint_frame(type, axis, second);
}

// Both frames at one anchor and axis; or, in a scene that was saved in mid-run, each where it stands.
void read_place(const ObjectReader& in, const Surroundings& around, Joint& joint) {
  if (!in.has("anchors") && !in.has("frames")) {
    const Vec3 anchor = read_anchor(in);
    return attach(around.scene.state, anchor, read_axes(in, joint.type), joint);
  }
  for (const std::string_view key : {"anchor", "axis", "second_axis"})
    if (in.has(key))
      in.fail_key(key, "\"anchors\" and \"frames\" say it all; remove this key or both of those");
  const Node anchors = in.require("anchors", "two points [a, b]");
  const Node frames = in.require("frames", "two unit quaternions [w, x, y, z]");
  if (anchors.array_size() != 2) anchors.fail_expected("two points [a, b]");
  if (frames.array_size() != 2) frames.fail_expected("two unit quaternions [w, x, y, z]");
  for (const std::size_t end : {0, 1}) {
    const Vec3 anchor = anchors.element(end).vec3(kPositionRange);
    in.record("anchors", anchor);
    const Node frame = frames.element(end);
    const Mat3 F = read_rotation(frame, in, "frames");
    (end == 0 ? joint.on_i : joint.on_j) =
        frame_on(around.scene.state, end == 0 ? joint.i : joint.j, anchor, F);
  }
}

// A joint with frames of its own may stand anywhere, and says so by them.
std::optional<double> where_at_zero(const ObjectReader& in) {
  return in.has("frames") ? std::nullopt : std::optional(0.0);
}

// "start", in the unit of the file: where the joint is moved to, from where the bodies stand.
std::optional<double> read_start(const ObjectReader& in, const JointMeasure& measure) {
  if (!in.has("start")) return {};
  if (in.has("frames")) in.fail_key("start", "\"frames\" say where the joint stands; remove one of the two");
  const bool angle = measure.of == JointMeasure::Of::angle;
  return in.optional_number("start", angle ? kAngleRange : kPositionRange);
}

void read_arms(const ObjectReader& in, const Surroundings& around, Joint& joint) {
  joint.usual_arm = !in.has("arm");
  joint.arm = in.number("arm", kSizeRange, default_arm(around.scene.model, joint.i, joint.j));
  joint.symmetric = in.boolean("symmetric", true);
}

// Limits or a drive of what the joint leaves free. Returns where it starts, if it says so; rad or m.
std::optional<double> read_motion(const ObjectReader& in, const JointMeasure& measure, Joint& joint) {
  if (in.has("limits") && in.has("drive")) {
    in.fail_key("limits", "a driven joint has no limits; remove one of \"limits\" and \"drive\"");
  }
  const bool angle = measure.of == JointMeasure::Of::angle;
  const double unit = angle ? kDegree : 1;
  const std::optional<double> start = read_start(in, measure);
  if (in.has("limits")) {
    joint.limits = read_limits(in, "limits", angle ? kAngleRange : kPositionRange, unit,
                               start ? start : where_at_zero(in));
  }
  if (const auto node = in.find("drive"))
    joint.drive = read_drive(*node, angle ? kTurnsRange : kPositionRange, unit);
  return start ? std::optional(*start * unit) : std::nullopt;
}

void read_twist(const ObjectReader& in, Twist fallback, Joint& joint) {
  const auto twist = in.find("twist");
  if (twist && twist->value().is_object()) {
    const ObjectReader limited(*twist, keys::twist);
    joint.twist = Twist::limited;
    joint.twist_limits = read_limits(limited, "limits", kAngleRange, kDegree, where_at_zero(in));
  } else if (twist && !twist->value().is_string()) {
    twist->fail_expected("\"free\", \"locked\" or { \"limits\": [lowest, highest] }");
  } else {
    joint.twist = static_cast<Twist>(in.choice("twist", kTwists, static_cast<int>(fallback)));
  }
}

void read_prescribed_turn(const ObjectReader& in, Joint& joint) {
  if (const auto drive = in.find("drive")) {
    joint.turn = read_turn(*drive);
    joint.arms = static_cast<std::uint8_t>(in.choice("axes", kArms, 7));
  } else if (in.has("axes")) {
    in.fail_key("axes", "says which arms a drive holds, but there is none; add \"drive\" or remove this key");
  }
}

void read_points(const ObjectReader& in, const Surroundings& around, Joint& joint) {
  const Node points = in.require("points", "two points [a, b]");
  if (points.array_size() != 2) points.fail_expected("two points [a, b]");
  const Vec3 a = points.element(0).vec3(kPositionRange), b = points.element(1).vec3(kPositionRange);
  in.record("points", a);
  in.record("points", b);
  joint.on_i = frame_on(around.scene.state, joint.i, a, Mat3::Identity());
  joint.on_j = frame_on(around.scene.state, joint.j, b, Mat3::Identity());
  joint.length = in.number("length", {0, 1e6, "m"}, (b - a).norm());
}

// What the type of the joint asks for. Returns where it starts, if it says so; rad or m.
std::optional<double> read_by_traits(const ObjectReader& in, const Surroundings& around, Joint& joint) {
  const JointTraits& traits = traits_of(joint.type);
  if (traits.points) {
    read_points(in, around, joint);
  } else {
    read_place(in, around, joint);
    read_arms(in, around, joint);
  }
  std::optional<double> start;
  if (const JointMeasure* moved = moved_measure(traits)) start = read_motion(in, *moved, joint);
  joint.twist = traits.twist;
  if (measure_with(traits, &Joint::twist_limits)) read_twist(in, traits.twist, joint);
  if (traits.turn) read_prescribed_turn(in, joint);
  if (may_be_damped(traits)) read_action(in, joint);
  return start;
}

JointType read_type(const Node& node) {
  if (!node.value().is_object()) node.fail_expected("an object with a \"type\"");
  const auto type = node.value().find("type");
  if (type == node.value().end()) {
    std::vector<std::string_view> words;
    for (const Choice& choice : joint_choices()) words.push_back(choice.word);
    fail_at(node.context(), node.pointer() + "/type", "missing; expected " + one_of(words));
  }
  return static_cast<JointType>(Node(*type, node, "type").choice(joint_choices()));
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

std::span<const Choice> joint_choices() {
  static const auto kChoices = [] {
    std::array<Choice, kJointTypes.size()> choices;
    for (std::size_t k = 0; k < choices.size(); ++k)
      choices[k] = {to_string(kJointTypes[k]), static_cast<int>(kJointTypes[k])};
    return choices;
  }();
  return kChoices;
}

BondLaw read_joint_defaults(const ObjectReader& scene) {
  BondLaw law;
  law.kappa = kAutoKappa;
  return with_section(scene, "joints_default", keys::joints_default,
                      [&law](const ObjectReader& in) { return read_law(in, law); });
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
    const JointType type = read_type(node);
    const ObjectReader in(node, joint_keys(type));
    Joint joint;
    joint.type = type;
    in.record("type", to_string(type));
    joint.name = in.name("name");
    // Included ones may have had no name either.
    const bool named = !joint.name.empty();
    for (std::size_t n = k; !named && !seen.insert(joint.name = fmt::format("joint {}", n)).second;)
      n += count;
    if (named && !seen.insert(joint.name).second)
      in.fail_key("name", fmt::format("another joint is named {} too; expected different names",
                                      in_quotes(joint.name)));
    around.read_ends(in, joint);
    if (const auto start = read_by_traits(in, around, joint)) starts.push_back({generated + k, *start});
    if (in.has("follows") || in.has("lead")) coupled.push_back(k);
    joint.law = read_law(in, out.joint_law);
    out.add_joint(std::move(joint), in.boolean("collide", false));
  }
  if (!starts.empty()) move_bodies(starts, generated, *list, out);
  if (!coupled.empty()) read_couplings(*list, generated, coupled, out);
}

}  // namespace pabd
