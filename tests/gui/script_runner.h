// SPDX-License-Identifier: MIT
// A window of its own, without a display, for every script.
#pragma once

#include <filesystem>
#include <string>

#include "app/gui/script.h"
#include "sim/base/error.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd {

inline std::string shipped_scene(const std::string& name) {
  if (std::filesystem::exists(name)) return name;
  const std::filesystem::path path = std::filesystem::path(places::scenes()) / (name + ".json");
  if (!std::filesystem::exists(path)) throw Error(ErrorKind::file, name + ": no such scene");
  return path.string();
}

// `files`: as ViewerOptions has them.
inline void carry_out(const Script& script, const TempFolder& folder, std::string& renderer,
                      std::string* copied = nullptr, std::string* printed = nullptr,
                      std::shared_ptr<const FileRoot> files = nullptr) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  WorkbenchOptions bench;
  bench.find_scene = shipped_scene;
  Runner runner(std::make_unique<Workbench>(bench, command::Load{"two_boxes", {}, false}));
  ViewerOptions options;
  options.steady = true;
  options.shipped_scenes = [] {
    std::vector<std::filesystem::path> out;
    for (const char* name : {"dominoes", "four_bar", "pile", "two_boxes"})
      out.emplace_back(shipped_scene(name));
    return out;
  };
  if (copied) options.set_clipboard = [copied](const std::string& text) { *copied = text; };
  ScriptOptions script_options;
  if (!files) script_options.folder = folder.path();
  options.files = std::move(files);
  Viewer viewer(*context, runner, options);
  renderer = viewer.renderer().gl_renderer();
  script_options.print = [printed](const std::string& line) {
    if (printed) *printed += line;
  };
  script.run(viewer, runner, script_options);
}

}  // namespace pabd
