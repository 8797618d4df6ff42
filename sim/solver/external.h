// SPDX-License-Identifier: MIT
// Forces and torques on bodies from outside: constant in E, so that they only move its predicted poses,
//
//   c* += h′² F/m,  v += h′ F/m,  R* = exp(h′² I⁻¹ τ) R*,  L += h′ τ      F, τ: at the end of the step
//
// with h′ = h by Euler and 2h/3 in a step of second order (second_order.h).
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

inline bool has_external(const Model& model, Index i) {
  return !model.external.empty() && model.external[static_cast<std::size_t>(i)].has_value();
}

// On body i, whose flight has none of it yet; `time`: where the step ends.
void add_external(const Model& model, Index i, double time, double h, Flight& flight);

// Their work on body i on its way from the start of the step to `end`; J.
double external_work(const Problem& p, Index i, const Pose& end);

}  // namespace pabd
