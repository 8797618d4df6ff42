// SPDX-License-Identifier: MIT
// The quadratic model of one body as an affine body, and its minimisers: the global step of the supplement
// and the weighted projection (Deviation D1). Positions are relative to the body's current c, so that nothing
// is lost far from the origin.
//
//   H = M/h² + Σ α s sᵀ = [h_c h_Aᵀ; h_A H_A]       4×4, s = [1; r]
//   b = [b_c, b_A] = Q* M/h² + Σ (α t + f) sᵀ       3×4
//
//   affine:    [δc A] = b H⁻¹
//   weighted:  R = polar(b_A − b_c h_Aᵀ/h_c),  δc = (b_c − R h_A)/h_c     exact minimiser over SE(3)
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

struct AffineModel {
  double h_c;
  Vec3 h_A;
  Mat3 H_A;
  Vec3 b_c;
  Mat3 b_A;
};

enum class WeightKind {
  binomial,    // φ⁺/d of S(6), as printed
  tangent,     // max(Newton, secant to d̂)
  majorising,  // the larger of the two: below d = 0 the binomial weight is less than Ψ'' and overshoots
};

// `coupled`: factor on the weight of bonds whose other end moves as well.
AffineModel affine_model(const Problem& p, const Iterate& it, Index i, const Inertia& in, WeightKind weights,
                         double coupled = 1);

// R near `guess`.
Mat3 weighted_rotation(const AffineModel& model, const Mat3& guess);
inline Vec3 weighted_translation(const AffineModel& model, const Mat3& R) {
  return (model.b_c - R * model.h_A) / model.h_c;
}

}  // namespace pabd
