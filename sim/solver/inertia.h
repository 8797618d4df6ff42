// SPDX-License-Identifier: MIT
// The inertia part of the incremental potential E for one body, and its derivatives on SE(3).
//
//   E_in = 1/(2h²) tr[(Q − Q*) M (Q − Q*)ᵀ],  M = diag(m, J)
//        = m ‖c − c*‖²/(2h²) + tr[(R − R*) J (R − R*)ᵀ]/(2h²)
//
// For R ← exp([δω]) R and X = R* J Rᵀ:  ∂E/∂ω = −axial(X)/h²,  ∂²E/∂ω² = (tr(X) 1 − X_s)/h², X_s its
// symmetric part.
#pragma once

#include "sim/body/state.h"
#include "sim/math/so3.h"

namespace pabd {

struct Inertia {
  double m;       // kg
  Mat3 J;         // kg m², body frame
  Pose star;      // predicted pose Q*
  double inv_h2;  // 1/h²; s⁻²
};

inline double inertia_energy(const Inertia& in, const Pose& pose) {
  const Mat3 D = pose.R - in.star.R;
  return 0.5 * in.inv_h2 * (in.m * (pose.c - in.star.c).squaredNorm() + (D * in.J).cwiseProduct(D).sum());
}

// Its derivatives there: the Hessian is m/h² 1 for moves and `turn` for turns.
struct InertiaModel {
  double mass;  // m/h²; N/m
  Mat3 turn;    // N m
  Vec6 g;
};
inline InertiaModel inertia_model(const Inertia& in, const Pose& pose) {
  InertiaModel out;
  const Mat3 X = in.star.R * in.J * pose.R.transpose();
  out.mass = in.m * in.inv_h2;
  out.turn = in.inv_h2 * (X.trace() * Mat3::Identity() - 0.5 * (X + X.transpose()));
  out.g << out.mass * (pose.c - in.star.c), -in.inv_h2 * axial(X);
  return out;
}

}  // namespace pabd
