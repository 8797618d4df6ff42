// SPDX-License-Identifier: MIT
// What the texts of the pairs of shapes are compiled with here, as sim/collision/pair_text.h for the CPU. A pair, a text
// *.inl of sim/collision or narrow_X_Y.glsl, the port of a file there, defines
//
//   void find_contacts(wide reach);     of the two bodies that place_pair was called for last
//
// which leaves contacts_found() contacts with d < reach, found_contact(0) …, in no order, with the CPU's numbers.
//
// Numbers are `wide`, float or double; wide2, wide3, wide4, mat_wide3 are made of them, WIDE_EPSILON is their rounding.
// What is near is subtracted before it is rounded to them.
//
// Which body is the first: the one that goes first (sim/collision/narrow_phase.h). It matters for two of one kind and for
// a hull with a box, whose contacts depend on it; any other two may come in any order.
//
// Private memory costs more than numbers: what can be had again is not kept, and no vector or matrix is asked for a
// component by a variable index, but by at() and column(). Nor is one written so: one driver cannot do that for double.
struct Placed {
  wide3 c;      // from an origin near both bodies; of a plane its point nearest to the other's centre
  mat_wide3 R;  // body to world; of a plane nothing
  uint shape;
};
Placed a, b;  // the two bodies
mat_wide3 C;  // column j: axis j of b in the frame of a

// The owner has the normal, the other body the point. The other's surface is at y_b, the owner's at y_b − d n.
struct FoundContact {
  wide3 y_b, n;  // n: unit, from the owner to the other
  wide d;
  uint feature;  // SECOND_OWNS beside it: the owner is the second body of the call
};
const uint SECOND_OWNS = 1u << 31;

int found_count = 0;         // by add_contact
bool found_swapped = false;  // the pair was put in the order of its shader

const wide NONE = wide(1e30lf);  // d where there is no contact

// What is small beside a number of the size 1, as rounding makes it.
wide beyond_rounding(double small) { return max(wide(small), 8 * WIDE_EPSILON); }

// The order in which bodies own the normal; of two of one rank the first one goes first.
int rank_of(uint shape) {
  uint kind = shapes[shape].kind;
  return kind == uint(PLANE) ? 0 : kind == uint(CAPSULE) ? 2 : kind == uint(SPHERE) ? 3 : 1;
}

// c from an origin near the bodies, a plane's too.
void place_pair(uint shape_a, dvec3 c_a, dmat3 R_a, uint shape_b, dvec3 c_b, dmat3 R_b) {
  dvec4 plane_a = shapes[shape_a].size, plane_b = shapes[shape_b].size;
  if (shapes[shape_a].kind == uint(PLANE)) c_a = c_b - (dot(plane_a.xyz, c_b - c_a) - plane_a.w) * plane_a.xyz;
  if (shapes[shape_b].kind == uint(PLANE)) c_b = c_a - (dot(plane_b.xyz, c_a - c_b) - plane_b.w) * plane_b.xyz;
  a = Placed(wide3(c_a), mat_wide3(R_a), shape_a);
  b = Placed(wide3(c_b), mat_wide3(R_b), shape_b);
  C = mat_wide3(transpose(R_a) * R_b);
  found_count = 0;
  found_swapped = rank_of(shape_b) < rank_of(shape_a);
  if (!found_swapped) return;
  Placed other = a;
  a = b;
  b = other;
  C = transpose(C);
}

wide4 size_of(Placed body) { return wide4(shapes[body.shape].size); }
wide3 half_edges(Placed box) { return size_of(box).xyz; }
wide smallest_half(Placed box) { return size_of(box).w; }
wide radius_of(Placed body) { return size_of(body).x; }
wide half_axis(Placed capsule) { return wide(0.5lf) * size_of(capsule).y; }
wide3 plane_normal(Placed plane) { return size_of(plane).xyz; }
wide height_over(Placed plane, wide3 x) { return dot(plane_normal(plane), x - plane.c); }

// Parts of a compound; anything else is its only part.
uint parts_of(uint shape) { return max(shapes[shape].parts, 1u); }
// The shape of part k, whose centre c becomes. c, R: pose of the body.
uint part_of(uint shape, uint k, inout dvec3 c, dmat3 R) {
  if (shapes[shape].kind != uint(COMPOUND)) return shape;
  uint at = shapes[shape].first + 4u * k;
  c += R * dvec3(hull_words[at], hull_words[at + 1u], hull_words[at + 2u]);
  return unpackDouble2x32(hull_words[at + 3u]).x;
}

// Of narrow_found.glsl, or of a shader that keeps its contacts otherwise.
void add_contact(bool b_owns, wide3 y_b, wide3 n, wide d, uint feature);
FoundContact added_contact(int k);
int contacts_found();
FoundContact found_contact(int k);

wide at(wide3 v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
wide3 column(mat_wide3 M, int k) { return k == 0 ? M[0] : k == 1 ? M[1] : M[2]; }
