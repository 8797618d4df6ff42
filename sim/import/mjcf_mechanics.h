// SPDX-License-Identifier: MIT
// Sections of MJCF that name bodies and joints: contact, actuator, equality. Internal to sim/import.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "sim/import/mjcf_elements.h"

namespace pabd {

struct MjcfNames {
  std::map<std::string, int> bodies;                          // their links
  std::map<std::string, std::pair<int, std::size_t>> joints;  // link, and number there
  std::set<std::string> free_joints;
};

class MjcfMechanics {
 public:
  MjcfMechanics(const MjcfContext& context, const MjcfNames& names, Robot& robot)
      : context_(context), notes_(*context.notes), names_(names), robot_(robot) {}

  // An element of one of the three sections.
  void read(const std::string& section, const XmlElement& element);

 private:
  int body(const XmlElement& e, std::string_view attribute) const;
  void read_servo(const MjcfElement& element);
  void read_motor(const MjcfElement& element);
  RobotJoint* joint_of(const MjcfElement& element);
  void read_follow(const XmlElement& e);
  void read_loop(const XmlElement& e);

  const MjcfContext& context_;
  ImportNotes& notes_;
  const MjcfNames& names_;
  Robot& robot_;
};

}  // namespace pabd
