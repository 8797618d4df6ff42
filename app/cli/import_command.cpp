// SPDX-License-Identifier: MIT
// pabd import: a robot of another program as a scene file, and what of it is not in there.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/common.h"
#include "app/cli/import_notes.h"
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
  std::string robot, base = "auto";
  bool no_ground = false;
};

RobotBase base_of(const std::string& word) {
  if (word == "fixed") return RobotBase::fixed;
  if (word == "floating") return RobotBase::floating;
  if (word == "auto") return RobotBase::automatic;
  throw Error(ErrorKind::bad_input, fmt::format("--base: '{}'; expected auto, fixed or floating", word));
}

int import_scene(const Options& options) {
  const ImportOptions how{base_of(options.base), !options.no_ground};
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

void write_import_notes(const std::string& robot, const std::vector<ImportNote>& notes) {
  if (notes.empty()) return;
  write_note(fmt::format("{}: {} {} not as in the file:", robot, notes.size(),
                         notes.size() == 1 ? "thing is" : "things are"));
  for (const ImportNote& note : notes) write_note("  " + note.line());
}

void add_import_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = add_command(
      app, "import", "make a scene of a robot in URDF or MJCF, and list what of it a scene cannot have",
      {"pabd import robot.urdf -o robot.json", "pabd import arm.urdf -o arm.json --base fixed",
       "pabd import humanoid.xml -o humanoid.json --force"},
      options->common);
  command->add_option("ROBOT", options->robot, "a .urdf file, or MJCF as .xml")->required();
  add_output_options(*command, options->output, "the scene file; - is standard output");
  command
      ->add_option("--base", options->base,
                   "of URDF: auto (fixed when its root is called world or has no mass), fixed or floating")
      ->type_name("BASE")
      ->check(CLI::IsMember({"auto", "fixed", "floating"}));
  command->add_flag("--no-ground", options->no_ground, "of URDF that floats: no ground below it");
  command->callback([options, &action] { action = [options] { return import_scene(*options); }; });
}

}  // namespace pabd::cli
