// SPDX-License-Identifier: MIT
// sphere_plane.cpp.
void find_contacts(Placed first, Placed second, double reach) {
  put_first(PLANE, first, second);
  dvec4 plane = shapes[first.shape].size;
  double radius = shapes[second.shape].size.x;
  double d = dot(plane.xyz, second.c - first.c) - plane.w - radius;
  if (d < reach) add_contact(false, second.c - radius * plane.xyz, plane.xyz, d, 0u);
}
