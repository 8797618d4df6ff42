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
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/math/types.h"
#include "sim/potential/barrier.h"

namespace pabd {

struct ContactBond {
  Index a, b;
  Vec3 n, r_a, stretch;   // frame of a
  Vec3 r_b;               // frame of b
  double gap;             // d at the start of the step
  double mu;              // coefficient of this step: dynamic if the contact slid at the end of the last one
  double limit;           // friction bound μ f_n of this iteration
  double last_change;     // of `limit`: a change of sign damps the next one
  std::uint32_t feature;  // see collision/detect.h
};

// What all contacts of a step share.
struct ContactLaw {
  Barrier barrier;
  double k_t;
  double mu_static, mu_dynamic;
};

struct ContactState {
  Vec3 y;  // the point of b; world
  Vec3 n;  // normal; world
  Vec3 u;  // tangential stretch; world
  double d;
};

// One contact as a quadratic model at the current poses.
struct ContactForce {
  double energy;
  double first;    // Ψ'(d) ≤ 0; N
  double alpha_n;  // weight along the normal; N/m
  double alpha_t;  // weight across it; N/m
};

inline ContactState contact_state(const ContactBond& bond, const Vec3& c_a, const Mat3& R_a, const Vec3& c_b,
                                  const Mat3& R_b) {
  ContactState s;
  s.y = c_b + R_b * bond.r_b;
  s.n = R_a * bond.n;
  const Vec3 q = (s.y - c_a) - R_a * bond.r_a;  // world frame
  const double normal = s.n.dot(q);
  s.d = bond.gap + normal;
  s.u = q - normal * s.n + R_a * bond.stretch;
  return s;
}

// D(u) for a given bound: ½ k_t u² while it sticks, then linear.
inline double friction_energy(double k_t, double limit, double u) {
  return k_t * u <= limit ? 0.5 * k_t * u * u : limit * (u - 0.5 * limit / k_t);
}

inline double contact_energy(const ContactLaw& law, const ContactBond& bond, const ContactState& s) {
  return evaluate(law.barrier, s.d).value +
         (bond.limit > 0 ? friction_energy(law.k_t, bond.limit, s.u.norm()) : 0.0);
}

// α_t = min(k_t, μ f_n/‖u‖)
inline double friction_weight(const ContactLaw& law, double limit, double u) {
  return law.k_t * u <= limit ? law.k_t : limit / u;
}

inline ContactForce contact_force(const ContactLaw& law, const ContactBond& bond, const ContactState& s) {
  const BarrierValue psi = evaluate(law.barrier, s.d);
  ContactForce f{psi.value, psi.first, 0, 0};
  if (s.d < law.barrier.d_hat)
    f.alpha_n = std::max(psi.second, psi.first / (s.d - law.barrier.d_hat));  // tangent split
  if (bond.limit > 0) {
    const double u = s.u.norm();
    f.energy += friction_energy(law.k_t, bond.limit, u);
    f.alpha_t = friction_weight(law, bond.limit, u);
  }
  return f;
}

// Moves the bound to μ f_n of the current iterate; half way when it swings to and fro between iterates.
inline void update_limit(const ContactLaw& law, ContactBond& bond, const ContactState& s) {
  double change = -bond.mu * evaluate(law.barrier, s.d).first - bond.limit;
  if (change * bond.last_change < 0) change *= 0.5;
  bond.limit += change;
  bond.last_change = change;
}

}  // namespace pabd
