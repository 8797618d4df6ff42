// SPDX-License-Identifier: MIT
// The contact bond S(17) with friction S§3: energy, force and stiffness of contact points.
//
// A contact joins a point of body b to a plane of body a. Two displacements of b as seen from a decide
// everything:
//
//   d = gap + n·(p_b − p_a)                    signed distance S(17), at the normal points               m
//   u = slip + stretch                         tangential stretch, at the surface points                 m
//   E = Ψ(d) + D(‖u‖)                                                                                    J
//   D' = min(k_t ‖u‖, limit)                   stick, then slide                                         N
//
//   symbol      variable      meaning                                                             unit
//   n           n             contact normal, from a to b                                         –
//   p_a, p_b    normal_a, _b  normal points: of flat bodies where friction acts; of round ones    m
//                             the centre or axis point under the surface, one radius inside
//   r_a, r_b    radius_a, _b  radii of round bodies, 0 of flat ones                               m
//   θ_a, θ_b    –             rotation vectors of the step, R = exp(θ) R_0, of any length          rad
//   slip        –             way of the surface points past each other in the step, along the    m
//                             plane: Δ = (1 − n nᵀ)(p_b − p_a) since the start, and for round
//                             bodies Δ + n × (l_b θ_b + l_a θ_a), as their surfaces pass by
//   l_a, l_b    arm_a, arm_b  levers of friction from the normal points of round bodies              m
//   d̂, κ, N, ε  barrier       see potential/barrier.h
//   k_t         k_t           tangential stiffness, Ψ'' at the onset                              N/m
//   μ f_n       limit         largest friction force: a number while E is minimised, moved         N
//                             between iterations (solver/friction.h)
//
// The plane of a flat owner turns with it, that of a round one does not, nor does its slip follow a material point (Deviation D9).
// θ = θ* + log(R R*ᵀ), with the turn θ* of free flight, which may be several times π. A plane that turns with a sees b turn by
// θ_b − θ_a, from half way through the step: to second order what it sees on average. A force acts on a and b along one line, so
// linear and angular momentum are kept. (The supplement's point y_i is the foot of y_b on the plane.) `stretch` is carried
// from step to step (Deviation D6).
//
// Up to four points of one pair of bodies form a manifold and are evaluated side by side.
#pragma once

#include "sim/body/state.h"
#include "sim/math/lanes.h"
#include "sim/math/so3.h"
#include "sim/potential/barrier_traits.h"

