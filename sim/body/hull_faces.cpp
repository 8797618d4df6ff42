// SPDX-License-Identifier: MIT
// Triangles of a hull → faces with several corners, and the checks that they make a convex polyhedron.
//
//   n, o   plane of a face, n·x = o        unit, m
//   group  triangles that share a face; grown from the largest triangle over its neighbours
#include <algorithm>
#include <map>
#include <utility>

#include "sim/body/hull_parts.h"

namespace pabd::hull_parts {
namespace {

using DirectedEdge = std::pair<int, int>;

struct Triangles {
  const std::vector<Vec3>& points;
  const std::vector<Triangle>& list;
  std::map<DirectedEdge, int> owner;  // triangle that walks the edge in this direction

  Vec3 area(int t) const {
    const Triangle& k = list[t];
    return 0.5 * (at(k[1]) - at(k[0])).cross(at(k[2]) - at(k[0]));
  }
  const Vec3& at(int vertex) const { return points[vertex]; }
};

// False when an edge is walked twice in one direction, or only in one.
bool pair_edges(Triangles& in) {
  for (std::size_t t = 0; t < in.list.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const DirectedEdge e{in.list[t][k], in.list[t][(k + 1) % 3]};
      if (!in.owner.emplace(e, static_cast<int>(t)).second) return false;
    }
  }
  return std::all_of(in.owner.begin(), in.owner.end(), [&](const auto& item) {
    return in.owner.contains({item.first.second, item.first.first});
  });
}

// The group of every triangle, numbered from the largest seed.
std::vector<int> group_triangles(const Triangles& in, double tolerance, int& groups) {
  std::vector<int> order(in.list.size()), group(in.list.size(), -1), open;
  std::vector<double> size(in.list.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    order[t] = static_cast<int>(t);
    size[t] = in.area(static_cast<int>(t)).norm();
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return size[a] > size[b]; });
  groups = 0;
  for (const int seed : order) {
    if (group[seed] >= 0) continue;
    const int number = groups++;
    const Vec3 n = in.area(seed).normalized();
    const double o = n.dot(in.at(in.list[seed][0]));
    group[seed] = number;
    open.assign(1, seed);
    while (!open.empty()) {
      const Triangle t = in.list[open.back()];
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const int next = in.owner.at({t[(k + 1) % 3], t[k]});
        if (group[next] >= 0) continue;
        const Triangle& u = in.list[next];
        const bool flat = std::all_of(u.begin(), u.end(),
                                      [&](int v) { return std::abs(n.dot(in.at(v)) - o) <= tolerance; });
        if (!flat) continue;
        group[next] = number;
        open.push_back(next);
      }
    }
  }
  return group;
}

// The rim of every group as one loop of vertices; empty when a rim is not one simple loop.
std::vector<std::vector<int>> rims(const Triangles& in, const std::vector<int>& group, int groups) {
  std::vector<std::map<int, int>> next(static_cast<std::size_t>(groups));
  for (const auto& [edge, t] : in.owner) {
    const int mine = group[t];
    const int other = group[in.owner.at({edge.second, edge.first})];
    if (mine == other) continue;
    if (!next[mine].emplace(edge.first, edge.second).second) return {};
  }
  std::vector<std::vector<int>> out;
  for (const auto& step : next) {
    std::vector<int> loop;
    if (step.empty()) return {};
    const int start = step.begin()->first;  // the lowest number: the same loop for the same input
    int v = start;
    do {
      loop.push_back(v);
      const auto it = step.find(v);
      if (it == step.end() || loop.size() > step.size()) return {};
      v = it->second;
    } while (v != start);
    if (loop.size() != step.size()) return {};
    out.push_back(std::move(loop));
  }
  return out;
}

// A vertex where only two faces meet lies within an edge of both; it goes.
void drop_straight_corners(std::vector<std::vector<int>>& loops) {
  std::map<int, int> uses;
  for (const auto& loop : loops) {
    for (const int v : loop) ++uses[v];
  }
  for (auto& loop : loops) std::erase_if(loop, [&](int v) { return uses[v] < 3; });
}

