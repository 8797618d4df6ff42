// SPDX-License-Identifier: MIT
// The contacts of a pair, after the file that defines MOST_FOUND. Up to three are no array, which a variable index would
// put into memory.
#if MOST_FOUND <= 3
FoundContact found_0, found_1, found_2;
#else
FoundContact found[MOST_FOUND];
#endif

void add_contact(bool b_owns, wide3 y_b, wide3 n, wide d, uint feature) {
  if (found_count >= MOST_FOUND) return;
  FoundContact contact = FoundContact(y_b, n, d, feature | (b_owns != found_swapped ? SECOND_OWNS : 0u));
#if MOST_FOUND <= 3
  if (found_count == 0) found_0 = contact;
  else if (found_count == 1) found_1 = contact;
  else found_2 = contact;
#else
  found[found_count] = contact;
#endif
  ++found_count;
}

FoundContact added_contact(int k) {
#if MOST_FOUND <= 3
  if (MOST_FOUND == 1 || k == 0) return found_0;
  if (MOST_FOUND == 2 || k == 1) return found_1;
  return found_2;
#else
  return found[k];
#endif
}

#ifndef KEEPS_OTHERWISE
int contacts_found() { return found_count; }
FoundContact found_contact(int k) { return added_contact(k); }
#endif
