// SPDX-License-Identifier: MIT
// The scenes that a scene includes, and the meshes beside them: each file is read once. Internal to sim/scene.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/scene/guarded_scene.h"
#include "sim/scene/mesh_library.h"

namespace pabd {

inline constexpr std::size_t kMostIncludes = 1000;  // in a scene, those of included scenes counted
inline constexpr std::size_t kDeepestInclude = 8;   // scenes inside each other
inline constexpr std::size_t kMostIncluded = std::size_t{64}
                                             << 20;  // bytes, a file as often as it is included

class IncludeLibrary {
 public:
  // `source` names the scene that includes; files are named relative to `folder`.
  IncludeLibrary(std::string source, std::filesystem::path folder, MayRead may_read = {},
                 ReadSceneText read_text = {});

  // While it lives, the scene that `name` includes is being read; `name` is relative to the folder of the one
  // that was opened last. Throws Error(bad_input) with "name: what is wrong".
  class Opened {
   public:
    Opened(IncludeLibrary& library, const std::string& name);
    ~Opened();
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    const std::string& text() const { return *text_; }
    MeshLibrary& meshes() const { return *meshes_; }

   private:
    IncludeLibrary& library_;
    const std::string* text_ = nullptr;
    MeshLibrary* meshes_ = nullptr;
  };

  // The scene itself will be read once more: what it includes is known, and does not count yet.
  void start_again() { included_ = bytes_ = 0; }

  std::vector<std::filesystem::path> files() const;  // that were read, meshes as well

 private:
  struct Level {
    std::string name;              // as it was included
    std::filesystem::path file;    // without links and dots
    std::filesystem::path folder;  // of what it names
  };

  void refuse_cycle(const std::string& name, const std::filesystem::path& file) const;
  const SceneText& text_of(const std::filesystem::path& file, const std::string& name);

  std::vector<Level> open_;  // the scene itself, and what is being read of it
  MayRead may_read_;
  ReadSceneText read_text_;
  std::map<std::filesystem::path, SceneText> texts_;
  std::map<std::filesystem::path, MeshLibrary> meshes_;  // by folder
  std::size_t included_ = 0, bytes_ = 0;
};

}  // namespace pabd