namespace pabd {

// How far a turn δ = log(R R*ᵀ) rolls the surface, in units of the radius: δ itself up to 1 rad, then less
// and less, nothing more from 2 rad on. A body's inertia resists a turn in one step by sin ‖δ‖ at most;
// friction that went on with ‖δ‖ would drive a ball that is hit hard to ‖δ‖ = π, where it has no spin.
struct Roll {
  Vec3 turn = Vec3::Zero();  // rad
  double slope = 1;          // d‖turn‖/d‖δ‖
};
inline Roll roll_since_prediction(const Mat3& star, const Mat3& R) {
  const Vec3 turn = turn_between(star, R);
  const double angle2 = turn.squaredNorm();
  if (angle2 <= 1) return {turn, 1};
  const double angle = std::sqrt(angle2), past = angle < 2 ? angle - 1 : 1, past2 = past * past;
  const double rolled = 1 + past * (1 - past2 * (2.0 / 3 - past2 / 5));
  return {(rolled / angle) * turn, (1 - past2) * (1 - past2)};
}

inline constexpr double kLeastAlong = 0.02;  // see ease_slip

// What a separate manifold needs to know of its bodies beside their poses.
struct alignas(sizeof(Lanes)) Rolling {
  Lanes radius_b = lanes(0);
  Lanes arm_a = lanes(0), arm_b = lanes(0);
};

// The rolls of all bodies at an iterate, and the Rolling of all separate manifolds.
struct Rolls {
  const Roll* body = nullptr;
  const Rolling* separate = nullptr;
};

// Friction acts at the surface of the round one of two bodies, else of the movable one, else in the middle between the
// two: nothing depends on which of them is a. `gap` ≥ 0: between the surfaces where the step starts; m.
inline double gap_beside_b(double gap, bool movable_a, bool movable_b) {
  return movable_a ? (movable_b ? 0.5 * gap : gap) : 0;
}
struct FrictionArms {
  double a, b;
};
// `beside_b`: as above. A flat a turns as the point of a round b sees it.
inline FrictionArms friction_arms(double radius_a, double radius_b, double gap, double beside_b) {
  if (radius_a == 0) return {-radius_b, radius_b};
  if (radius_b == 0) return {radius_a, gap};
  return {radius_a + gap - beside_b, radius_b + beside_b};
}

// A friction force, or torque, of each lane, as iterations know it.
struct alignas(sizeof(Lanes)) FrictionBound {
  Lanes limit = lanes(0);        // its bound in this iteration
  Lanes last_change = lanes(0);  // that the law asked for
  Lanes relaxation =
      lanes(1);  // share of the next change: less where the bound swings, more where it does not
  // For `newton`, see ease_slip.
  Vec3x last_u = spread(Vec3::Zero());     // stretch of the last iterate
  Lanes along = lanes(1);                  // share of the weight α_t that acts along the slip
  Lanes least_along = lanes(kLeastAlong);  // see ease_slip
};

struct alignas(sizeof(Lanes)) ContactManifold : FrictionBound {
  Index a, b;
  int count;      // points in use, 1 … kLanes; the others are far away and feel nothing
  bool turns;     // a is flat: its plane turns with it. Else n, stretch and rolled are in the world frame
  bool separate;  // a or b is round: normal points and surface points differ
  Index rolling;  // number of its Rolling where it is separate
  std::uint32_t feature[kLanes];  // see ContactMemory
  Vec3x n, stretch;               // frame of a, or world
  Vec3x rolled;                   // part of the slip that the step starts with; separate manifolds
  Vec3x normal_a;                 // frame of a
  Vec3x normal_b;                 // frame of b
  Vec3x to_surface;               // frame of b: from the normal points of flat bodies to b's surface
  Lanes gap = lanes(1e30);        // d where the normal points coincide
  Lanes start_d = lanes(1e30);    // d where the step starts
  bool slides;                    // the pair of bodies has let go: dynamic friction
  double mu;                      // coefficient of this step
  Index turning = -1;             // number of its TurnFriction, if it has one (bond/turn_friction.h)
  // Of the barrier: q Ψ(g d + s)/g. While overlap recovers (solver/recovery.h) g is 1; g = 1 + τ/h damps (damp_contacts).
  Lanes shift = lanes(0), scale = lanes(1);
  double damped = 1;                        // g
  bool recovers = false;                    // solver/recovery.h
  bool recalled = false, restless = false;  // it has a past, and ContactMemory::restless
  bool known[kLanes] = {};                  // so has each point
  bool crowded = false;                     // of two bodies in crowds (collision/broad_phase.h)
  bool felt = false;                        // it pushed or held in some iterate of this step
  double share = 1;                         // of the law's stiffness, see cap_stiffness
};

inline double smallest_start_d(const ContactManifold& manifold) {
  double d = manifold.start_d[0];
  for (int k = 1; k < manifold.count; ++k) d = d < manifold.start_d[k] ? d : manifold.start_d[k];
  return d;
}

// What all contacts of a step share.
struct ContactLaw {
  Barrier barrier;
  double k_t;
};

// The law of a manifold that has `share` of the stiffness.
inline ContactLaw scaled(ContactLaw law, double share) {
  law.barrier.kappa *= share;
  law.k_t *= share;
  return law;
}

struct ContactState {
  Vec3x y;         // surface points of b; world, from c_a
  Vec3x normal_y;  // normal points of b; world, from c_a
  Vec3x n;         // normals; world
  Vec3x u;         // tangential stretch; world
  Lanes d;
  // How far along n the lever of friction on a ends above y, of a round a above its normal point; on b below its own.
  Lanes lever_a = lanes(0), lever_b = lanes(0);
};

// The contacts as quadratic models at the current poses. Zero for d ≥ d̂.
struct ContactForce {
  Lanes value;    // Ψ(d); J
  Lanes first;    // Ψ'(d) ≤ 0; N
  Lanes alpha_n;  // weight along the normal: tangent split, at least Ψ''; N/m
  Lanes second;   // Ψ''; N/m
};

// The planes of a and the normal points of b; world, from c_a.
struct ContactPlanes {
  Vec3x n, normal_y, offset;  // offset: from a's normal points to b's
  Lanes along;                // of it along n
};
[[gnu::always_inline]] inline ContactPlanes contact_planes(const ContactManifold& p, const Pose& a,
                                                           const Pose& b) {
  ContactPlanes at;
  at.n = p.turns ? rotate(a.R, p.n) : p.n;
  at.normal_y = spread(b.c - a.c) + rotate(b.R, p.normal_b);
  at.offset = at.normal_y - rotate(a.R, p.normal_a);
  at.along = dot(at.n, at.offset);
  return at;
}

// Always inlined: sixteen vector registers' worth of results would go through memory otherwise, and loads
// that follow such stores wait for them (measured: 40 % of a step).
[[gnu::always_inline]] inline ContactState contact_state(const ContactManifold& p, const Pose& a,
                                                         const Pose& b, const Rolls& rolls) {
  const ContactPlanes at = contact_planes(p, a, b);
  ContactState s;
  s.n = at.n;
  s.normal_y = at.normal_y;
  s.d = p.gap + at.along;
  const Vec3x before = p.separate ? p.stretch + p.rolled : p.stretch;
  s.u = at.offset - at.along * s.n + (p.turns ? rotate(a.R, before) : before);
  s.y = s.normal_y;
  if (p.separate) {
    const Rolling& r = rolls.separate[p.rolling];
    const Roll &roll_a = rolls.body[p.a], &roll_b = rolls.body[p.b];
    s.u = s.u + cross(s.n, r.arm_b * spread(roll_b.turn) + r.arm_a * spread(roll_a.turn));
    s.y = s.y - r.radius_b * s.n;
    s.lever_a = r.arm_a * roll_a.slope + (p.turns ? r.radius_b : lanes(0));
    s.lever_b = r.arm_b * roll_b.slope;
  }
  return s;
}

// Levers of the normal force and of friction from the centre of one end of the manifold; world.
struct ContactLevers {
  Vec3x normal, surface;
};

// Of body a. The plane of a flat owner is pushed where b's point is; a round one at its own normal point.
inline ContactLevers levers_on_a(const ContactManifold& p, const ContactState& s, const Pose& a) {
  const Vec3x normal = p.turns ? s.normal_y : rotate(a.R, p.normal_a);
  return {normal, (p.turns ? s.y : normal) + s.lever_a * s.n};
}
inline ContactLevers levers_on_b(const ContactState& s, const Pose& a, const Pose& b) {
  const Vec3x back = spread(a.c - b.c);
  return {s.normal_y + back, s.normal_y - s.lever_b * s.n + back};
}

// Ψ, Ψ' and the tangent split's weight for a manifold.
[[gnu::noinline]] inline ContactForce force_point_by_point(const Barrier& b, const Lanes& d) {
  ContactForce f;
  for (int k = 0; k < kLanes; ++k) {
    const BarrierValue psi = evaluate(b, d[k]);
    f.value[k] = psi.value;
    f.first[k] = psi.first;
    f.alpha_n[k] = tangent_split(b, d[k]).stiffness;
    f.second[k] = psi.second;
  }
  return f;
}
[[gnu::always_inline]] inline ContactForce normal_force(const Barrier& b, Lanes d) {
  if (is_feasible_only(b.kind)) return force_point_by_point(b, d);
  ContactForce f;
  const double inverse = 1 / b.d_hat;
  const Lanes zero = lanes(0);
  const LaneMask active = d < b.d_hat;
  const Lanes u = select(active, 1 - d * inverse, lanes(1));  // 1: any number that divides
  const PowerSum<Lanes> sum = power_sum(b, u);
  f.value = select(active, b.kappa * sum.value, zero);
  f.first = select(active, (-b.kappa * inverse) * sum.first, zero);
  f.alpha_n = select(active, (b.kappa * inverse * inverse) * larger(sum.second, sum.first / u), zero);
  f.second = select(active, (b.kappa * inverse * inverse) * sum.second, zero);
  return f;
}

// The d that the barrier of a manifold sees.
[[gnu::always_inline]] inline Lanes seen_distance(const ContactManifold& p, Lanes d) {
  return p.damped * d + p.shift;
}

// The same of a manifold, whose barrier may be another one.
[[gnu::always_inline]] inline ContactForce normal_force(const Barrier& b, const ContactManifold& p, Lanes d) {
  ContactForce f = normal_force(b, seen_distance(p, d));
  f.value *= p.scale / p.damped;
  f.first *= p.scale;
  f.alpha_n *= p.damped * p.scale;
  f.second *= p.damped * p.scale;
  return f;
}

// What the points of a manifold hold at d, and give back: without what damping takes. J.
inline Lanes stored_energy(const Barrier& b, const ContactManifold& p, const ContactForce& f, Lanes d) {
  return p.damped == 1 ? f.value : normal_force(b, d).value;
}

// Is every point too far to push, and is none held by friction? Then the manifold has no energy and no force.
[[gnu::always_inline]] inline bool feels_nothing(const Barrier& b, const ContactManifold& p, Lanes d) {
  const LaneMask far = (seen_distance(p, d) >= b.d_hat) & (p.limit <= 0);
  return (far[0] & far[1] & far[2] & far[3]) != 0;
}

// D(u) for a given bound: ½ k_t u² while it sticks, then linear.
inline Lanes friction_energy(const ContactLaw& law, Lanes limit, Lanes u) {
  return select(law.k_t * u <= limit, 0.5 * law.k_t * u * u, limit * (u - limit * (0.5 / law.k_t)));
}

// α_t = min(k_t, μ f_n/‖u‖), 0 without a bound.
inline Lanes friction_weight(const ContactLaw& law, Lanes limit, Lanes u) {
  const LaneMask sticks = law.k_t * u <= limit;
  const Lanes weight = select(sticks, lanes(law.k_t), limit / select(sticks, lanes(1), u));
  return select(limit > 0, weight, lanes(0));
}

inline Lanes length(const Vec3x& v) { return sqrt(dot(v, v)); }

// E of the manifold, every point by itself.
inline Lanes contact_energy(const ContactLaw& law, const ContactManifold& p, const ContactState& s) {
  if (feels_nothing(law.barrier, p, s.d)) return lanes(0);
  return normal_force(law.barrier, p, s.d).value + friction_energy(law, p.limit, length(s.u));
}

// Moves the bounds towards `most`, μ f_n of the current iterate. Each goes its own share of the way: half of the last
// share where it swings back, half as much again where it goes on. (Forces answer to bounds; a whole way each
// time may swing for ever.)
inline void move_limit(FrictionBound& p, const Lanes& most) {
  const Lanes change = most - p.limit;
  p.relaxation =
      select(change * p.last_change < 0, 0.5 * p.relaxation, smaller(lanes(1), 1.5 * p.relaxation));
  p.limit += p.relaxation * change;
  p.last_change = change;
}

// D'' of a contact that slides is 0 along u, α_t across it; α_t all round is a majoriser of D. Newton's step
// with the majoriser converges slowly where the slip is short, without it the slip turns back and forth at
// the threshold of sticking. So the share of α_t along u falls while the slip keeps its direction, by an eighth down to
// a least share (first kLeastAlong), from there on by half. The least share is four times as large each time that the slip has turned back.
inline void ease_slip(const ContactLaw& law, FrictionBound& p, const Vec3x& u) {
  const Lanes along = dot(u, p.last_u), straight = 0.9 * length(u) * length(p.last_u);
  const LaneMask steady = (along > straight) & (law.k_t * length(u) > p.limit);
  const LaneMask there = steady & (p.along <= p.least_along);
  p.least_along = select(along < 0, smaller(lanes(1), 4 * p.least_along), p.least_along);
  p.least_along = select(there, 0.5 * p.least_along, p.least_along);
  p.along = select(steady, larger(p.least_along, 0.125 * p.along), lanes(1));
  p.last_u = u;
}

// Is a slip still held back by the majoriser, so that small moves do not mean the end?
inline bool is_held_back(const ContactLaw& law, const FrictionBound& p, const Vec3x& u) {
  constexpr double kRounding = 1e-9;  // of its stretch: a slip that short has no direction
  const LaneMask slides = (law.k_t * length(u) > (1 + kRounding) * p.limit) & (p.limit > 0);
  return sum(select(slides & (p.along > larger(p.least_along, lanes(kLeastAlong))), lanes(1), lanes(0))) > 0;
}

// Coulomb's law: how far the friction force min(k_t ‖u‖, limit) is from min(k_t ‖u‖, most), `most` being μ f_n; N.
inline Lanes friction_error(const ContactLaw& law, const FrictionBound& p, const Lanes& most,
                            const Lanes& u) {
  const Lanes pull = law.k_t * u;
  const Lanes error = smaller(pull, p.limit) - smaller(pull, most);
  return larger(error, -error);
}

}  // namespace pabd
