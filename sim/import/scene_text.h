// SPDX-License-Identifier: MIT
// A plan as the text of a scene file. Internal to sim/import.
#pragma once

#include <functional>
#include <string>

#include "sim/import/assemble.h"

namespace pabd {

struct SceneWords {
  std::string name;
  std::function<std::string()> description;  // asked when all notes are there
  Vec3 gravity;                              // z up
  double time_step = 0;                      // s
  bool ground = false;                       // a plane below the lowest point
};

// Adds notes of what a scene cannot say.
std::string scene_text(const ScenePlan& plan, const SceneWords& words, ImportNotes& notes);

}  // namespace pabd
