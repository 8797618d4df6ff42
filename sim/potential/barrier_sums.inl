// SPDX-License-Identifier: MIT
// B as a function of u = 1 − d/d̂ ≥ 0, with two derivatives with respect to u; the files of the barriers say which is
// which. The CPU and the GPU both compile this text (sim/collision/pair_text.h says how).
//
//   lane   a number, or on the CPU four of them, those of a manifold
struct BarrierSum {
  lane value, first, second;
};

// Huber form of u: u²/(2ε) for u < ε, u − ε/2 above.
[[gnu::always_inline]] static inline BarrierSum onset_term(lane u, wide onset) {
  lane zero = u - u, one = zero + 1;
  BarrierSum sum = {u, one, zero};
  if (onset == 0) return sum;
  sum.value = u < onset ? u * u * (0.5 / onset) : u - 0.5 * onset;
  sum.first = u < onset ? u * (1 / onset) : one;
  sum.second = u < onset ? one * (1 / onset) : zero;
  return sum;
}

// Σ_{n=1}^N uⁿ/n, the n = 1 term with its onset ramp. Horner in u, no division by d.
[[gnu::always_inline]] static inline BarrierSum polynomial_sum(lane u, int N, wide onset) {
  lane value = u - u, first = value, second = value;
  for (int n = N; n >= 2; --n) {
    value = value * u + 1.0 / n;
    first = first * u + 1;
    second = second * u + (n - 1);
  }
  BarrierSum sum = onset_term(u, onset);
  sum.value = sum.value + value * u * u;
  sum.first = sum.first + first * u;
  sum.second = sum.second + second;
  return sum;
}

// Σ_{m=1}^{⌊N/2⌋} u²ᵐ/(2m).
[[gnu::always_inline]] static inline BarrierSum even_sum(lane u, int N) {
  lane value = u - u, first = value, second = value, u2 = u * u;
  for (int m = N / 2; m >= 1; --m) {
    value = value * u2 + 1.0 / (2 * m);
    first = first * u2 + 1;
    second = second * u2 + (2 * m - 1);
  }
  BarrierSum sum = {value * u2, first * u, second};
  return sum;
}

// B″ is u/ε for u < ε, 1 above.
[[gnu::always_inline]] static inline BarrierSum quadratic_sum(lane u, wide onset) {
  BarrierSum slope = onset_term(u, onset);  // B′ is the Huber form of u
  lane past = 0.5 * u * u - (0.5 * onset) * u + onset * onset / 6;
  BarrierSum sum = {past, slope.value, slope.first};
  if (onset == 0) return sum;
  sum.value = u < onset ? u * u * u * (1 / (6 * onset)) : past;
  return sum;
}
