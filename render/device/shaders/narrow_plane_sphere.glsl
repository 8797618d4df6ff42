// SPDX-License-Identifier: MIT
// sphere_plane.cpp.
#define MOST_FOUND 1

void find_contacts(wide reach) {
  put_first(PLANE);
  wide4 plane = size_of(a);
  wide radius = size_of(b).x;
  wide d = dot(plane.xyz, b.c - a.c) - radius;
  if (d < reach) add_contact(false, b.c - radius * plane.xyz, plane.xyz, d, 0u);
}
