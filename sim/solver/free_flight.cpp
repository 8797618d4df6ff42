// SPDX-License-Identifier: MIT
#include "sim/solver/free_flight.h"

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"

namespace pabd {
namespace {

bool is_isotropic(const Mat3& J) { return J == Mat3(J(0, 0) * Mat3::Identity()); }

// The axis of the body frame about which J is the same all round, −1 if there is none.
int axis_of_symmetry(const Mat3& J) {
  const double same = 1e-12 * J.trace();
  if (std::abs(J(0, 1)) + std::abs(J(0, 2)) + std::abs(J(1, 2)) > same) return -1;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (std::abs(J(i, i) - J(j, j)) <= same) return k;
  }
  return -1;
}

// The symmetric top in closed form: it turns about L at ‖L‖/I_t while it turns about its own axis at
// (1 − I_a/I_t) of its spin s there; I_a, I_t moments along and across the axis.
Vec3 top_flight(const Vec3& moments, int axis, double h, Mat3& R, Vec3& omega) {
  const double I_a = moments[axis], I_t = moments[(axis + 1) % 3];
  const double s = omega.dot(R.col(axis)), own = s * (1 - I_a / I_t);
  const Vec3 about_L = omega - own * R.col(axis);  // L/I_t
  const Vec3 half_way = exp_so3(0.5 * h * about_L) * R.col(axis);
  R = reorthonormalized(exp_so3(h * about_L) * R * exp_so3(h * own * Vec3::Unit(axis)));
  omega = about_L + own * R.col(axis);
  return h * (about_L + own * half_way);
}

// The rotation vector of R*, which is exp(t) R, that is nearest to `about`: t may be several turns.
Vec3 turn_near(const Vec3& about, const Mat3& R, const Mat3& star) {
  const Vec3 t = turn_between(R, star);
  const double angle = t.norm();
  if (!(angle > 0)) return about;
  const Vec3 n = t / angle;
  return t + 2 * kPi * std::round((about.dot(n) - angle) / (2 * kPi)) * n;
}

// ω_m = E A Eᵀ (E + Eᵀ)/2 L, E = exp(h ω_m / 2): I⁻¹ of the mean of the momenta that the body sees at both ends:
// L is kept, and with it the energy, L̄·(I⁻¹(L₁ − L₀)) = 0. A contraction while h ω, times how slim the body is, is below 1. False: it is none.
bool find_midpoint(const Mat3& A, const Vec3& L, double h, Vec3& midpoint) {
  for (int i = 0; i < 16; ++i) {
    const Vec3 half = 0.5 * h * midpoint;
    Vec3 next;
    if (half.squaredNorm() < 1) {
      const ShortTurn E(half);
      const Vec3 back = E.back(L);
      next = E.turn(A * (0.5 * (L + E.back(back))));
    } else {
      const Mat3 E = exp_so3(half);
      const Vec3 back = E.transpose() * L;
      next = E * (A * (0.5 * (L + E.transpose() * back)));
    }
    const double change2 = (next - midpoint).squaredNorm(), size2 = next.squaredNorm();
    midpoint = next;
    if (change2 < 1e-28 * size2) return true;
  }
  return false;
}

// Turns of a body that is no top, in halves where the midpoint is not found; at most 2^halvings of them.
Vec3 turn_freely(const Mat3& inverse, const Vec3& L, double h, int halvings, Mat3& R, Vec3& omega) {
  const Mat3 A = R * inverse * R.transpose();
  Vec3 midpoint = omega;
  if (find_midpoint(A, L, h, midpoint) || halvings == 0) {
    R = reorthonormalized(exp_so3(h * midpoint) * R);
    omega = R * (inverse * (R.transpose() * L));
    return h * midpoint;
  }
  const Mat3 start = R;
  const Vec3 first = turn_freely(inverse, L, 0.5 * h, halvings - 1, R, omega);
  const Vec3 second = turn_freely(inverse, L, 0.5 * h, halvings - 1, R, omega);
  return turn_near(first + second, start, R);
}

}  // namespace

Vec3 free_flight(const Mat3& J, const Vec3& gravity, double h, Pose& pose, Vec3& v, Vec3& omega) {
  v += h * gravity;
  pose.c += h * v;
  Mat3& R = pose.R;
  if (omega.isZero(0)) return Vec3::Zero();
  if (is_isotropic(J)) {  // ω is constant
    R = reorthonormalized(exp_so3(h * omega) * R);
    return h * omega;
  }
  const Mat3 I = inertia_tensor(J);
  const int axis = axis_of_symmetry(J);
  if (axis >= 0) return top_flight(I.diagonal(), axis, h, R, omega);
  const Vec3 L = R * (I * (R.transpose() * omega));
  constexpr int kHalvings = 10;
  return turn_freely(symmetric_inverse(I), L, h, kHalvings, R, omega);
}

void add_external(const Model& model, Index i, double time, double h, Flight& flight) {
  const ExternalForce& external = *model.external[i];
  const Vec3 dv = h / model.mass[i] * external.force_at(time), dL = h * external.torque_at(time);
  Pose& star = flight.star[i];
  star.c += h * dv;
  flight.v[i] += dv;
  if (dL.isZero(0)) return;
  const Mat3 I = inertia_tensor(model.J[i]), inverse = symmetric_inverse(I);
  const Vec3 L = turned(star.R, I) * flight.omega[i] + dL, turn = h * (turned(star.R, inverse) * dL);
  star.R = reorthonormalized(exp_so3(turn) * star.R);
  flight.turn[i] += turn;
  flight.omega[i] = turned(star.R, inverse) * L;
}

void fly(const Model& model, const Params& params, const State& state, const Workers& workers, Flight& out) {
  out.star.resize(state.c.size());
  out.radius.resize(state.c.size());
  out.turn.assign(state.c.size(), Vec3::Zero());
  out.h.assign(state.c.size(), params.h);
  out.v = state.v;
  out.omega = state.omega;
  workers.for_each(model.shape.size(), [&](std::size_t i) {
    out.star[i] = {state.c[i], state.R[i]};
    out.radius[i] = bounding_radius(model.shape[i]);
    if (model.fixed[i]) return;
    out.turn[i] = free_flight(model.J[i], params.gravity, params.h, out.star[i], out.v[i], out.omega[i]);
    if (has_external(model, static_cast<Index>(i)))
      add_external(model, static_cast<Index>(i), state.time + params.h, params.h, out);
  });
}

}  // namespace pabd
