// SPDX-License-Identifier: MIT
// See body_mesh.h.
#include "app/export/body_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "render/visual/body_parts.h"
#include "render/visual/primitive_mesh.h"

namespace pabd {
namespace {

// What the renderer leaves of a colour on the dark fields of a checker (surface.frag.glsl).
constexpr float kDark = 0.35f;

struct Corner {
  Vec3f position, normal;
};
using Polygon = std::vector<Corner>;

// The part of a convex polygon with sign · position[axis] ≥ 0. What lies in the plane between is on the positive side.
Polygon clipped(const Polygon& polygon, int axis, float sign) {
  const bool between = std::all_of(polygon.begin(), polygon.end(),
                                   [&](const Corner& corner) { return corner.position[axis] == 0; });
  if (between && sign < 0) return {};
  Polygon out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const float x = sign * a.position[axis], y = sign * b.position[axis];
    if (x >= 0) out.push_back(a);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) {
      const float t = x / (x - y);
      out.push_back({a.position + t * (b.position - a.position), (a.normal + t * (b.normal - a.normal))});
      out.back().position[axis] = 0;
      out.back().normal.normalize();
    }
  }
  return out;
}

class Collector {
 public:
  Collector(const BodyParts& parts, int level) : parts_(parts), level_(level) {}

  BodyMesh mesh_of(const Shape& shape, BodyParts::Range range, bool checker) {
    std::vector<SurfacePart> surface;  // as body_parts() took it, part by part
    kind_of(shape).surface(shape, surface);
    BodyMesh out;
    for (std::uint32_t k = 0; k < range.count; ++k)
      add(parts_.parts[range.first + k], surface[k].form == SurfaceForm::tube, checker, out);
    return out;
  }

 private:
  static void append(const Corner& corner, const BodyPart& part, BodyMesh& out) {
    const Vec3f size = part.size;
    out.positions.push_back(part.at + size.cwiseProduct(corner.position));
    out.normals.push_back(corner.normal.cwiseQuotient(size).normalized());
  }

  // `tube`: without the flat ends, which would close off the inside.
  void add(const BodyPart& part, bool tube, bool checker, BodyMesh& out) {
    if (part.primitive == Primitive::mesh) {
      const MeshData& data = *parts_.meshes[static_cast<std::size_t>(part.mesh)];
      Polygon corners;
      for (std::size_t k = 0; k < data.corners.size(); ++k)
        corners.push_back({data.corners[k], data.normals[k]});
      std::vector<std::uint32_t> order(corners.size());
      for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
      return add(corners, order, part, checker, out);
    }
    const Mesh mesh = make_mesh(part.primitive, level_);
    Polygon corners;
    for (const MeshVertex& v : mesh.vertices) corners.push_back({Vec3f(v.position), Vec3f(v.normal)});
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t index : mesh.indices)
      if (!tube || std::abs(mesh.vertices[index].normal[1]) < 0.5f) indices.push_back(index);
    add(corners, indices, part, checker, out);
  }

  static void add(const Polygon& corners, const std::vector<std::uint32_t>& indices, const BodyPart& part,
                  bool checker, BodyMesh& out) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    if (!checker) {
      for (const Corner& corner : corners) append(corner, part, out);
      for (const std::uint32_t index : indices) out.light.push_back(first + index);
      return;
    }
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3)
      add_eighths({corners[indices[k]], corners[indices[k + 1]], corners[indices[k + 2]]}, part, out);
  }

  // A checker has light and dark eighths of space about the primitive's middle. On the flat side of a box the third
  // coordinate is that side's, so that neighbouring sides take turns as well.
  static void add_eighths(const Polygon& triangle, const BodyPart& part, BodyMesh& out) {
    for (int eighth = 0; eighth < 8; ++eighth) {
      Polygon piece = triangle;
      for (int axis = 0; axis < 3; ++axis) piece = clipped(piece, axis, (eighth >> axis) & 1 ? 1.0f : -1.0f);
      if (piece.size() < 3) continue;
      const bool dark = ((eighth & 1) + (eighth >> 1 & 1) + (eighth >> 2)) % 2 == 1;
      auto& list = dark ? out.dark : out.light;
      const auto first = static_cast<std::uint32_t>(out.positions.size());
      for (const Corner& corner : piece) append(corner, part, out);
      for (std::uint32_t k = 1; k + 1 < piece.size(); ++k) {
        if (!has_area(out.positions[first], out.positions[first + k], out.positions[first + k + 1])) continue;
        for (const std::uint32_t j : {0u, k, k + 1}) list.push_back(first + j);
      }
    }
  }

  // What an eighth only touches leaves an edge or a corner there.
  static bool has_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f u = b - a, v = c - a;
    return u.cross(v).norm() > 1e-5f * std::max(u.squaredNorm(), v.squaredNorm());
  }

  const BodyParts& parts_;
  int level_;
};

// Equal materials are one.
class Materials {
 public:
  explicit Materials(std::vector<Vec4f>& all) : all_(all) {}

  int number_of(const Vec4f& color) {
    const auto [at, is_new] = known_.try_emplace({color[0], color[1], color[2], color[3]}, all_.size());
    if (is_new) all_.push_back(color);
    return static_cast<int>(at->second);
  }

 private:
  std::vector<Vec4f>& all_;
  std::map<std::array<float, 4>, std::size_t> known_;
};

}  // namespace

MeshedBodies mesh_bodies(const Model& model, const std::vector<BodyLook>& looks, int segments) {
  const int* level = std::find(kSegments, kSegments + kLevels, segments);
  assert(level != kSegments + kLevels);
  VisualOptions options;
  options.looks = looks;
  // body_parts() leaves out what can be seen through, as that is drawn in an order.
  for (BodyLook& look : options.looks) look.opacity = 1;
  const BodyParts parts = body_parts(model, options);
  Collector collector(parts, static_cast<int>(level - kSegments));

  MeshedBodies out;
  Materials materials(out.materials);
  std::map<std::pair<std::uint32_t, bool>, int> known;
  for (std::size_t i = 0; i < model.name.size(); ++i) {
    const BodyLook look = i < looks.size() ? looks[i] : BodyLook{};
    MeshedBody body{.name = model.name[i], .fixed = model.fixed[i] != 0};
    Vec4f color = parts.colors[i];
    color.w() = static_cast<float>(look.opacity);
    body.material = materials.number_of(color);
    if (parts.of_body[i].count > 0) {
      const auto [at, is_new] =
          known.try_emplace({parts.of_body[i].first, look.checker}, static_cast<int>(out.meshes.size()));
      if (is_new) out.meshes.push_back(collector.mesh_of(model.shape[i], parts.of_body[i], look.checker));
      body.mesh = at->second;
      if (look.checker) {
        color.head<3>() *= kDark;
        body.dark_material = materials.number_of(color);
      }
    }
    out.bodies.push_back(std::move(body));
  }
  return out;
}

BodyMesh plane_mesh(const Plane& plane, const Vec3& around, double half) {
  const Vec3 n = plane.normal;
  const Vec3 middle = around - (n.dot(around) - plane.offset) * n;
  const Vec3 u = (std::abs(n.x()) < 0.9 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ())).cross(n).normalized();
  const Vec3 v = n.cross(u);
  BodyMesh out;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    out.positions.push_back((middle + half * (a * u + b * v)).cast<float>());
    out.normals.push_back(n.cast<float>());
  }
  out.light = {0, 1, 2, 0, 2, 3};
  return out;
}

}  // namespace pabd
