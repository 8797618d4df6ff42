// SPDX-License-Identifier: MIT
// The distance of a point from a convex polyhedron.

// A point less than this times the inner radius outside is taken for one on the surface: it is less than what a
// face is preferred by, and a normal from so small a difference would not be exact.
static constexpr wide ON_SURFACE = 5.0e-4;

// Point of the surface nearest to x, which lies outside; returns the distance. `limit`: gives up, with a value not below
// the limit, when x is surely that far.
wide nearest_point(TextHull hull, wide3 x, wide limit, wide3& foot) {
  foot = x;
  for (uint f = 0u; f < hull.faces; ++f) {
    TextFace face = face_of(hull, f);
    wide height = dot(face.normal, x) - face.offset;
    if (height >= limit) return height;
    if (height <= 0) continue;
    bool over = true;
    wide3 p = vertex_of(hull, corner_of(hull, face, 0u).x);
    for (uint k = 0u; k < face.count && over; ++k) {
      wide3 q = vertex_of(hull, corner_of(hull, face, k + 1u).x);
      over = dot(face.normal, cross(q - p, x - p)) >= 0;
      p = q;
    }
    if (!over) continue;
    foot = x - height * face.normal;
    return height;
  }
  wide best2 = NONE;
  for (uint e = 0u; e < hull.edges; ++e) {
    uvec4 edge = edge_of(hull, e);
    wide3 p = vertex_of(hull, edge.x), along = vertex_of(hull, edge.y) - p;
    wide3 y = p + clamp(dot(along, x - p) / dot(along, along), 0.0, 1.0) * along;
    wide apart2 = dot(x - y, x - y);
    if (apart2 < best2) {
      best2 = apart2;
      foot = y;
    }
  }
  return sqrt(best2);
}
