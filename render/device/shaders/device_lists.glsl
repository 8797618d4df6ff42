// SPDX-License-Identifier: MIT
// Lists of pairs by the kinds of their shapes: the threads of a work group of the narrow phase do the same then. List 0 is
// of all whose contacts are looked for; list r, up to ROUNDS − 1, of those that are looked at again elsewhere on their way
// after r times; list ROUNDS of those that need more; list ROUNDS + 1 + r of those of list r that are near each other, in
// the place of those of the round before.
const uint NO_LISTED = 0xffffffffu;

uint list_room(uint list, uint kinds_) {
  return min(list, ROUNDS + 1u) * params.pair_room + counters.touch_first[kinds_];
}
uint list_size(uint list, uint kinds_) {
  return list == 0u ? counters.touch_size[kinds_] : counters.again_size[(list - 1u) * TWO_KINDS + kinds_];
}
void add_to_list(uint list, uint kinds_, uint p) {
  touching[list_room(list, kinds_) + atomicAdd(counters.again_size[(list - 1u) * TWO_KINDS + kinds_], 1u)] = p;
}
uint arguments_of_list(uint list, uint kinds_) { return SWEEP_LISTS + list * TWO_KINDS + kinds_; }
uint kinds_of_pair(uint p) {
  const uint i = uint(kinds[kind_number[pairs[p].emitter]].form), j = uint(kinds[kind_number[pairs[p].other]].form);
  return SHAPE_KINDS * min(i, j) + max(i, j);
}
// The pair of this thread.
uint listed_pair(uint list, uint kinds_) {
  const uint n = work_group() * TOUCH_GROUP + gl_LocalInvocationID.x;
  return n < list_size(list, kinds_) ? touching[list_room(list, kinds_) + n] : NO_LISTED;
}

// What is kept of a pair on its way from round to round, where see() puts what is kept from step to step.
struct Way {
  real part;  // part_of_way
  int steps;
  bool other_side;
  double least_start_d;
  bool swapped;  // the body of the higher number goes first
};
const real ON_ITS_WAY = real(-2.0lf);  // seen.w
void put_way(uint p, Way way) {
  const real high = real(way.least_start_d), middle = real(way.least_start_d - double(high));
  const real low = real(way.least_start_d - double(high) - double(middle));  // three floats hold a double
  pairs[p].seen = real4(way.part, real(way.steps), way.other_side ? real(1) : real(0), ON_ITS_WAY);
  pairs[p].turned = real4(high, middle, low, way.swapped ? real(1) : real(0));
}
Way got_way(uint p) {
  const real4 seen = pairs[p].seen, turned = pairs[p].turned;
  return Way(seen.x, int(seen.y), seen.z != 0, double(turned.x) + double(turned.y) + double(turned.z), turned.w != 0);
}
