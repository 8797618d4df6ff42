// The contact bond S(17) with friction S§3: energy, force and stiffness of one contact point.
//
// A contact joins a point of body b to a plane that is fixed in body a. Everything it feels depends on one
// vector, the displacement of b's point as seen from a since the start of the step:
//
//   q   = R_aᵀ (y_b − c_a) − r_a         y_b = c_b + R_b r_b           m, frame of a
//   d   = gap + n·q                      signed distance S(17)         m
//   u   = q − n (n·q) + stretch          tangential stretch            m, frame of a
//   E   = Ψ(d) + D(‖u‖)                                                J
//   D'  = min(k_t ‖u‖, limit)            stick, then slide             N
//
//   symbol    variable   meaning                                                 unit
//   n         n          contact normal, fixed in a, from a to b                 –
//   r_a, r_b  r_a, r_b   the point of b, and where it was seen from a at the     m
//                        start of the step: the same two material points
//   d̂, κ, N, ε  barrier  see potential/barrier.h
//   k_t       k_t        tangential stiffness, Ψ'' at the onset                 N/m
//   μ f_n     limit      largest friction force, from the last iterate           N
//
// Because E depends on q alone, the forces on a and b are opposite and act at the same point y_b: linear and
// angular momentum are kept exactly. (The supplement's point y_i is the foot of y_b on the plane; a normal
// force has the same torque there.) Deviation D4: Coulomb sliding as well as sticking. Deviation D6:
// `stretch` is carried from step to step, so that a body at rest on a slope does not creep.
//
// Up to four points of one pair of bodies form a patch and are evaluated side by side.
#pragma once

#include "sim/body/state.h"
#include "sim/math/lanes.h"
#include "sim/potential/power_sum.h"

namespace pabd {

struct ContactPatch {
  Index a, b;
  int count;                      // points in use, 1 … kLanes; the others are far away and feel nothing
  std::uint32_t feature[kLanes];  // see FrictionAnchor
  Vec3x n, r_a, stretch;          // frame of a
  Vec3x r_b;                      // frame of b
  Lanes gap;                      // d at the start of the step
  Lanes mu;           // coefficient of this step: dynamic if the contact slid at the end of the last one
  Lanes limit;        // friction bound μ f_n of this iteration
  Lanes last_change;  // of `limit`: a change of sign damps the next one
};

// What all contacts of a step share.
struct ContactLaw {
  Barrier barrier;
  double k_t;
  double mu_static, mu_dynamic;
};

struct ContactState {
  Vec3x y;  // the points of b; world, from c_a
  Vec3x n;  // normals; world
  Vec3x u;  // tangential stretch; world
  Lanes d;
};

// The contacts as quadratic models at the current poses. Zero for d ≥ d̂.
struct ContactForce {
  Lanes value;    // Ψ(d); J
  Lanes first;    // Ψ'(d) ≤ 0; N
  Lanes alpha_n;  // weight along the normal: tangent split; N/m
};

inline ContactState contact_state(const ContactPatch& p, const Pose& a, const Pose& b) {
  ContactState s;
  s.y = spread(b.c - a.c) + rotate(b.R, p.r_b);
  s.n = rotate(a.R, p.n);
  const Vec3x q = s.y - rotate(a.R, p.r_a);  // world frame
  const Lanes normal = dot(s.n, q);
  s.d = p.gap + normal;
  s.u = q - normal * s.n + rotate(a.R, p.stretch);
  return s;
}

// Ψ, Ψ' and the tangent split's weight for a patch.
inline ContactForce normal_force(const Barrier& b, Lanes d) {
  ContactForce f;
  if (b.kind == BarrierKind::log) {
    for (int k = 0; k < kLanes; ++k) {
      const BarrierValue psi = evaluate(b, d[k]);
      f.value[k] = psi.value;
      f.first[k] = psi.first;
      f.alpha_n[k] = tangent_split(b, d[k]).stiffness;
    }
    return f;
  }
  const double inverse = 1 / b.d_hat;
  const Lanes zero = lanes(0);
  const LaneMask active = d < b.d_hat;
  const Lanes u = select(active, 1 - d * inverse, lanes(1));  // 1: any number that divides
  const PowerSum<Lanes> sum = power_sum(b, u);
  f.value = select(active, b.kappa * sum.value, zero);
  f.first = select(active, (-b.kappa * inverse) * sum.first, zero);
  f.alpha_n = select(active, (b.kappa * inverse * inverse) * larger(sum.second, sum.first / u), zero);
  return f;
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

// E of the patch, every point by itself.
inline Lanes contact_energy(const ContactLaw& law, const ContactPatch& p, const ContactState& s) {
  return normal_force(law.barrier, s.d).value + friction_energy(law, p.limit, length(s.u));
}

// Moves the bounds to μ f_n of the current iterate; half way where one swings to and fro between iterates.
inline void update_limit(const ContactLaw& law, ContactPatch& p, const ContactState& s) {
  Lanes change = -p.mu * normal_force(law.barrier, s.d).first - p.limit;
  change = select(change * p.last_change < 0, 0.5 * change, change);
  p.limit += change;
  p.last_change = change;
}

}  // namespace pabd
