// SPDX-License-Identifier: MIT
// Mesh files of robots: found, read and made convex. Internal to sim/import.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/import/robot.h"
#include "sim/import/xml.h"
#include "sim/scene/guarded_scene.h"

namespace pabd {

inline Place place_of(const XmlElement& element) { return {element.file().name, element.line()}; }

// A mesh as its convex hull. Surfaces need not be closed: where one is not, its mass is the hull's.
struct RobotMesh {
  std::vector<Vec3> corners;  // of the hull, at most 200; m
  RobotInertia solid;         // at 1 kg/m³
  double missing = 0;         // how far the mesh reaches out of a hull of fewer corners; m
  double filled = 1;          // volume of a closed mesh as part of the hull's: less than 1 for a concave one
  std::string problem;        // not empty: why there is none
};

class RobotMeshes {
 public:
  explicit RobotMeshes(MayRead may_read) : may_read_(std::move(may_read)) {}

  // Where "package://NAME/PATH" is: in a folder NAME at or above `folder`, or in `folder` itself where the package's
  // own files are; only what may be read is looked for. Other names are relative to `folder`. PATH may not climb out
  // of a package: then, and when a package is nowhere, `problem` says so.
  std::filesystem::path find(const std::string& name, const std::filesystem::path& folder,
                             std::string& problem) const;

  // The mesh of a file that `element` names, scaled along x, y and z. Never throws for what is in the file.
  const RobotMesh& load(const std::filesystem::path& file, const Vec3& scale);
  std::vector<std::filesystem::path> files() const;

  // Gives `geom` the mesh, and notes what a hull does not show. False, with a note, when there is none.
  bool put(const std::filesystem::path& file, const Vec3& scale, const XmlElement& element, RobotGeom& geom,
           ImportNotes& notes);

 private:
  bool is_there(const std::filesystem::path& file) const;

  MayRead may_read_;
  std::map<std::tuple<std::string, double, double, double>, RobotMesh> meshes_;
};

// Hull of points in memory, as load gives it; `faces` are triples of numbers of points and may be empty.
RobotMesh robot_mesh(const std::vector<Vec3>& points, const std::vector<std::array<std::uint32_t, 3>>& faces);

}  // namespace pabd
