// SPDX-License-Identifier: MIT
// The bond between two points: soft S(1, 2), or hard and bilateral (the even part of S(5) without its bound
// at d̂).
//
//   e       y_b − y_a, without its part along `free_axis` if there is one           m
//   s       ‖e‖ − l                                                                 m
//   soft    Ψ = ½ κ s²                                     κ in N/m
//   hard    Ψ = κ Σ_{m=1}^{⌊N/2⌋} (1/2m)(s/d̂)²ᵐ            κ in J
//
//   ∂Ψ/∂y_b = Ψ'(s) e/‖e‖,   weights: α_n = Ψ'' along e, α_t = max(0, Ψ'/‖e‖) across it;
//                            for l = 0 both are Ψ''
#pragma once

#include "sim/body/joint.h"

namespace pabd {

struct PointBondForce {
  double energy;   // J
  Vec3 gradient;   // of the energy with respect to y_b; N
  Mat3 weight;     // K; over all bonds of a joint together positive semidefinite; N/m
  double largest;  // eigenvalue of K, at least 0; N/m
  double stretch;  // |s|; m
};

// Two points that a joint wants `length` apart, where they are now; world frame.
struct PointBond {
  Vec3 y_a, y_b;
  double length = 0;
  bool slides = false;      // along free_axis
  Vec3 free_axis{0, 0, 0};  // unit
  double scale = 1;         // part of the law's κ
  // Of a bond that follows no law of the distance: what it does (joint/action.h). Lives as long as the bond.
  const PointBondForce* given = nullptr;
};

PointBondForce evaluate(const BondLaw& law, const PointBond& bond);

// Ψ' and Ψ'' of s.
struct BondSlope {
  double value, first, second;
};
BondSlope evaluate(const BondLaw& law, double s);

}  // namespace pabd