// Newell's normal: the sum of the areas of a fan, whatever the corner it starts from.
Vec3 loop_normal(const std::vector<Vec3>& x, const std::uint16_t* loop, std::size_t count) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < count; ++k) {
    sum += (x[loop[k]] - x[loop[0]]).cross(x[loop[k + 1]] - x[loop[0]]);
  }
  return sum;
}

bool add_face(const std::vector<int>& loop, const std::map<int, std::uint16_t>& number, HullData& hull) {
  if (loop.size() < 3) return false;
  HullFace face;
  face.first = static_cast<std::uint16_t>(hull.loop.size());
  face.count = static_cast<std::uint16_t>(loop.size());
  for (const int v : loop) hull.loop.push_back(number.at(v));
  const std::uint16_t* corner = &hull.loop[face.first];
  const Vec3 area = loop_normal(hull.vertices, corner, face.count);
  if (!(area.norm() > 1e-14)) return false;
  face.normal = area.normalized();
  face.offset = -1e300;
  for (std::size_t k = 0; k < face.count; ++k) {
    face.offset = std::max(face.offset, face.normal.dot(hull.vertices[corner[k]]));
  }
  hull.faces.push_back(face);
  return true;
}

// No vertex above a face, and every loop turns left at every corner.
bool is_convex(const HullData& hull, double tolerance) {
  for (const HullFace& face : hull.faces) {
    for (const Vec3& x : hull.vertices) {
      if (!(face.normal.dot(x) - face.offset <= tolerance)) return false;
    }
    for (std::size_t k = 0; k < face.count; ++k) {
      const auto corner = [&](std::size_t j) {
        return hull.vertices[hull.loop[face.first + j % face.count]];
      };
      const Vec3 in = corner(k + 1) - corner(k), out = corner(k + 2) - corner(k + 1);
      if (!(in.cross(out).dot(face.normal) > -tolerance * (in.norm() + out.norm()))) return false;
    }
  }
  return true;
}

}  // namespace

bool add_edges(HullData& hull) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> edges;  // by (from, to)
  hull.loop_edge.assign(hull.loop.size(), 0);
  std::size_t closed = 0;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const HullFace& face = hull.faces[f];
    for (std::size_t k = 0; k < face.count; ++k) {
      const std::size_t here = face.first + k;
      const std::uint16_t p = hull.loop[here], q = hull.loop[face.first + (k + 1) % face.count];
      if (const auto twin = edges.find({q, p}); twin != edges.end()) {
        HullEdge& edge = hull.edges[twin->second];
        if (edge.right != edge.left) return false;
        edge.right = static_cast<std::uint16_t>(f);
        hull.loop_edge[here] = twin->second;
        ++closed;
        continue;
      }
      const auto id = static_cast<std::uint16_t>(hull.edges.size());
      if (!edges.emplace(std::pair{p, q}, id).second) return false;
      hull.edges.push_back({p, q, static_cast<std::uint16_t>(f), static_cast<std::uint16_t>(f)});
      hull.loop_edge[here] = id;
    }
  }
  const bool sphere = hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2;  // Euler
  return sphere && closed == hull.edges.size();
}

std::optional<HullData> merge_faces(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                    double tolerance) {
  Triangles in{points, triangles, {}};
  if (triangles.size() < 4 || !pair_edges(in)) return std::nullopt;
  int groups = 0;
  const std::vector<int> group = group_triangles(in, tolerance, groups);
  std::vector<std::vector<int>> loops = rims(in, group, groups);
  drop_straight_corners(loops);

  HullData hull;
  std::map<int, std::uint16_t> number;  // of the remaining vertices, in the order of the points
  for (const auto& loop : loops) {
    for (const int v : loop) number.emplace(v, std::uint16_t{0});
  }
  if (number.size() < 4 || number.size() > 20000) return std::nullopt;
  for (auto& [v, id] : number) {
    id = static_cast<std::uint16_t>(hull.vertices.size());
    hull.vertices.push_back(in.at(v));
  }
  for (const auto& loop : loops) {
    if (!add_face(loop, number, hull)) return std::nullopt;
  }
  if (!add_edges(hull) || !is_convex(hull, 4 * tolerance)) return std::nullopt;
  return hull;
}

}  // namespace pabd::hull_parts
