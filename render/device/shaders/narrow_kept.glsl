// SPDX-License-Identifier: MIT
// Contacts of two boxes: those of the face that was kept (box_face.inl), then those of edges and corners.
#define KEEPS_OTHERWISE

int contacts_found() { return kept_count + found_count; }
FoundContact found_contact(int k) {
  if (k >= kept_count) return added_contact(k - kept_count);
  wide3 y_a = wide3(0), n = wide3(0);
  wide d = 0;
  uint feature = 0u;
  bool of_second = kept_contact(k, y_a, n, d, feature);
  return FoundContact(y_a + d * n, n, d, feature | (of_second ? SECOND_OWNS : 0u));
}
