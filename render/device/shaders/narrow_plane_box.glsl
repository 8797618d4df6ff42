// SPDX-License-Identifier: MIT
// box_plane.cpp. Which corners touch is kept, not the contacts.
#define KEEPS_OTHERWISE
uint touching_corners = 0u;  // a bit each

wide corner_height(uint corner) {
  wide3 n = size_of(a).xyz;
  return dot(n, b.c - a.c) + dot(corner_signs(corner), (n * b.R) * size_of(b).xyz);
}

void find_contacts(wide reach) {
  touching_corners = 0u;
  for (uint corner = 0u; corner < 8u; ++corner) {
    if (corner_height(corner) < reach) touching_corners |= 1u << corner;
  }
}

int contacts_found() { return bitCount(touching_corners); }
FoundContact found_contact(int k) {
  uint left = touching_corners;
  for (int i = 0; i < k; ++i) left &= left - 1u;
  uint corner = uint(findLSB(left));
  return FoundContact(b.c + b.R * (size_of(b).xyz * corner_signs(corner)), size_of(a).xyz, corner_height(corner),
                      corner | (found_swapped ? SECOND_OWNS : 0u));
}
