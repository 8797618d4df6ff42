// SPDX-License-Identifier: MIT
// Barriers and friction at a contact point: sim/potential, sim/bond/contact_bond.h.

struct BarrierSum {
  real value, first, second;  // of B(u), u = 1 − d/d̂
};
BarrierSum onset_term(real u, real onset) {
  if (onset == 0) return BarrierSum(u, 1, 0);
  return u < onset ? BarrierSum(u * u * (real(0.5lf) / onset), u / onset, 1 / onset) : BarrierSum(u - onset / 2, 1, 0);
}
// Those of kDeviceBarriers: the polynomial S(5), its even part, the C² penalty.
BarrierSum barrier_sum(real u) {
  const real onset = real(params.onset);
  const int N = params.N;
  real value = 0, first = 0, second = 0;
  if (params.barrier == BARRIER_polynomial) {
    for (int n = N; n >= 2; --n) {
      value = value * u + real(1.0lf) / n;
      first = first * u + 1;
      second = second * u + (n - 1);
    }
    const BarrierSum ramp = onset_term(u, onset);
    return BarrierSum(ramp.value + value * u * u, ramp.first + first * u, ramp.second + second);
  }
  if (params.barrier == BARRIER_even) {
    const real u2 = u * u;
    for (int m = N / 2; m >= 1; --m) {
      value = value * u2 + real(1.0lf) / (2 * m);
      first = first * u2 + 1;
      second = second * u2 + (2 * m - 1);
    }
    return BarrierSum(value * u2, first * u, second);
  }
  const BarrierSum slope = onset_term(u, onset);
  const real past = u * u / 2 - onset * u / 2 + onset * onset / 6;
  return BarrierSum(onset > 0 && u < onset ? u * u * u / (6 * onset) : past, slope.value, slope.first);
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
