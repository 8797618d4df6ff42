// SPDX-License-Identifier: MIT
// box_plane.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(PLANE, first, second);
  dvec4 plane = shapes[first.shape].size;
  dvec3 n = plane.xyz, size = shapes[second.shape].size.xyz;
  dvec3 along = (n * second.R) * size;  // height of each half edge
  double centre = dot(n, second.c - first.c) - plane.w;
  if (!(centre - (abs(along.x) + abs(along.y) + abs(along.z)) < reach)) return;
  for (uint corner = 0u; corner < 8u; ++corner) {
    dvec3 signs = corner_signs(corner);
    double d = centre + dot(signs, along);
    if (d < reach) add_contact(false, second.c + second.R * (size * signs), n, d, corner);
  }
}
