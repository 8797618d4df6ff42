// SPDX-License-Identifier: MIT
// box_sphere.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(BOX, first, second);
  dvec4 size = shapes[first.shape].size;
  double radius = shapes[second.shape].size.x;
  dvec3 p = (second.c - first.c) * first.R, outside = p - clamp(p, -size.xyz, size.xyz);
  double apart = sqrt(dot(outside, outside));
  dvec3 n;
  if (apart > 1e-9lf * size.w) {
    n = first.R * (outside / apart);
  } else {
    dvec3 depth = abs(p) - size.xyz;
    int axis = largest_axis(depth);
    apart = depth[axis];
    n = sign_of(p[axis]) * first.R[axis];
  }
  double d = apart - radius;
  if (d < reach) add_contact(false, second.c - radius * n, n, d, 0u);
}
