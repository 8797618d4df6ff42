// SPDX-License-Identifier: MIT
// `newton` with friction: bounds are unknowns of an iteration like the moves of bodies (Deviation D12).
//
// With the bounds l of an iterate E has the Newton step δ = −H⁻¹ g. It changes the normal forces, and with them the bounds.
// Both at once, to first order, for the points that slide along t:
//
//   H δ + Σ D Δl = −g         D = ∂g/∂l, the wrench of a unit force along t
//   Δl = μ (f_n − α_n ∇d·δ) − l
//
// With the Δl eliminated this is δ = −(1 + H⁻¹ U)⁻¹ H⁻¹ g̃, with U = −Σ D μ α_n ∇dᵀ, which is not symmetric, and g̃ the
// gradient under l = μ f_n. It is solved by generalized conjugate residuals (Eisenstat, Elman, Schultz 1983): each costs one
// solve with the factor of H. Why: forces of the linear model are those of the step's end, even where those of the iterate are
// a thousand times too large; and δ is the Newton step of E under the new bounds: a line search on that E goes downhill.
#pragma once

#include "sim/solver/coupled_matrix.h"
#include "sim/solver/island_step.h"
#include "sim/solver/linear_bonds.h"

namespace pabd {

struct SlidingTangent {
  // Manifolds with friction that push or hold at the iterate, by number.
  std::vector<std::pair<Index, NormalRows>> active;

  // A point that slides. Rows are those of its bodies in the island, −1: not moved here.
  struct Point {
    Index a, b;
    Index manifold;
    int lane;
    double limit;               // l at the iterate; N
    double ahead;               // μ f_n − l there; N
    double change;              // Δl; N
    Vec6 closing_a, closing_b;  // μ α_n ∇d; N/m, N
    Vec6 drag_a, drag_b;        // D; –, m
  };
  std::vector<Point> points;
  std::vector<double> radius;             // of the island's bodies: what a turn moves; m
  std::vector<Vec6> plain, change, rest;  // the step of fixed bounds, what both together add, the residual
  std::vector<std::vector<Vec6>> way, image;  // directions, and what 1 + H⁻¹ U makes of them
};

// Turns `step`, that of fixed bounds, into the step of both, and moves the bounds of the active manifolds to its end. `matrix`
// is factorised. True if that changes E at the iterate.
bool follow_bounds(const Problem& p, const Island& island, const CoupledMatrix& matrix,
                   SlidingTangent& tangent, std::vector<Vec6>& step, Iterate& it);

}  // namespace pabd
