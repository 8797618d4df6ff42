// SPDX-License-Identifier: MIT
// See robot_meshes.h. Mass of a closed surface: the sum over tetrahedra from one point to each triangle.
#include "sim/import/robot_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/error.h"
#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"
#include "sim/import/geometry.h"
#include "sim/scene/mesh_surface.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

constexpr std::size_t kMostCorners = 200;  // a hull that contacts can afford; a scene takes 256
constexpr double kConcave = 0.9;           // a mesh that fills less of its hull is worth a note

// Points coordinate by coordinate: hundreds of directions are looked along, and a mesh has 100,000 points.
class PointRows {
 public:
  explicit PointRows(const std::vector<Vec3>& points) {
    const Eigen::Map<const Eigen::Matrix3Xd> all(points.front().data(), 3,
                                                 static_cast<Eigen::Index>(points.size()));
    for (int k = 0; k < 3; ++k) rows_[static_cast<std::size_t>(k)] = all.row(k);
  }
  // How far the farthest one is along u, and its number.
  double reach(const Vec3& u, Eigen::Index* which = nullptr) {
    along_ = u.x() * rows_[0] + u.y() * rows_[1] + u.z() * rows_[2];
    return which ? along_.maxCoeff(which) : along_.maxCoeff();
  }

 private:
  std::array<Eigen::ArrayXd, 3> rows_;
  Eigen::ArrayXd along_;
};

// The farthest points in directions spread evenly over the sphere (a spiral of the golden angle).
std::vector<Vec3> farthest_points(const std::vector<Vec3>& points) {
  PointRows rows(points);
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < kMostCorners; ++k) {
    const double z = 1 - (2 * static_cast<double>(k) + 1) / kMostCorners;
    const double turn = static_cast<double>(k) * kPi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
    const Vec3 u(r * std::cos(turn), r * std::sin(turn), z);
    Eigen::Index best = 0;
    rows.reach(u, &best);
    chosen.push_back(static_cast<std::size_t>(best));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Vec3> out;
  for (const std::size_t p : chosen) out.push_back(points[p]);
  return out;
}

RobotInertia of_moments(double volume, const Vec3& first, const Mat3& second) {
  RobotInertia out;
  out.mass = volume;
  out.com = first / volume;
  out.I = inertia_tensor(second - volume * out.com * out.com.transpose());
  return out;
}

RobotInertia of_surface(const std::vector<Vec3>& points,
                        const std::vector<std::array<std::uint32_t, 3>>& faces, const Vec3& from) {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const auto& face : faces) {
    const Vec3 a = points[face[0]] - from, b = points[face[1]] - from, c = points[face[2]] - from;
    const double v = a.dot(b.cross(c)) / 6;
    const Vec3 sum = a + b + c;
    volume += v;
    first += v / 4 * sum;
    second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  if (volume < 0) {  // inside out
    volume = -volume;
    first = -first;
    second = -second;
  }
  if (!(volume > 0)) return {};
  RobotInertia out = of_moments(volume, first, second);
  out.com += from;
  return out;
}

