// SPDX-License-Identifier: MIT
// See mjcf_keyframe.h. qpos has the coordinates of all joints in the order of the file: 7 of a free one, 4 of a ball.
#include "sim/import/mjcf_keyframe.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "sim/import/taken.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr std::size_t kMostCoordinates = 7 * kMostLinks;

std::size_t coordinates_of(const RobotLink& link) {
  std::size_t out = link.free ? 7 : 0;
  for (const RobotJoint& joint : link.joints) out += joint.kind == RobotJointKind::ball ? 4 : 1;
  return out;
}

Mat3 turn_of(const XmlElement& key, const double* q) {
  const Quat quat(q[0], q[1], q[2], q[3]);
  if (!(quat.norm() > 1e-9)) key.fail_at("qpos", "the length of a quaternion is 0");
  return quat.normalized().toRotationMatrix();
}

// A ball that is the only joint turns its link about its anchor.
void turn_ball(const XmlElement& key, const double* q, RobotLink& link, ImportNotes& notes) {
  const Mat3 R = turn_of(key, q);
  if (link.joints.size() > 1) return key.note(notes, "keyframe: a ball joint beside others starts at 0");
  const Vec3 anchor = link.joints.front().anchor;
  link.at = link.at * LinkPose{R, anchor - R * anchor};
}

}  // namespace

XmlElement find_key(const std::vector<XmlElement>& keys, const XmlElement& root, const std::string& name) {
  std::string known;
  for (const XmlElement& key : keys) {
    const std::string here = key.find("name").value_or("");
    if (here == name) return key;
    known += (known.empty() ? "" : ", ") + in_quotes(here);
  }
  root.fail(fmt::format("there is no keyframe {}; {}", in_quotes(name),
                        known.empty() ? "there are none" : "there are " + known));
}

void start_at_key(const XmlElement& key, Robot& robot, ImportNotes& notes) {
  note_attributes(key, mjcf_rows(), notes);
  const auto qpos = key.numbers("qpos", 1, kMostCoordinates);
  if (!qpos) return;
  std::size_t needed = 0;
  for (const RobotLink& link : robot.links) needed += coordinates_of(link);
  if (qpos->size() != needed)
    key.fail_at("qpos", fmt::format("{} numbers; expected {}, as the joints have", qpos->size(), needed));
  const double* q = qpos->data();
  for (RobotLink& link : robot.links) {
    if (link.free) {
      link.at = {turn_of(key, q + 3), Vec3(q[0], q[1], q[2])};
      q += 7;
    }
    for (RobotJoint& joint : link.joints) {
      if (joint.kind == RobotJointKind::ball) {
        turn_ball(key, q, link, notes);
        q += 4;
      } else {
        joint.start = *q++ - joint.ref;
      }
    }
  }
}

}  // namespace pabd
