// SPDX-License-Identifier: MIT
// Whether a step is to be made again in halves (sim/solver/halving.h): the whole of it, as nobody knows here who hangs
// together with whom. So of many bodies (contacts) a few that are not solved are left: SHARE of those in touch.

float from_ordered(uint bits) {
  return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

bool ran_away() {
  if (counters.width[3] == 0u || !(counters.gained > 0)) return false;  // width: nothing touched
  vec3 width;
  for (int axis = 0; axis < 3; ++axis)
    width[axis] = from_ordered(counters.width[3 + axis]) - from_ordered(~counters.width[axis]);
  const float most = 100 * (length(width) + uintBitsToFloat(counters.opening)) / float(params.h);
  return !(uintBitsToFloat(counters.fastest) <= most * most);
}

bool ends_unsolved() {
  if (counters.bad > 0u) return true;
  if (counters.done == 0u && float(counters.unsolved) > SHARE * float(counters.touched)) return true;
  if (counters.done == 0u && float(counters.unsettled_contacts) > SHARE * float(counters.contacts)) return true;
  if (float(counters.late) > SHARE * float(counters.contacts)) return true;
  const double left = 100 * double(uintBitsToFloat(counters.residual)) * counters.stored;
  return !(counters.rise <= RISE * (counters.kinetic + counters.stored) + left);
}