bool closed(const MeshSurface& surface) {
  try {
    require_closed(surface);
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool climbs(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

}  // namespace

RobotMesh robot_mesh(const std::vector<Vec3>& points,
                     const std::vector<std::array<std::uint32_t, 3>>& faces) {
  RobotMesh out;
  HullResult hull = make_hull(points);
  if (!hull.hull && points.size() > kMostCorners) hull = make_hull(farthest_points(points));
  if (!hull.hull) {
    out.problem = hull.problem;
    return out;
  }
  if (hull.hull->vertices.size() > kMostCorners) {
    HullResult fewer = make_hull(farthest_points(points));
    if (fewer.hull) hull = std::move(fewer);
  }
  const HullData& data = *hull.hull;
  for (const Vec3& corner : data.vertices) out.corners.push_back(corner + data.centroid);
  PointRows rows(points);
  for (const HullFace& face : data.faces)
    out.missing =
        std::max(out.missing, rows.reach(face.normal) - face.offset - face.normal.dot(data.centroid));
  if (out.missing < 1e-4 * data.bounding_radius) out.missing = 0;  // what a hull flattens anyhow
  out.solid = {data.volume, data.centroid, inertia_tensor(data.second_moment)};
  if (!faces.empty()) {
    const RobotInertia exact = of_surface(points, faces, data.centroid);
    if (exact.mass > 1e-6 * data.volume && is_physical(exact.I)) {
      out.filled = exact.mass / data.volume;
      out.solid = exact;
    }
  }
  return out;
}

const RobotMesh& RobotMeshes::load(const fs::path& file, const Vec3& scale) {
  const std::tuple key(file.string(), scale.x(), scale.y(), scale.z());
  if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
  if (may_read_) may_read_(file);
  RobotMesh& out = meshes_[key];
  try {
    const MeshSurface surface = read_surface(read_mesh_file(file), ending_of(file));
    if (surface.corners.empty()) throw Error(ErrorKind::bad_input, "no faces in it");
    std::vector<Vec3> points(surface.points.size());
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = scale.cwiseProduct(surface.points[k]);
    if (!std::all_of(points.begin(), points.end(),
                     [](const Vec3& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= 1e6; })) {
      out.problem = "a point is farther than 1000000 m from the origin; expected a smaller scale";
      return out;
    }
    std::vector<std::array<std::uint32_t, 3>> faces;
    if (closed(surface)) {
      for (const MeshSurface::Face& face : surface.faces)
        for (std::uint32_t k = 2; k < face.count; ++k)
          faces.push_back({surface.corners[face.first], surface.corners[face.first + k - 1],
                           surface.corners[face.first + k]});
    }
    // Only points that a face has.
    std::vector<char> used(points.size());
    for (const std::uint32_t corner : surface.corners) used[corner] = 1;
    const Vec3 some = points[surface.corners[0]];
    for (std::size_t k = 0; k < points.size(); ++k)
      if (!used[k]) points[k] = some;
    out = robot_mesh(points, faces);
  } catch (const Error& error) {
    out.problem = error.what();
  }
  return out;
}

std::vector<fs::path> RobotMeshes::files() const {
  std::vector<fs::path> out;
  for (const auto& [key, mesh] : meshes_)
    if (out.empty() || out.back() != std::get<0>(key)) out.emplace_back(std::get<0>(key));
  return out;
}

bool RobotMeshes::put(const fs::path& file, const Vec3& scale, const XmlElement& element, RobotGeom& geom,
                      ImportNotes& notes) {
  const RobotMesh& mesh = load(file, scale);
  const std::string name = in_quotes(file.filename().string());
  if (!mesh.problem.empty()) {
    element.note(notes, fmt::format("mesh {} is left out: {}", name, mesh.problem));
    return false;
  }
  if (!geom.visual && mesh.filled < kConcave)
    element.note(notes, fmt::format("mesh {} is concave: contacts see its convex hull, of {:.3g} times its "
                                    "volume; it is not split, so give convex parts, one geometry each, where "
                                    "that matters",
                                    name, 1 / mesh.filled));
  if (!geom.visual && mesh.missing > 0)
    element.note(
        notes, fmt::format("mesh {}: its hull has {} corners, and is up to {:.2g} m inside of the mesh", name,
                           mesh.corners.size(), mesh.missing));
  geom.kind = GeomKind::mesh;
  geom.points = mesh.corners;
  geom.solid = mesh.solid;
  return true;
}

bool RobotMeshes::is_there(const fs::path& file) const {
  try {
    if (may_read_) may_read_(file);
  } catch (const Error&) {
    return false;  // what may not be read is nowhere: a robot does not learn whether it exists
  }
  std::error_code error;
  return fs::exists(file, error);
}

fs::path RobotMeshes::find(const std::string& name, const fs::path& folder, std::string& problem) const {
  constexpr std::string_view kPackage = "package://", kModel = "model://", kFile = "file://";
  std::string_view rest = name;
  if (rest.starts_with(kFile)) return fs::path(rest.substr(kFile.size()));
  if (!rest.starts_with(kPackage) && !rest.starts_with(kModel)) return folder / name;
  rest.remove_prefix(rest.starts_with(kPackage) ? kPackage.size() : kModel.size());
  rest.remove_prefix(std::min(rest.find_first_not_of('/'), rest.size()));  // some write package:///
  const fs::path path(rest);
  if (climbs(path) || path.empty()) {
    problem = fmt::format("{} leads out of its package", in_quotes(name));
    return {};
  }
  const fs::path package = *path.begin(), inside = path.lexically_relative(package);
  std::error_code error;
  fs::path above = fs::absolute(folder.empty() ? "." : folder, error).lexically_normal();
  if (above.filename().empty()) above = above.parent_path();
  for (int level = 0; level < 8; ++level) {
    if (above.filename() == package && is_there(above / inside)) return above / inside;
    if (is_there(above / path)) return above / path;
    if (is_there(above / inside)) return above / inside;
    if (above == above.parent_path()) break;
    above = above.parent_path();
  }
  problem = fmt::format("{}: no such file in a folder {} here or above", in_quotes(name),
                        in_quotes(package.string()));
  return {};
}

}  // namespace pabd
