// SPDX-License-Identifier: MIT
// A robot of another program: what is taken is a scene, and every note is one line that can be printed.
#pragma once

#include "sim/import/import.h"
#include "tests/fuzz/fuzz.h"

namespace pabd::fuzz {

inline void read_robot(std::string_view bytes, const char* name) {
  accepts([&] {
    const ImportedScene robot = import_robot_text(std::string(bytes), name, "/nowhere");
    const Scene scene = parse_scene(robot.text, "scene.json", {});
    require(scene.model.size() > 0 && scene.initial.c.front().allFinite(), "what is taken is a scene");
    for (const ImportNote& note : robot.notes) require(!note.text.empty(), "a note says something");
  });
}

}  // namespace pabd::fuzz
