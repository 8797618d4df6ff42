// Contact potentials Ψ(d) = κ B(d): the IPC log barrier S(4), the polynomial barrier S(5), and its even part.
//
//   d        signed distance                                   m
//   d̂        thickness: Ψ = 0 for d ≥ d̂                        m
//   κ        stiffness                                         J for polynomial and even; J/m² for log (S(4)
//   has
//                                                              the factor (d − d̂)², so B is in m² there)
//   N        highest order of the sum, 1 … kMaxOrder
//   ε        onset width: slope of the n = 1 term is ramped up over d̂(1−ε) < d < d̂ (Deviation D2)
//
// Source: supplement S(3)–S(6); method notes §2.
#pragma once

#include <cstdint>

namespace pabd {

inline constexpr int kMaxOrder = 32;

enum class BarrierKind : std::uint8_t { log, polynomial, even };
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

BarrierValue evaluate(const Barrier& barrier, double d);

// The split of the supplement, S(6), exact for the printed sum (errata E1, E2). polynomial and even only.
Split binomial_split(const Barrier& barrier, double d);

// max(Ψ'', Ψ'/(d − d̂)) as stiffness: Newton's, raised where its step would pass d̂ (method notes §2).
Split tangent_split(const Barrier& barrier, double d);

}  // namespace pabd
