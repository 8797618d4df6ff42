// SPDX-License-Identifier: MIT
// Contact potentials Ψ(d) = κ B(d): the IPC log barrier S(4), the polynomial barrier S(5), and its even part.
//
//   d        signed distance                                   m
//   d̂        thickness: Ψ = 0 for d ≥ d̂                        m
//   κ        stiffness                                         J; J/m² for log (S(4) has the factor (d − d̂)²,
//                                                              so B is in m² there)
//   N        highest order of the sum, 1 … kMaxOrder
//   ε        onset width: the force is ramped up over d̂(1−ε) < d < d̂ (Deviation D2)
//
// Source: supplement S(3)–S(6); method notes §2.
#pragma once

#include <array>
#include <cstdint>

namespace pabd {

inline constexpr int kMaxOrder = 32;

// Every barrier, one a line. A new one is a line at the end, and a file that describes barriers::NAME, named in
// barrier_traits.h.
#define PABD_BARRIERS(X) \
  X(log)                 \
  X(polynomial)          \
  X(even)                \
  X(quadratic)

enum class BarrierKind : std::uint8_t {
#define PABD_KIND(name) name,
  PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
};

inline constexpr std::array kBarrierKinds{
#define PABD_KIND(name) BarrierKind::name,
    PABD_BARRIERS(PABD_KIND)
#undef PABD_KIND
};

const char* to_string(BarrierKind kind);

struct Barrier {
  BarrierKind kind = BarrierKind::polynomial;
  int N = 3;
  double d_hat = 0.01;
  double kappa = 1;
  double onset = 0.2;
};

// Ψ, Ψ' and Ψ'' at one distance. For the log barrier at d ≤ 0: Ψ = +∞, Ψ' = −∞, Ψ'' = +∞.
struct BarrierValue {
  double value;   // J
  double first;   // J/m = N; never positive
  double second;  // J/m²
};

// φ⁺/d and φ⁻ with Ψ'(d) = (φ⁺/d)·d + φ⁻.
struct Split {
  double stiffness;  // φ⁺/d, N/m
  double force;      // φ⁻, N
};

// What a kind of barrier is, beside its numbers.
struct BarrierTraits {
  const char* help;            // a noun
  bool feasible_only = false;  // infinite for d ≤ 0: no overlap may start or arise
  bool per_area = false;       // κ in J/m² instead of J
  int least_N = 0;             // 0: it has no orders
  bool has_onset = false;
  bool has_split = false;  // that of S(6); else the tangent split takes its place
};
const BarrierTraits& traits_of(BarrierKind kind);

inline const char* kappa_unit(BarrierKind kind) { return traits_of(kind).per_area ? "J/m²" : "J"; }
// What κ is divided by to be a stiffness in N/m: d̂², or 1 where it is one already.
inline double area_of_kappa(BarrierKind kind, double d_hat) {
  return traits_of(kind).per_area ? 1.0 : d_hat * d_hat;
}
// κ that is 1 J.
inline double one_joule(BarrierKind kind, double d_hat) {
  return traits_of(kind).per_area ? 1 / (d_hat * d_hat) : 1;
}

BarrierValue evaluate(const Barrier& barrier, double d);

// The split of the supplement, S(6), exact for the printed sum (errata E1, E2); of kinds that have one.
Split binomial_split(const Barrier& barrier, double d);

// max(Ψ'', Ψ'/(d − d̂)) as stiffness: Newton's, raised where its step would pass d̂ (method notes §2).
Split tangent_split(const Barrier& barrier, double d);

}  // namespace pabd
