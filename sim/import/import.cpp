// SPDX-License-Identifier: MIT
// See import.h. In the order: XML, robot, plan of a scene, its text. What comes out does load.
#include "sim/import/import.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/utf8.h"
#include "sim/import/keep_apart.h"
#include "sim/import/readers.h"
#include "sim/import/scene_text.h"
#include "sim/scene/mesh_surface.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

constexpr double kTimeStep = 0.002;  // s, where a file says none: MuJoCo's own
constexpr std::size_t kLongestName = 100, kLongestDescription = 900;

std::string fit_name(const std::string& name, const std::string& fallback) {
  std::string out = is_utf8_text(name) ? one_line(name) : "";
  if (out.empty() || out.size() > kLongestName) out = fallback;
  return std::string(first_bytes(out, kLongestName - 4));
}

// What is not as in the file, in one line; the rest of a long list is counted.
std::string describe(const std::string& file, const std::vector<ImportNote>& notes) {
  std::string out = "Imported from " + one_line(fs::path(file).filename().string());
  if (notes.empty()) return std::string(first_bytes(out, kLongestDescription));
  out += ". Not as there: ";
  for (std::size_t k = 0; k < notes.size(); ++k) {
    const std::string more = (k == 0 ? "" : "; ") + one_line(notes[k].text);
    if (out.size() + more.size() > kLongestDescription) {
      out = std::string(first_bytes(out, kLongestDescription));
      return out + fmt::format("; and {} more", notes.size() - k);
    }
    out += more;
  }
  return out;
}

// What was left out, where nothing is left.
std::string why(const std::vector<ImportNote>& notes) {
  constexpr std::size_t kMost = 8;
  std::string out;
  for (std::size_t k = 0; k < std::min(notes.size(), kMost); ++k)
    out += (k == 0 ? ": " : "; ") + one_line(notes[k].line());
  if (notes.size() > kMost) out += fmt::format("; and {} more", notes.size() - kMost);
  return out;
}

// What is wrong with the whole of it is told of the root.
ScenePlan plan_of(const Robot& robot, const XmlElement& root, ImportNotes& notes) {
  try {
    return assemble(robot, notes);
  } catch (const Error& error) {
    if (error.source().empty()) root.fail(error.what() + why(notes.all()));
    throw;
  }
}

// What comes out does load.
Scene loaded(const std::string& text, const std::string& name) {
  try {
    return parse_scene(text, "its scene", {});
  } catch (const Error& error) {
    throw Error(error.kind(), name, fmt::format("cannot be a scene: {}", error.what()));
  }
}

std::string import_urdf_or_mjcf(const XmlElement& root, XmlFiles& files, RobotMeshes& meshes,
                                ImportNotes& notes, const ImportOptions& options, const std::string& file) {
  const bool urdf = root.name() == "robot";
  if (!urdf && root.name() != "mujoco") root.fail("expected <robot> of URDF or <mujoco> of MJCF");
  if (urdf && !options.keyframe.empty()) root.fail("URDF has no keyframes; expected MJCF");
  const Robot robot =
      urdf ? read_urdf(root, meshes, notes, options) : read_mjcf(root, files, meshes, notes, options);
  ScenePlan plan = plan_of(robot, root, notes);
  SceneWords words;
  words.name = fit_name(robot.name, fs::path(file).stem().string());
  words.gravity = robot.gravity;
  words.time_step = robot.time_step.value_or(kTimeStep);
  const auto floats = [](const RobotLink& link) { return link.free; };
  words.ground = urdf && options.ground && std::any_of(robot.links.begin(), robot.links.end(), floats);
  if (urdf) notes.add(robot.base, "", 0);
  if (words.ground) notes.add("a ground is put under what floats: the format has none", "", 0);
  words.description = [&] { return describe(file, notes.all()); };
  ImportNotes of_all = notes;  // what this text says of joints is said again of the last one
  const Scene all = loaded(scene_text(plan, words, of_all), file);
  keep_apart(options.self_collision, all, words.ground ? 1 : 0, plan, notes);
  return scene_text(plan, words, notes);
}

ImportedScene convert(const std::string& text, const std::string& name, const fs::path& folder,
                      const ImportOptions& options, const MayRead& may_read) {
  XmlFiles files(may_read);
  RobotMeshes meshes(may_read);
  ImportNotes notes;
  const XmlElement root = files.parse(text, name, folder);
  ImportedScene out;
  out.text = import_urdf_or_mjcf(root, files, meshes, notes, options, name);
  out.notes = notes.all();
  out.files = meshes.files();
  const auto read = files.names();
  out.files.insert(out.files.end(), read.begin(), read.end());
  return out;
}

std::string robot_text(const fs::path& file) {
  return read_file(file, kMostXmlBytes, "a robot in URDF or MJCF");
}

}  // namespace

bool is_robot_file(const fs::path& file) {
  const std::string ending = ending_of(file);
  return ending == "urdf" || ending == "xml" || ending == "mjcf";
}

ImportedScene import_robot_text(const std::string& text, const std::string& name, const fs::path& folder,
                                const ImportOptions& options, const MayRead& may_read) {
  return convert(text, name, folder, options, may_read);
}

ImportedScene import_robot(const fs::path& file, const ImportOptions& options, const MayRead& may_read) {
  if (may_read) may_read(file);
  return import_robot_text(robot_text(file), file.string(), file.parent_path(), options, may_read);
}

std::string read_any_scene_text(const fs::path& file, const MayRead& may_read) {
  return is_robot_file(file) ? import_robot(file, {}, may_read).text : read_scene_text(file);
}

ReadSceneText any_scene_reader(std::vector<ImportNote>* notes) {
  return [notes](const fs::path& file, const MayRead& may_read) -> SceneText {
    if (!is_robot_file(file)) return {read_scene_text(file), {}};
    ImportedScene imported = import_robot(file, {}, may_read);
    if (notes != nullptr) notes->insert(notes->end(), imported.notes.begin(), imported.notes.end());
    return {std::move(imported.text), std::move(imported.files)};
  };
}

Scene parse_any_scene(const std::string& text, const std::string& source, const fs::path& folder,
                      const std::vector<std::string>& overrides, const MayRead& may_read) {
  return parse_guarded_scene(text, source, folder, overrides, may_read, any_scene_reader());
}

Scene load_any_scene(const fs::path& file, const std::vector<std::string>& overrides,
                     std::vector<ImportNote>* notes) {
  Scene scene;
  if (is_robot_file(file)) {
    const ImportedScene imported = convert(robot_text(file), file.string(), file.parent_path(), {}, {});
    scene = parse_scene(imported.text, file.string(), file.parent_path(), overrides);
    if (notes != nullptr) *notes = imported.notes;
    scene.files = imported.files;
  } else {
    scene = parse_guarded_scene(read_scene_text(file), file.string(), file.parent_path(), overrides, {},
                                any_scene_reader(notes));
  }
  scene.files.push_back(file);
  return scene;
}

}  // namespace pabd
