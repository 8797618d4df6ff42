// SPDX-License-Identifier: MIT
// pabd scenes: what is shipped, a line each, or one of them as it is.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/common.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/streams.h"
#include "sim/base/error.h"
#include "sim/import/import.h"

namespace pabd::cli {
namespace {

struct ScenesOptions {
  CommonOptions common;
  std::string scene;
  bool json = false;
};

struct SceneRow {
  std::string name;
  Index bodies;
  std::size_t joints;
  std::string description;
};

int scenes(const ScenesOptions& options) {
  if (!options.scene.empty()) {
    write_stdout(read_any_scene_text(find_scene(options.scene)));
    return 0;
  }
  std::vector<SceneRow> rows;
  for (const auto& file : shipped_scenes()) {
    const Scene scene = load_any_scene(file);
    rows.push_back({file.stem().string(), scene.model.size(), scene.model.joints.size(), scene.description});
  }
  if (rows.empty()) {
    throw Error(ErrorKind::file,
                "no folder with shipped scenes was found; run 'cmake --install' again, or name files");
  }
  std::string text;
  if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SceneRow& row : rows) {
      list.push_back({{"name", row.name},
                      {"bodies", row.bodies},
                      {"joints", row.joints},
                      {"description", row.description}});
    }
    text = json_text(list);
  } else {
    std::size_t width = 5;
    for (const SceneRow& row : rows) width = std::max(width, row.name.size());
    text = fmt::format("{:<{}}  bodies  joints  description\n", "scene", width);
    for (const SceneRow& row : rows)
      text +=
          fmt::format("{:<{}}  {:>6}  {:>6}  {}\n", row.name, width, row.bodies, row.joints, row.description);
  }
  write_stdout(text);
  return 0;
}

}  // namespace

void add_scenes_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ScenesOptions>();
  const Command command(app, "scenes", "list the shipped scenes, or print one",
                        {"pabd scenes", "pabd scenes --json", "pabd scenes pyramid > my_scene.json"},
                        options->common);
  auto* scene =
      command.argument("SCENE", options->scene, "print this one, to begin a scene of one's own with");
  command.flag(group::kOwn, "--json", options->json, "print the list as JSON")->excludes(scene);
  command.carry_out(action, options, scenes);
}

}  // namespace pabd::cli
