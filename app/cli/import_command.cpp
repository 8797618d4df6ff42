// SPDX-License-Identifier: MIT
// pabd import: a robot of another program as a scene file, and what of it is not in there.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/common.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/output_path.h"
#include "sim/import/import.h"

namespace pabd::cli {
namespace {

struct Options {
  CommonOptions common;
  OutputOptions output;
  std::string robot, base = "auto", self_collision = "start", keyframe;
  bool no_ground = false;
};

RobotBase base_of(const std::string& word) {
  if (word == "fixed") return RobotBase::fixed;
  if (word == "floating") return RobotBase::floating;
  if (word == "auto") return RobotBase::automatic;
  throw Error(ErrorKind::bad_input, fmt::format("--base: '{}'; expected auto, fixed or floating", word));
}

SelfCollision self_collision_of(const std::string& word) {
  if (word == "all") return SelfCollision::all;
  if (word == "start") return SelfCollision::start;
  if (word == "none") return SelfCollision::none;
  throw Error(ErrorKind::bad_input, fmt::format("--self-collision: '{}'; expected all, start or none", word));
}

int import_scene(const Options& options) {
  const ImportOptions how{base_of(options.base), !options.no_ground,
                          self_collision_of(options.self_collision), options.keyframe};
  const ImportedScene scene = import_robot(options.robot, how);
  InputFiles inputs;
  inputs.add(options.robot);
  for (const auto& file : scene.files) inputs.add(file);
  TextOutput output("-o", options.output.path, options.output.force, inputs);
  output.write(scene.text);
  output.finish();
  if (!options.common.quiet) write_import_notes(options.robot, scene.notes);
  return 0;
}

}  // namespace

void add_import_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command(
      app, "import", "make a scene of a robot in URDF or MJCF, and list what of it a scene cannot have",
      {"pabd import robot.urdf -o robot.json", "pabd import arm.urdf -o arm.json --base fixed",
       "pabd import humanoid.xml -o humanoid.json --keyframe squat --self-collision none"},
      options->common);
  command.argument("ROBOT", options->robot, "a .urdf file, or MJCF as .xml")->required();
  command.output(options->output, "the scene file; - is standard output");
  command.word(
      group::kOwn, "--base", options->base, {"auto", "fixed", "floating"},
      "of URDF: fixed, floating or auto: fixed when its root is called world, or has no mass and the robot "
      "neither wheels nor feet",
      "BASE");
  command.word(
      group::kOwn, "--self-collision", options->self_collision, {"all", "start", "none"},
      "links of one robot that may touch each other: all that the file lets, those that do not touch "
      "at the start, or none",
      "WHICH");
  command.option(group::kOwn, "--keyframe", options->keyframe,
                 "of MJCF: start at this keyframe, with its controls, in place of the pose of the bodies",
                 "NAME");
  command.flag(group::kOwn, "--no-ground", options->no_ground, "of URDF that floats: no ground below it");
  command.carry_out(action, options, import_scene);
}

}  // namespace pabd::cli
