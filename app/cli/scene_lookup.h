// SPDX-License-Identifier: MIT
// Where scenes are found: a file as named, or a shipped scene by its name alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pabd::cli {

// Folders with shipped scenes that exist, best first: beside an installed program, then the source tree.
std::vector<std::filesystem::path> scene_folders();

// The file for "my/scene.json", "pyramid.json" or "pyramid". Throws Error(file) when there is none.
std::filesystem::path find_scene(const std::string& name);

// Every shipped scene file, sorted by name.
std::vector<std::filesystem::path> shipped_scenes();

}  // namespace pabd::cli
