// SPDX-License-Identifier: MIT
// The predicted pose Q* = [c*, R*] of a body: what a body does when nothing touches it.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/workers.h"

namespace pabd {

// v ← v + h a_ext and c* = c + h v for one body; ω and R* by an implicit midpoint rule on SO(3) that keeps
// the angular momentum L = R I Rᵀ ω and the energy to rounding; in closed form for a symmetric top.
//   J        second moment, body frame; kg m²
//   pose     in: start of the step, out: Q*
//   v, omega in: start of the step, out: end of free flight
// Returns the mean angular velocity times h, which may be several turns: R* = exp(it) R.
Vec3 free_flight(const Mat3& J, const Vec3& gravity, double h, Pose& pose, Vec3& v, Vec3& omega);

// Free flight of all bodies, one entry each, with the forces from outside; fixed ones stay.
struct Flight {
  std::vector<Pose> star;      // Q*
  std::vector<Vec3> v, omega;  // at its end; m/s, rad/s
  std::vector<Vec3> turn;      // rotation vectors, of any length; rad
  std::vector<double> radius;  // bounding radii; m
  std::vector<double> h;       // of E and of the velocities that follow from it (second_order.h); s
};
void fly(const Model& model, const Params& params, const State& state, const Workers& workers, Flight& out);

// Forces and torques from outside are constant in E, so that they only move its predicted poses:
//
//   c* += h′² F/m,  v += h′ F/m,  R* = exp(h′² I⁻¹ τ) R*,  L += h′ τ      F, τ: at the end of the step
//
// with h′ = h by Euler and 2h/3 in a step of second order (second_order.h).
inline bool has_external(const Model& model, Index i) {
  return !model.external.empty() && model.external[i].has_value();
}
// On body i, whose flight has none of it yet; `time`: where the step ends.
void add_external(const Model& model, Index i, double time, double h, Flight& flight);

}  // namespace pabd
