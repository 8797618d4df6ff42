// SPDX-License-Identifier: MIT
// The quadratic model of one body in the tangent space of SE(3), all others frozen (Deviation D5): unknowns
// (δc, δω) with R ← cayley(δω) R.
//
//   E ≈ energy + gᵀ x + ½ xᵀ H x,  x = (δc, δω)                                                J
//
// A contact with weights α_n along and α_t across its normal n and lever r from the body's centre adds
//     K = α_t 1 + (α_n − α_t) n nᵀ,     [ K      −K [r]     ]
//                                       [ [r] K   −[r] K [r] ]
// to H. The isotropic weights of the affine step would hold the body back along the contact plane too.
#pragma once

#include "sim/math/ldlt6.h"
#include "sim/solver/problem.h"

namespace pabd {

struct TangentModel {
  Mat6 H;
  Vec6 g;
  double energy;  // of the body and its bonds
  double room;    // way of a point to where a contact that does not push now would; m
};

// Of body i at the iterate. `moves_limits`: first moves the friction bounds of the manifolds whose owner
// the body is to μ f_n of the current iterate.
TangentModel tangent_model(const Problem& p, Index i, const Inertia& in, bool moves_limits, Iterate& it);

}  // namespace pabd
