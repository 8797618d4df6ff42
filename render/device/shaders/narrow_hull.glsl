// SPDX-License-Identifier: MIT
// hull_view.cpp: a convex polyhedron, hull or box, in its own frame.
struct TextHull {
  uint vertex_at, face_at, corner_at, edge_at;  // in hull_words
  uint vertices, faces, edges;
  bool is_box;
  wide3 scale;  // of a box its half edges, else 1
  wide inner_radius;
};

struct TextFace {
  wide3 normal;
  wide offset;
  uint first, count;  // its corners
};

// Every place that reads the buffer costs time to compile.
wide3 vector_at(uint at) { return wide3(hull_words[at], hull_words[at + 1u], hull_words[at + 2u]); }
uvec2 pair_at(uint at) { return unpackDouble2x32(hull_words[at]); }

TextHull view_of(uint shape) {
  ShapeRecord record = shapes[shape];
  TextHull view;
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

wide3 vertex_of(TextHull view, uint k) { return view.scale * vector_at(view.vertex_at + 3u * k); }
wide3 normal_of(TextHull view, uint f) { return vector_at(view.face_at + 5u * f); }
wide offset_of(TextHull view, uint f, wide3 normal) {
  return view.is_box ? dot(abs(normal), view.scale) : wide(hull_words[view.face_at + 5u * f + 3u]);
}
TextFace face_of(TextHull view, uint f) {
  wide3 normal = normal_of(view, f);
  uvec2 corners = pair_at(view.face_at + 5u * f + 4u);
  return TextFace(normal, offset_of(view, f, normal), corners.x, corners.y);
}
// Vertex, and the edge that leaves it.
uvec2 corner_of(TextHull view, TextFace face, uint k) {
  return pair_at(view.corner_at + face.first + (k < face.count ? k : k - face.count));
}
// From, to, left, right.
uvec4 edge_of(TextHull view, uint e) {
  return uvec4(pair_at(view.edge_at + 2u * e), pair_at(view.edge_at + 2u * e + 1u));
}
TextHull hull_of(Placed body) { return view_of(body.shape); }
