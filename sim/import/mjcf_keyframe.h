// SPDX-License-Identifier: MIT
// Keyframes of MJCF: where joints start and actuators stand. Internal to sim/import.
#pragma once

#include <string>
#include <vector>

#include "sim/import/robot.h"
#include "sim/import/xml.h"

namespace pabd {

// Moves the robot to where a <key> has it. What it says of other things than places and controls is noted.
void start_at_key(const XmlElement& key, Robot& robot, ImportNotes& notes);

// The <key> of that name among those of all <keyframe>; throws Error(bad_input) that names those there are.
XmlElement find_key(const std::vector<XmlElement>& keys, const XmlElement& root, const std::string& name);

}  // namespace pabd
