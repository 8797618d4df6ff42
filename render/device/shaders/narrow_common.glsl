// SPDX-License-Identifier: MIT
// What the shaders of the pairs of shapes share. Each of them, narrow_X_Y.glsl, is the port of a file of
// sim/collision, which says what it does and why, and defines
//
//   void find_contacts(Placed first, Placed second, double reach);
//
// which leaves in found[0 … found_count) the contacts with d < reach, in no order, with the CPU's numbers.
//
// Which body is the first: the one with the lower number. It matters for two of one kind, for a capsule with a
// sphere and for a hull with a box, whose contacts depend on it; any other two may come in any order.
//
// Components of a vector are never written by a variable index: one driver cannot do that for double.
// Everything is relative to an origin near the bodies, the same for both. A plane too is where its c says, 0 in the
// world; its R does not count.
struct Placed {
  dvec3 c;
  dmat3 R;  // body to world
  uint shape;
};

// The owner a has the normal, the other body b the point. b's surface is at y_b, a's at y_b − d n.
struct FoundContact {
  dvec3 y_b, n;  // n: unit, from the owner to the other
  double d;
  uint feature;
  bool second_owns;  // the owner is the second body of the call
};

const int MOST_FOUND = 16;
FoundContact found[MOST_FOUND];
int found_count = 0;
bool found_swapped = false;  // the pair was put in the order of its shader

const double NONE = 1e300lf;  // d where there is no contact

void begin_contacts() {
  found_count = 0;
  found_swapped = false;
}

int kind_of(Placed body) { return int(shapes[body.shape].kind); }

// The body of that kind, which one of the two is, becomes the first.
void put_first(int kind, inout Placed first, inout Placed second) {
  begin_contacts();
  if (kind_of(first) == kind) return;
  Placed other = first;
  first = second;
  second = other;
  found_swapped = true;
}

void add_contact(bool second_owns, dvec3 y_b, dvec3 n, double d, uint feature) {
  if (found_count >= MOST_FOUND) return;
  found[found_count] = FoundContact(y_b, n, d, feature, second_owns != found_swapped);
  ++found_count;
}

dvec3 unit(dvec3 v) { return v / sqrt(dot(v, v)); }
double sign_of(double x) { return x < 0 ? -1.0lf : 1.0lf; }
dvec3 signs_of(dvec3 v) { return dvec3(sign_of(v.x), sign_of(v.y), sign_of(v.z)); }
dvec3 unit_axis(int k) { return dvec3(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0); }
double smallest_of(dvec3 v) { return min(min(v.x, v.y), v.z); }
dvec3 corner_signs(uint k) {
  return dvec3((k & 1u) != 0u ? 1 : -1, (k & 2u) != 0u ? 1 : -1, (k & 4u) != 0u ? 1 : -1);
}

// The lower one among equals.
int largest_axis(dvec3 v) {
  int axis = v.y > v.x ? 1 : 0;
  return v.z > (axis == 1 ? v.y : v.x) ? 2 : axis;
}

// Two round things; see narrow_phase.h.
void add_round_contact(bool second_owns, dvec3 p_a, double r_a, dvec3 p_b, double r_b, dvec3 fallback, double reach,
                       uint feature) {
  dvec3 between = p_b - p_a;
  double apart = sqrt(dot(between, between));
  double d = apart - r_a - r_b;
  if (!(d < reach)) return;
  bool defined = apart > 1e-12lf * (r_a + r_b) && apart > 0;
  dvec3 n = defined ? between / apart : fallback;
  add_contact(second_owns, p_b - r_b * n, n, d, feature);
}

// By how much a rival must be better than what is preferred.
double preference(double separation, double smallest_half) { return 0.02lf * abs(separation) + 1e-3lf * smallest_half; }

// A unit vector normal to the unit vector u: +y where u allows it.
dvec3 any_normal(dvec3 u) {
  dvec3 seed = abs(u.y) < 0.9lf ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return unit(seed - dot(seed, u) * u);
}
