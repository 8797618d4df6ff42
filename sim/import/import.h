// SPDX-License-Identifier: MIT
// Robots of other programs as scenes: URDF and MJCF. Needs TinyXML-2; sim/scene knows nothing of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/import/notes.h"
#include "sim/scene/guarded_scene.h"
#include "sim/scene/scene.h"

namespace pabd {

// How the root of a URDF stands. automatic: fixed when it is called "world" or has no mass, else floating.
enum class RobotBase { automatic, fixed, floating };

// Which links of one robot may touch each other, besides those that the file keeps apart: all; those that are not nearer
// than d̂ at the start; none.
enum class SelfCollision { all, start, none };

struct ImportOptions {
  RobotBase base = RobotBase::automatic;
  bool ground = true;  // under a URDF that floats: the format has none
  SelfCollision self_collision = SelfCollision::start;
  std::string keyframe = {};  // of MJCF, to start at; empty: none
};

struct ImportedScene {
  std::string text;                          // of a scene file, complete: it needs no mesh files
  std::vector<ImportNote> notes;             // what of the robot is not in it, or otherwise
  std::vector<std::filesystem::path> files;  // that were read
};

// Is it a robot by the ending of its name, .urdf or .xml, in any case?
bool is_robot_file(const std::filesystem::path& file);

// A URDF or MJCF file as a scene. The world is turned so that the file's z is up, which is y here. Throws
// Error(bad_input) with file and line, Error(file) when it cannot be read; `may_read` is asked before each file.
ImportedScene import_robot(const std::filesystem::path& file, const ImportOptions& options = {},
                           const MayRead& may_read = {});
// The same of a text; `name` is its file's in messages.
ImportedScene import_robot_text(const std::string& text, const std::string& name,
                                const std::filesystem::path& folder, const ImportOptions& options = {},
                                const MayRead& may_read = {});

// Reads what a scene includes: scene files and robots. `notes`, if there, gets those of robots, and must live as
// long as the result.
ReadSceneText any_scene_reader(std::vector<ImportNote>* notes = nullptr);

// What read_scene_text, parse_guarded_scene and load_scene of sim/scene do, of robots as well.
std::string read_any_scene_text(const std::filesystem::path& file, const MayRead& may_read = {});
Scene parse_any_scene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                      const std::vector<std::string>& overrides = {}, const MayRead& may_read = {});
// `notes` gets those of a robot, and of robots that the scene includes.
Scene load_any_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {},
                     std::vector<ImportNote>* notes = nullptr);

}  // namespace pabd
