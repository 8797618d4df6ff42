// SPDX-License-Identifier: MIT
// A scene by somebody who may not read every file of this machine, or that may include what is no scene file.
#pragma once

#include <functional>

#include "sim/scene/scene.h"

namespace pabd {

// Throws Error(bad_input) for a file of a scene that must not be read. Empty: all may be.
using MayRead = std::function<void(const std::filesystem::path&)>;

// What stands for an included scene: the text of a scene file, and the files that it took.
struct SceneText {
  std::string text;
  std::vector<std::filesystem::path> files;
};
// Reads one; `may_read` was asked for `file` itself. Throws Error. Empty: files are scene files.
using ReadSceneText = std::function<SceneText(const std::filesystem::path& file, const MayRead& may_read)>;

// As parse_scene, but asks `may_read` before a mesh or an included scene is looked at.
Scene parse_guarded_scene(const std::string& text, const std::string& source,
                          const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                          const MayRead& may_read, const ReadSceneText& read_text = {});

}  // namespace pabd
