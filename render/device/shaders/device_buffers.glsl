// SPDX-License-Identifier: MIT
// Every array of the solver, once, and none under two names. A program sees those that it names: #define USES_POSES …
// Where a program reads much before it writes, with ACCESS restrict: then no element of them is handed to a function,
// which one driver refuses.
#ifndef ACCESS
#define ACCESS
#endif
#define AT(slot) layout(std430, binding = slot) ACCESS

AT(0) readonly buffer Params { StepParams params; };
#ifdef USES_COUNTERS
AT(1) buffer CounterBlock { Counters counters; };
#endif
#ifdef USES_KINDS
AT(2) readonly buffer Kinds { BodyKind kinds[]; };
AT(3) readonly buffer KindOf { uint kind_number[]; };  // a body
#endif
#ifdef USES_POSES
AT(4) buffer Poses { Pose pose[]; };  // a body
#endif
#ifdef USES_MOTIONS
AT(5) buffer Motions { Motion motion[]; };
#endif
#ifdef USES_FLIGHTS
AT(6) buffer Flights { Flight flight[]; };
#endif
#ifdef USES_PLACES
AT(7) buffer Places { Place place[]; };
#endif
#ifdef USES_BOUNDS
AT(8) buffer Boxes { vec4 bounds[]; };  // two a body: lowest, highest corner; w of the first: level
#endif
#ifdef USES_CELLS
AT(9) buffer CellFirst { uint cell_first[]; };  // a bucket; then one more
AT(10) buffer CellBodies { uvec4 cell_body[]; };  // body and its cell; level in the upper bits of the body
#endif
#ifdef USES_PAIR_FIRST
AT(11) buffer PairFirst { uint pair_first[]; };  // a body: its first pair; then one more
#endif
#ifdef USES_PAIRS
AT(12) buffer Pairs { Pair pairs[]; };
#endif
#ifdef USES_RAW
AT(13) buffer Raw { Contact raw[]; };  // as the narrow phase leaves them: a pair's side by side, pairs in any order
#endif
#ifdef USES_CONTACTS
AT(14) buffer Contacts { Contact contacts[]; };  // in the order of the pairs
#endif
#ifdef USES_GRIPS
AT(15) buffer Grips { Grip grips[]; };
#endif
#ifdef USES_CONTACT_FIRST
AT(16) buffer ContactFirst { uint contact_first[]; };  // a pair; then one more
#endif
#ifdef USES_END_FIRST
AT(17) buffer EndFirst { uint end_first[]; };  // a body; then one more
#endif
#ifdef USES_ENDS
// Contacts at the body, in order; lowest bit: the body owns the normal. y: the other body, which is looked up beside the
// contact then, not after it.
AT(18) buffer Ends { uvec2 ends[]; };
#endif
#ifdef USES_COLORS
AT(19) buffer ColorOf { uint color_of[]; };  // a body: color + 1, 0: none; from bit 8 on: round that gave it
AT(20) buffer Order { uint order[]; };      // bodies by list
#define USES_ARGUMENTS
#endif
#ifdef USES_ARGUMENTS
AT(21) buffer Arguments { uvec4 arguments[]; };  // of indirect dispatch: a list, then two kinds of shapes
#endif
#ifdef USES_TOUCHING
AT(39) buffer Touching { uint touching[]; };  // lists of pairs: device_lists.glsl
#endif
#ifdef USES_CURSORS
AT(22) buffer Cursors { uint cursor[]; };  // where the next of a list goes
#endif
#ifdef USES_STEPS
AT(23) buffer Steps { real4 last_step[]; };  // two a body: last step of a sweep, its factor; turn, the way
#endif
#ifdef USES_KEPT_PAIRS
AT(24) buffer KeptFirst { uint kept_first[]; };  // pair_first of the last step
AT(25) buffer KeptPairs { Pair kept_pairs[]; };
#endif
#ifdef USES_KEPT_STRETCH
AT(26) buffer KeptStretch { real4 kept_stretch[]; };  // frame of the owner. w: 1 held, 0 not
#endif
#ifdef USES_KEPT_FEATURE
AT(27) buffer KeptFeature { uint kept_feature[]; };
#endif
#ifdef USES_VALUES
AT(28) buffer Values { uint values[]; };  // summed up in place
AT(29) buffer Sums { uint sums[]; };
#endif
#ifdef USES_PLANES
AT(32) readonly buffer PlaneBodies { uint plane_body[]; };
AT(33) readonly buffer Skips { uvec2 skip[]; };  // pairs that never meet, sorted
AT(34) buffer Huge { uint huge_body[]; };
#endif
#ifdef USES_PARTS
AT(35) buffer Parts { dvec4 part[]; };  // sums of work groups
#endif
#ifdef USES_GEOMETRY
AT(37) buffer RawGeometry { ContactGeometry raw_geometry[]; };  // as Raw
AT(38) buffer KeptGeometry { ContactGeometry kept_geometry[]; };  // as KeptStretch
#endif
#ifdef USES_BODY_VALUES
AT(40) buffer BodyValues { uint body_value[]; };  // bits of a float
#endif
#ifdef USES_OUTCOMES
AT(41) buffer Outcomes { Outcome outcome[]; };  // a body that moves
#endif
#ifdef USES_TOLD
AT(36) buffer Told { ContactTold contact_told[]; };
#endif
