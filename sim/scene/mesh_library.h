// SPDX-License-Identifier: MIT
// Mesh files of a scene → hulls, each file read once. Internal to sim/scene.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/compound.h"
#include "sim/scene/guarded_scene.h"

namespace pabd {

class MeshLibrary {
 public:
  // Files are named relative to `folder`; `may_read` is asked before one is looked at.
  explicit MeshLibrary(std::filesystem::path folder, MayRead may_read = {})
      : folder_(std::move(folder)), may_read_(std::move(may_read)) {}

  struct Entry {
    Hull hull;
    std::string digest;  // of the file's bytes
    bool file = true;    // false: entered
  };

  // Convex hull of the mesh in `file` times `scale`. The same file and scale give the same data again. Throws
  // Error(bad_input) with "file: line or byte: what is wrong".
  const Entry& load(const std::string& file, double scale);

  // The hulls of several files as one body. The same files and scale give the same data again.
  const Compound& load_parts(const std::vector<std::string>& files, double scale);

  // Hulls that a program has, under names that stand for files. Each name once.
  void enter(const std::string& name, const Hull& hull);
  void enter(const std::vector<std::string>& names, const Compound& compound);

  std::vector<std::filesystem::path> files() const;  // that were read

 private:
  std::filesystem::path folder_;
  MayRead may_read_;
  std::map<std::pair<std::string, double>, Entry> entries_;
  std::map<std::pair<std::vector<std::string>, double>, Compound> compounds_;
};

// Hull of a mesh in memory; `ending` is "obj", "stl" or "ply". Throws as load does, without the file's name.
Hull read_mesh_hull(std::string_view bytes, std::string_view ending, double scale);

}  // namespace pabd
