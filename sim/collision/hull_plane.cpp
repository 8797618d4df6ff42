// SPDX-License-Identifier: MIT
// Hull above a plane: its vertices within reach, a well-spread few of them. The feature is the vertex.
#include "sim/collision/narrow_phase.h"
#include "sim/collision/spread.h"

namespace pabd::narrow {

void hull_plane(const Placed<Plane>& plane, const Placed<Hull>& hull, double reach, Contacts& out) {
  const Vec3& n = plane.shape.normal;
  const HullData& data = *hull.shape.data;
  const double centre = n.dot(hull.c) - plane.shape.offset;
  if (!(centre - data.bounding_radius < reach)) return;
  const Vec3 up = hull.R.transpose() * n;

  static_assert(kMostHullVertices <= kMostCandidates);
  Vec3 x[kMostHullVertices];
  double d[kMostHullVertices];
  std::uint32_t vertex[kMostHullVertices];
  int count = 0;
  for (std::size_t v = 0; v < data.vertices.size(); ++v) {
    const double height = centre + up.dot(data.vertices[v]);
    if (!(height < reach)) continue;
    x[count] = data.vertices[v];
    d[count] = height;
    vertex[count++] = static_cast<std::uint32_t>(v);
  }
  int chosen[kMostPoints];
  const int size = choose_spread(x, d, count, reach, 1e-6 * data.inner_radius, chosen);
  for (int i = 0; i < size; ++i) {
    const int k = chosen[i];
    add_contact(out, plane.number, hull.number, hull.c + hull.R * x[k], n, d[k], vertex[k]);
  }
}

}  // namespace pabd::narrow
