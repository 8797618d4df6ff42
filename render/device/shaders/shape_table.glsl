// SPDX-License-Identifier: MIT
// The shapes of a model, each once (shape_table.h has the same layout). Lengths in metres, body frame.
#ifndef SHAPES_BINDING
#define SHAPES_BINDING 0
#endif
#ifndef HULLS_BINDING
#define HULLS_BINDING 1
#endif

const int BOX = 0, SPHERE = 1, CAPSULE = 2, PLANE = 3, HULL = 4, COMPOUND = 5;

// size: box      half edges, the smallest of them
//       sphere   radius
//       capsule  radius, length of the straight part along y
//       plane    unit normal, offset
//       hull, compound  bounding radius, 0, 0, inner radius
// The rest is of boxes and hulls: where the polyhedron begins in `hull_words`, and how much of each it has. `ends`, of a
// hull that stands for a cylinder or a cone, else 0: where height and radius of the lower end, then of the upper one are.
struct ShapeRecord {
  dvec4 size;
  uint kind, first, vertices, faces, corners, edges, ends, parts;
};

// `parts` of a compound begin at `first`: offset (3 doubles), (number of its hull in `shapes`, 0).

layout(std430, binding = SHAPES_BINDING) readonly buffer Shapes { ShapeRecord shapes[]; };
// Of a polyhedron: vertices (3 doubles each), faces (normal, offset, (first corner, count)), corners of the faces
// (vertex, edge that leaves it), edges ((from, to), (left, right)); a pair of whole numbers is the bits of a double. All
// boxes are the first one, of half edges 1.
layout(std430, binding = HULLS_BINDING) readonly buffer Hulls { double hull_words[]; };
