// SPDX-License-Identifier: MIT
// What the shaders of the solver share: numbers, records, parameters, counters. `real` is float, or double for tests
// against the processor's solver.
//
// A step works in displacements since its start, which are small and keep their digits in float wherever the scene
// lies: u, the way of the centre of mass, and q, the rotation since then as a quaternion (x, y, z, w).

layout(local_size_x = GROUP) in;

// Body: where it stands, in double, world.
struct Pose {
  dvec4 c;  // centre of mass; m
  dvec4 q;  // rotation, body to world
};
struct Motion {
  real4 v;      // m/s
  real4 omega;  // rad/s, world
};
// Bodies alike in all that matters to a step.
struct BodyKind {
  double J[6];      // second moment: xx yy zz xy xz yz; kg m²
  double half_[3];  // box: half edges; capsule: radius, half length of its axis; plane: normal; else bounding radius; m
  double mass;      // kg
  double bounding;  // radius; m
  double inner;     // how deep a thing may travel into it in a step
  double rolling;   // radius of a round body, 0 of a flat one
  double core;      // how far the core reaches that a turn moves; plane: its offset
  double mu_static, mu_dynamic;  // friction of its own; -1: none
  int shape;        // row of the table of shapes
  int form;         // BOX …
  int symmetry;     // axis of J: 0, 1, 2; 3: all are alike; -1: none
  int fixed_;
  int round_about_y;
  int pad_;
  uvec2 groups, avoids;  // bits: those it is of, those it never touches
};
// Free flight of a body.
struct Flight {
  real4 u, q;       // predicted pose Q*, since the start of the step. u.w: how far the surface turns, at most; m
  real4 v, omega;   // with it; omega.w: radius that turns are measured with
  real4 turn;       // rotation vector of the flight; rad. w: reach beyond the surface; m
  real4 W_diag, W_off;  // R* J R*ᵀ: xx yy zz, xy xz yz; kg m². W_diag.w: mass
};
struct Place {
  real4 u, q;  // u.w: mass, 0 for who does not move
};
// Where a body is when the step is done, and how it moves.
struct Outcome {
  real4 u, q, v, omega;
};
// A candidate: bodies whose bounds meet. `emitter` lists it.
struct Pair {
  uint emitter, other;
  uint first, count;  // contacts: of the raw ones, then of the placed
  // Where its contacts were found: the other body as the emitter sees it. seen.w: within which reach; < 0: never
  real4 seen, turned;
};
const uint KEPT_CONTACTS = 0x80000000u;  // in count: those of the last step stand for this one
// A contact in the frames of its bodies, for as long as it is kept: normal and offset of a's plane, b's point.
struct ContactGeometry {
  real4 plane, point;
};
// A contact of S(17), at the start of the step, world axes.
struct Contact {
  uvec4 id;     // a (owner of the normal), b, feature, number of its geometry
  real4 n;      // w: d where the step starts
  real4 r_b;    // from b's centre to its normal point. w: shift of the barrier while overlap recovers
  real4 apart;  // from a's centre to b's. w: scale of the barrier
  real4 before; // slip that the step starts with: stretch, and what rolls. w: μ
#ifdef ROUND
  real4 r_a;    // from a's centre to its normal point
  real4 round_; // ContactPoint::round_a, round_b; the levers of friction
#endif
};
// What moves of it: x: friction bound; y: change it last asked for; z: gain. In the end y: friction; z: energy; w: d.
#define Grip real4

// A contact for whoever asks.
struct ContactTold {
  uvec4 ends;      // a, b, 1 where friction holds
  dvec4 y_b;       // w: d
  dvec4 n;         // w: normal force
  dvec4 friction;  // on b. w: μ
};

struct StepParams {
  double gravity[3];
  double least_load;   // of a contact that counts as loaded, N; the same of a kilogram
  double weight_per_mass;
  double least_share, h, d_hat, kappa, k_t, mu_static, mu_dynamic, onset, recovery_speed, cell;
  int N, barrier, first_step, color_limit;
  uint bodies, buckets, planes, skips;
  uint pair_room, contact_room;
  int friction_rule;  // GEOMETRIC_MEAN …; -1: no body has friction of its own
  uint groups;        // 1: some keep bodies apart
  uint shares;  // a bit each: those that are dispatched
  uint halves;  // 1: a step that ends unsolved is not made
  uint second_order;  // 1: what feels nothing flies along a parabola
};
// Barriers and shapes have the numbers of BarrierKind and DeviceShape: BARRIER_even, FORM_BOX, … are macros.

const uint LEVELS = 16u;  // of the grid; the last one is no grid: whoever is too large for the others
const uint COLORS = 128u;
// Bodies are relaxed in lists, one a color and share. How many threads share a body hangs on how many contacts it has.
const uint SHARES = 3u;  // few contacts; more than FEW; more than CROWD, for a whole work group
const uint SWEEP_LISTS = SHARES * COLORS;
uint share_of(uint ends) {
  return ends > CROWD ? 2u : ends > FEW ? 1u : 0u;
}
struct Counters {
  uint overflow;  // what was too small, a bit each: the step was not made. Not cleared with the rest
  uint pairs, contacts, raw;
  uint level[LEVELS];
  uint huge_next, uncolored, colors, rounds;
  uint crowded;  // bodies
  uint list_size[SWEEP_LISTS], list_first[SWEEP_LISTS], list_next[SWEEP_LISTS];
  uint residual, unsettled;  // of the sweep: longest step, worst friction; bits of floats
  uint done;      // the sweeps may end
  uint sweeps;
  uint pushing;   // contacts with d < d̂
  uint min_gap;   // inverted, so that the largest is the least gap; 0: there is none
  uint force, friction_excess, friction_error;  // floats, ordered; the largest normal force
  uint bad;  // bodies that left the numbers
  uint kept;  // pairs whose contacts were kept
  // Of a step at the iteration limit: bodies in touch, those whose last move was too long, contacts whose friction is off.
  uint touched, unsolved, unsettled_contacts;
  uint late;  // overlaps where the step ends that it has no contact for
  uint touch_size[TWO_KINDS], touch_first[TWO_KINDS], touch_next[TWO_KINDS];  // pairs of two kinds, SHAPE_KINDS i + j
  uint again_size[2u * ROUNDS * TWO_KINDS];  // of them, in the lists that follow: device_lists.glsl
  // Of bodies in touch, to tell a step that ran away (sim/solver/runaway.h). Where they started: the largest of the
  // inverted lowest corner, then of the highest; floats, ordered. Widest opening; largest speed² of one that gained: 2K/m
  uint width[6];
  uint opening, fastest;
  double gained;  // kinetic energy beside that of free flight
  double stored, rise;  // elastic where the step starts, and how much more it is in the end (sim/solver/energy_bound.h)
  double kinetic, potential, elastic;
};
// Arguments of an indirect dispatch of that many work groups, for n things. OpenGL grants 65535 in a row: more make rows.
const uint ROW = 32768u;
uvec4 dispatch_of(uint groups, uint n) {
  return uvec4(min(groups, ROW), (groups + ROW - 1u) / ROW, 1u, n);
}
uint work_group() {
  return gl_WorkGroupID.y * ROW + gl_WorkGroupID.x;
}

const uint TOO_MANY_PAIRS = 1u, TOO_MANY_CONTACTS = 2u, TOO_MANY_COLORS = 4u, TOO_FEW_ROUNDS = 8u,
           SHARE_UNEXPECTED = 16u,  // shifted by the share
           ENDED_UNSOLVED = 128u, LOOPS_CUT = 256u;

// A float as bits that are in the order of the values.
uint ordered(float x) {
  const uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
