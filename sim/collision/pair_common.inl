// SPDX-License-Identifier: MIT
// What the texts of pairs share.

int next_axis(int k) { return k == 2 ? 0 : k + 1; }
wide3 unit(wide3 v) { return v / sqrt(dot(v, v)); }
wide sign_of(wide x) { return x < 0 ? -1.0 : 1.0; }
wide3 unit_axis(int k) { return wide3(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0); }
// Corner k of a box has a positive coordinate where the bit is set.
wide3 corner_signs(uint k) {
  return wide3((k & 1u) != 0u ? 1 : -1, (k & 2u) != 0u ? 1 : -1, (k & 4u) != 0u ? 1 : -1);
}
// The lower one among equals.
int largest_axis(wide3 v) {
  int axis = v.y > v.x ? 1 : 0;
  return v.z > (axis == 1 ? v.y : v.x) ? 2 : axis;
}

// A face is preferred to an edge, and the face of the first body to the other one, unless the rival's separation is better
// by this much: otherwise resting stacks would change their reference face at every rounding error.
wide preference(wide separation, wide smallest_half) { return 0.02 * abs(separation) + 1.0e-3 * smallest_half; }

// Is the normal n of an edge pair nearly that of a face, w (unit)? If the face comes as near, its contacts are taken: they
// have all places that are about as near, where the edges have one.
bool is_nearly_along(wide3 n, wide3 w) {
  wide3 across = cross(n, w);
  return dot(across, across) <= 0.1 * 0.1 * dot(n, n);
}

// A unit vector normal to the unit vector u: +y where u allows it.
wide3 any_normal(wide3 u) {
  wide3 seed = abs(u.y) < 0.9 ? wide3(0, 1, 0) : wide3(1, 0, 0);
  return unit(seed - dot(seed, u) * u);
}
