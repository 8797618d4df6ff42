// SPDX-License-Identifier: MIT
// See mjcf_mechanics.h.
#include "sim/import/mjcf_mechanics.h"

#include <fmt/format.h>

#include <array>

#include "sim/import/taken.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

// Two springs along one joint.
void add_spring(RobotAction& action, double stiffness, double rest) {
  const double both = action.stiffness + stiffness;
  action.rest = (action.stiffness * action.rest + stiffness * rest) / both;
  action.stiffness = both;
}

// Parameters of a gain or a bias, 0 where they are not given.
std::array<double, 3> three(const MjcfElement& element, std::string_view attribute, double first) {
  std::array<double, 3> out{first, 0, 0};
  if (const auto given = element.with(attribute).numbers(attribute, 1, 10))
    std::copy_n(given->begin(), std::min(given->size(), out.size()), out.begin());
  return out;
}

}  // namespace

void MjcfMechanics::read(const std::string& section, const XmlElement& e) {
  const std::string kind = e.name();
  if (section == "contact" && kind == "exclude") {
    note_attributes(e, mjcf_rows(), notes_);
    robot_.excludes.emplace_back(body(e, "body1"), body(e, "body2"));
  } else if (section == "actuator" && (kind == "position" || kind == "general")) {
    read_servo(context_.defaults.of(e, ""));
  } else if (section == "actuator" && (kind == "motor" || kind == "velocity")) {
    read_motor(context_.defaults.of(e, ""));
  } else if (section == "equality" && (kind == "connect" || kind == "weld")) {
    read_loop(e);
  } else if (section == "equality" && kind == "joint") {
    read_follow(e);
  } else {
    note_element(e, mjcf_rows(), notes_);
  }
}

int MjcfMechanics::body(const XmlElement& e, std::string_view attribute) const {
  const std::string name = e.text(attribute);
  if (name == "world") return 0;
  const auto found = names_.bodies.find(name);
  if (found == names_.bodies.end()) e.fail_at(attribute, "there is no body " + in_quotes(name));
  return found->second;
}

// A force a + b length + c speed of a transmission whose length is gear times the joint's place: a spring and a damper.
void MjcfMechanics::read_servo(const MjcfElement& element) {
  const XmlElement& e = element.own();
  note_attributes(e, mjcf_rows(), notes_);
  RobotJoint* joint = joint_of(element);
  if (!joint) return;
  std::array<double, 3> gain{1, 0, 0}, bias{0, 0, 0};
  if (e.name() == "position") {
    const double kp = element.with("kp").number("kp").value_or(1);
    gain[0] = kp;
    bias = {0, -kp, -element.with("kv").number("kv").value_or(0)};
  } else {
    gain = three(element, "gainprm", 1);
    if (element.with("biastype").find("biastype").value_or("none") == "affine")
      bias = three(element, "biasprm", 0);
  }
  const auto gears = element.with("gear").numbers("gear", 1, 6);
  const double gear = gears ? gears->front() : 1, square = gear * gear;
  const double force = gear * (gain[0] * mjcf_control(element, context_) + bias[0]);
  if (bias[1] > 0 || bias[2] > 0)
    return e.note(notes_, "actuator that pushes the more, the farther or faster its joint goes: not taken");
  RobotAction& action = joint->action;
  action.damping -= square * bias[2];
  if (bias[1] == 0 || gear == 0) {
    if (force == 0) return;
    if (action.motor()) return e.note(notes_, "second motor of a joint: not taken");
    action.force = force;
    return;
  }
  add_spring(action, -square * bias[1], force / (-square * bias[1]) - joint->ref);
  e.note(notes_,
         "position actuator: a spring and a damper of its gains, at rest at control 0 or the nearest of its "
         "range");
}

void MjcfMechanics::read_motor(const MjcfElement& element) {
  note_attributes(element.own(), mjcf_rows(), notes_);
  RobotJoint* joint = joint_of(element);
  if (!joint) return;
  if (joint->action.motor()) return element.own().note(notes_, "second motor of a joint: not taken");
  mjcf_motor(element, context_, joint->action);
}

// The joint that an actuator moves; null, with a note, where it is none that can be moved.
RobotJoint* MjcfMechanics::joint_of(const MjcfElement& element) {
  const XmlElement& e = element.own();
  const XmlElement& source = element.with("joint");
  const auto leave = [&](const char* why) {
    e.note(notes_, why);
    return nullptr;
  };
  if (!source.has("joint")) return leave("actuator without a joint: not taken");
  const std::string name = source.text("joint");
  const auto found = names_.joints.find(name);
  if (names_.free_joints.contains(name)) return leave("actuator of a free joint: not taken");
  if (found == names_.joints.end()) source.fail_at("joint", "there is no joint " + in_quotes(name));
  const auto [link, number] = found->second;
  RobotJoint& joint = robot_.links[static_cast<std::size_t>(link)].joints[number];
  if (joint.kind == RobotJointKind::ball) return leave("actuator of a ball joint: not taken");
  return &joint;
}

// joint1 = a polynomial of joint2, each from its pose in the file.
void MjcfMechanics::read_follow(const XmlElement& e) {
  note_attributes(e, mjcf_rows(), notes_);
  if (!e.boolean("active").value_or(true)) return;
  const auto found = names_.joints.find(e.text("joint1"));
  if (found == names_.joints.end()) e.fail_at("joint1", "there is no joint " + in_quotes(e.text("joint1")));
  std::vector<double> poly = e.numbers("polycoef", 1, 5).value_or(std::vector<double>{0, 1});
  poly.resize(5, 0);
  if (e.has("joint2") && (poly[2] != 0 || poly[3] != 0 || poly[4] != 0))
    return e.note(notes_, "equality of joints by a polynomial above the first order: not taken");
  const auto [link, number] = found->second;
  RobotJoint& joint = robot_.links[static_cast<std::size_t>(link)].joints[number];
  if (joint.follows || joint.target) return e.note(notes_, "second equality of a joint: not taken");
  if (joint.kind == RobotJointKind::ball) return e.note(notes_, "equality of a ball joint: not taken");
  if (!e.has("joint2")) {
    joint.target = poly[0];
    return;
  }
  joint.follows = RobotFollow{e.text("joint2"), poly[1], poly[0], place_of(e)};
}

void MjcfMechanics::read_loop(const XmlElement& e) {
  note_attributes(e, mjcf_rows(), notes_);
  if (!e.has("body1")) return e.note(notes_, fmt::format("<{}> between sites: not taken", e.name()));
  if (!e.boolean("active").value_or(true)) return;
  RobotLoop loop;
  loop.weld = e.name() == "weld";
  loop.place = place_of(e);
  loop.i = body(e, "body1");
  loop.j = e.has("body2") ? body(e, "body2") : 0;
  if (loop.weld) {
    e.note(notes_, "<weld>: holds the two as they stand at the start");
  } else {
    const auto anchor = e.vec3("anchor");
    if (!anchor) e.fail_at("anchor", "missing");
    loop.anchor = *anchor;
  }
  robot_.loops.push_back(loop);
}

}  // namespace pabd
