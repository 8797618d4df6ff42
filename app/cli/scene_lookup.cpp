// SPDX-License-Identifier: MIT
// Scenes by name.
#include "app/cli/scene_lookup.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd::cli {

std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) folders.push_back(program.parent_path().parent_path() / PABD_SHARE_DIR / "scenes");
  folders.emplace_back(PABD_SOURCE_DIR "/assets/scenes");
  std::erase_if(folders, [](const fs::path& folder) {
    std::error_code none;
    return !fs::is_directory(folder, none);
  });
  return folders;
}

namespace {

// `; did you mean "pyramid"? …` when a shipped scene has a name like that, and where names are.
std::string remedy(const std::string& name) {
  std::vector<std::string> names;
  for (const fs::path& file : shipped_scenes()) names.push_back(file.stem().string());
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string guess = did_you_mean(name, views);
  return (guess.empty() ? ";" : guess) + " 'pabd scenes' lists those";
}

}  // namespace

fs::path find_scene(const std::string& name) {
  std::error_code ignored;
  if (fs::is_directory(name, ignored)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: is a directory; name a scene file in it", name));
  }
  // A link that leads nowhere is there, too: reading it tells why.
  if (fs::exists(fs::symlink_status(name, ignored))) return name;
  if (name.find('/') == std::string::npos && !name.empty()) {
    for (const fs::path& folder : scene_folders()) {
      for (const std::string& file : {name, name + ".json"}) {
        if (fs::is_regular_file(folder / file, ignored)) return folder / file;
      }
    }
  }
  throw Error(ErrorKind::file,
              fmt::format("{}: no such scene file, and no shipped scene of this name{}", name, remedy(name)));
}

std::vector<fs::path> shipped_scenes() {
  std::vector<fs::path> files;
  const auto folders = scene_folders();
  if (folders.empty()) return files;
  for (const auto& entry : fs::directory_iterator(folders.front())) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace pabd::cli
