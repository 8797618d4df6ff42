// SPDX-License-Identifier: MIT
// What a pair remembers, and how deep overlap comes apart: sim/solver/recovery.cpp.
const uint SLIDES = 1u, RECOVERS = 2u;

// How far a contact opens in a step.
real way(real d) {
  const real h = real(params.h), slow = real(params.d_hat) * h;
  return min(real(params.recovery_speed) * h, slow + max(real(0), -d));
}
