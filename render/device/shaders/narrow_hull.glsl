// SPDX-License-Identifier: MIT
// hull_view.cpp: a convex polyhedron, hull or box, in its own frame.
struct HullView {
  uint vertex_at, face_at, corner_at, edge_at;  // in hull_words
  uint vertices, faces, edges;
  bool is_box;
  wide3 scale;  // of a box its half edges, else 1
  wide inner_radius;
};

struct HullFace {
  wide3 normal;
  wide offset;
  uint first, count;  // its corners
};

const wide ON_SURFACE = wide(5e-4lf);

// Every place that reads the buffer costs time to compile.
wide3 vector_at(uint at) { return wide3(hull_words[at], hull_words[at + 1u], hull_words[at + 2u]); }
uvec2 pair_at(uint at) { return unpackDouble2x32(hull_words[at]); }

HullView view_of(uint shape) {
  ShapeRecord record = shapes[shape];
  HullView view;
  view.vertices = record.vertices;
  view.faces = record.faces;
  view.edges = record.edges;
  view.vertex_at = record.first;
  view.face_at = view.vertex_at + 3u * record.vertices;
  view.corner_at = view.face_at + 5u * record.faces;
  view.edge_at = view.corner_at + record.corners;
  view.is_box = record.kind == uint(BOX);
  view.scale = view.is_box ? wide3(record.size.xyz) : wide3(1);
  view.inner_radius = wide(record.size.w);
  return view;
}

wide3 vertex_of(HullView view, uint k) { return view.scale * vector_at(view.vertex_at + 3u * k); }
wide3 normal_of(HullView view, uint f) { return vector_at(view.face_at + 5u * f); }
wide offset_of(HullView view, uint f, wide3 normal) {
  return view.is_box ? dot(abs(normal), view.scale) : wide(hull_words[view.face_at + 5u * f + 3u]);
}
HullFace face_of(HullView view, uint f) {
  wide3 normal = normal_of(view, f);
  uvec2 corners = pair_at(view.face_at + 5u * f + 4u);
  return HullFace(normal, offset_of(view, f, normal), corners.x, corners.y);
}
// Vertex, and the edge that leaves it.
uvec2 corner_of(HullView view, HullFace face, uint k) {
  return pair_at(view.corner_at + face.first + (k < face.count ? k : k - face.count));
}
// From, to, left, right.
uvec4 edge_of(HullView view, uint e) {
  return uvec4(pair_at(view.edge_at + 2u * e), pair_at(view.edge_at + 2u * e + 1u));
}

wide nearest_point(HullView hull, wide3 x, wide limit, out wide3 foot) {
  foot = x;
  for (uint f = 0u; f < hull.faces; ++f) {
    HullFace face = face_of(hull, f);
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
    wide3 y = p + clamp(dot(along, x - p) / dot(along, along), wide(0.0lf), wide(1.0lf)) * along;
    wide apart2 = dot(x - y, x - y);
    if (apart2 < best2) {
      best2 = apart2;
      foot = y;
    }
  }
  return sqrt(best2);
}
