// SPDX-License-Identifier: MIT
// What the shaders of the pairs of shapes share. Each of them, narrow_X_Y.glsl, is the port of a file of
// sim/collision, which says what it does and why, and defines
//
//   void find_contacts(wide reach);     of the two bodies that place_pair was called for last
//   MOST_FOUND                          how many add_contact is called for, at most, before they are dropped
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

// c from an origin near the bodies, a plane's too.
void place_pair(uint shape_a, dvec3 c_a, dmat3 R_a, uint shape_b, dvec3 c_b, dmat3 R_b) {
  dvec4 plane_a = shapes[shape_a].size, plane_b = shapes[shape_b].size;
  if (shapes[shape_a].kind == uint(PLANE)) c_a = c_b - (dot(plane_a.xyz, c_b - c_a) - plane_a.w) * plane_a.xyz;
  if (shapes[shape_b].kind == uint(PLANE)) c_b = c_a - (dot(plane_b.xyz, c_a - c_b) - plane_b.w) * plane_b.xyz;
  a = Placed(wide3(c_a), mat_wide3(R_a), shape_a);
  b = Placed(wide3(c_b), mat_wide3(R_b), shape_b);
  C = mat_wide3(transpose(R_a) * R_b);
  found_count = 0;
  found_swapped = false;
}

int kind_of(Placed body) { return int(shapes[body.shape].kind); }
wide4 size_of(Placed body) { return wide4(shapes[body.shape].size); }

// Parts of a compound; anything else is its only part.
uint parts_of(uint shape) { return max(shapes[shape].parts, 1u); }
// The shape of part k, whose centre c becomes. c, R: pose of the body.
uint part_of(uint shape, uint k, inout dvec3 c, dmat3 R) {
  if (shapes[shape].kind != uint(COMPOUND)) return shape;
  uint at = shapes[shape].first + 4u * k;
  c += R * dvec3(hull_words[at], hull_words[at + 1u], hull_words[at + 2u]);
  return unpackDouble2x32(hull_words[at + 3u]).x;
}

// The body of that kind, which one of the two is, becomes a.
void put_first(int kind) {
  if (kind_of(a) == kind) return;
  Placed other = a;
  a = b;
  b = other;
  C = transpose(C);
  found_swapped = true;
}

// Of narrow_found.glsl, or of a shader that keeps its contacts otherwise.
void add_contact(bool b_owns, wide3 y_b, wide3 n, wide d, uint feature);
FoundContact added_contact(int k);
int contacts_found();
FoundContact found_contact(int k);

wide at(wide3 v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
wide3 column(mat_wide3 M, int k) { return k == 0 ? M[0] : k == 1 ? M[1] : M[2]; }
int next_axis(int k) { return k == 2 ? 0 : k + 1; }

wide3 unit(wide3 v) { return v / sqrt(dot(v, v)); }
wide sign_of(wide x) { return x < 0 ? -wide(1.0lf) : wide(1.0lf); }
wide3 signs_of(wide3 v) { return wide3(sign_of(v.x), sign_of(v.y), sign_of(v.z)); }
wide3 unit_axis(int k) { return wide3(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0); }
wide smallest_of(wide3 v) { return min(min(v.x, v.y), v.z); }
wide3 corner_signs(uint k) {
  return wide3((k & 1u) != 0u ? 1 : -1, (k & 2u) != 0u ? 1 : -1, (k & 4u) != 0u ? 1 : -1);
}

// The lower one among equals.
int largest_axis(wide3 v) {
  int axis = v.y > v.x ? 1 : 0;
  return v.z > (axis == 1 ? v.y : v.x) ? 2 : axis;
}

// Two round things; see narrow_phase.h.
void add_round_contact(bool b_owns, wide3 p_a, wide r_a, wide3 p_b, wide r_b, wide3 fallback, wide reach,
                       uint feature) {
  wide3 between = p_b - p_a;
  wide apart = sqrt(dot(between, between));
  wide d = apart - r_a - r_b;
  if (!(d < reach)) return;
  bool defined = apart > beyond_rounding(1e-12lf) * (r_a + r_b) && apart > 0;
  wide3 n = defined ? between / apart : fallback;
  add_contact(b_owns, p_b - r_b * n, n, d, feature);
}

// By how much a rival must be better than what is preferred.
wide preference(wide separation, wide smallest_half) {
  return wide(0.02lf) * abs(separation) + wide(1e-3lf) * smallest_half;
}

// Is the normal n of an edge pair nearly that of a face, w (unit)? See narrow_phase.h: its kSine is 0.1.
bool is_nearly_along(wide3 n, wide3 w) {
  wide3 across = cross(n, w);
  return dot(across, across) <= wide(0.01lf) * dot(n, n);
}

// A unit vector normal to the unit vector u: +y where u allows it.
wide3 any_normal(wide3 u) {
  wide3 seed = abs(u.y) < wide(0.9lf) ? wide3(0, 1, 0) : wide3(1, 0, 0);
  return unit(seed - dot(seed, u) * u);
}
