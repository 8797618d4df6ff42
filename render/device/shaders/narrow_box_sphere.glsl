// SPDX-License-Identifier: MIT
// box_sphere.cpp.
#define MOST_FOUND 1

void find_contacts(wide reach) {
  put_first(BOX);
  wide4 size = size_of(a);
  wide radius = size_of(b).x;
  wide3 p = (b.c - a.c) * a.R, outside = p - clamp(p, -size.xyz, size.xyz);
  wide apart = sqrt(dot(outside, outside));
  wide3 n;
  if (apart > beyond_rounding(1e-9lf) * size.w) {
    n = a.R * (outside / apart);
  } else {
    wide3 depth = abs(p) - size.xyz;
    int axis = largest_axis(depth);
    apart = at(depth, axis);
    n = sign_of(at(p, axis)) * column(a.R, axis);
  }
  wide d = apart - radius;
  if (d < reach) add_contact(false, b.c - radius * n, n, d, 0u);
}
