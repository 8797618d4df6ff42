// SPDX-License-Identifier: MIT
// Barriers and friction at a contact point: sim/potential/barrier_sums.inl, sim/bond/contact_bond.h.

// Those of kDeviceBarriers.
BarrierSum barrier_sum(real u) {
  const real onset = real(params.onset);
  if (params.barrier == BARRIER_polynomial) return polynomial_sum(u, params.N, onset);
  if (params.barrier == BARRIER_even) return even_sum(u, params.N);
  return quadratic_sum(u, onset);
}

struct Push {
  real value, first, stiffness;  // Ψ, Ψ' ≤ 0, weight of the tangent split
};
Push normal_push(real d) {
  const real d_hat = real(params.d_hat), kappa = real(params.kappa);
  if (!(d < d_hat)) return Push(0, 0, 0);
  const real u = 1 - d / d_hat;
  const BarrierSum B = barrier_sum(u);
  return Push(kappa * B.value, -kappa / d_hat * B.first, kappa / (d_hat * d_hat) * max(B.second, B.first / u));
}
// Of a contact whose barrier may be another one while overlap recovers.
Push normal_push(Contact c, real d) {
  Push out_ = normal_push(d + c.r_b.w);
  return Push(out_.value * c.apart.w, out_.first * c.apart.w, out_.stiffness * c.apart.w);
}
real friction_energy(real limit, real u) {
  const real k_t = real(params.k_t);
  return k_t * u <= limit ? k_t * u * u / 2 : limit * (u - limit / (2 * k_t));
}
// α_t = min(k_t, μ f_n/‖u‖), 0 without a bound.
real friction_weight(real limit, real u) {
  const real k_t = real(params.k_t);
  if (!(limit > 0)) return 0;
  return k_t * u <= limit ? k_t : limit / u;
}
