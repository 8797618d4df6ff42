// SPDX-License-Identifier: MIT
// Scenes by name.
#include "app/cli/scene_lookup.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd::cli {

namespace {

// The prefix that this is installed below: PREFIX/bin/pabd, or as a module of Python
// PREFIX/lib/python3/dist-packages/pabd/….so. Empty where that is not to be learned.
fs::path own_prefix() {
  std::error_code none;
  Dl_info found{};
  const bool known = dladdr(reinterpret_cast<const void*>(&own_prefix), &found) != 0 && found.dli_fname;
  const bool module = known && fs::path(found.dli_fname).extension() == ".so";
  fs::path file = module ? fs::canonical(found.dli_fname, none) : fs::read_symlink("/proc/self/exe", none);
  for (int up = 0; up < (module ? 5 : 2); ++up) file = file.parent_path();
  return file;
}

}  // namespace

std::vector<fs::path> scene_folders() {
  std::vector<fs::path> folders;
  const fs::path prefix = own_prefix();
  if (!prefix.empty()) folders.push_back(prefix / PABD_SHARE_DIR / "scenes");
#ifdef PABD_SOURCE_DIR
  folders.emplace_back(PABD_SOURCE_DIR "/assets/scenes");
#endif
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
