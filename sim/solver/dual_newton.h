// SPDX-License-Identifier: MIT
// `newton` for what only ball joints hold together: chains, nets, cloths of plates. The same step, found from
// the forces of the joints instead of the moves of the bodies, in 3×3 blocks instead of 6×6 ones.
//
//   e_j = y_b − y_a      what joint j is open by                              m
//   f_j                  gradient of its energy on y_b after the step         N
//   J                    rows ±[1, −[r]] of the points, e.g. δy_b = δc + δω × r
//   M_i                  inertia of body i, with the geometric stiffness of the forces it feels: 3×3 + 3×3
//   g                    gradient of the inertia part
//
//   M δ + g + Jᵀ f = 0  and  f = Ψ'/‖e‖ e + Ψ'' J δ   give   (1/Ψ'' + J M⁻¹ Jᵀ) f = Ψ'/(Ψ''‖e‖) e − J M⁻¹ g
//
// The stiffer the joints, the better this system is posed; the other way round for the bodies' one.
#pragma once

#include "sim/math/block_cholesky.h"
#include "sim/solver/island_step.h"
#include "sim/solver/workers.h"

namespace pabd {

// Of one island. Block rows are its joints. Kept from step to step while the island stays the same.
struct DualSystem {
  // What the structure is of: the bodies, and for each joint the rows of its two (−1: not moved here).
  using Rows = std::vector<std::pair<Index, Index>>;
  std::vector<Index> bodies;
  Rows rows;
  bool fits;  // its factorisation is cheap enough

  struct End {
    Index joint;  // row
    bool is_b;
  };
  RowList<End> ends;  // per body of the island
  BlockCholesky<3> matrix;

  // Per body: M⁻¹ by its parts, and M⁻¹ g.
  struct Compliance {
    double mass;  // 1/(m/h²)
    Mat3 turn;
    Vec3 c, w;
  };
  std::vector<Compliance> compliance;
  // Per joint.
  std::vector<Vec3> r_a, r_b;  // levers; world, m
  std::vector<Vec3> force;     // f
  std::vector<Vec3> solution;  // right-hand side, then f
};

// Can the island be taken so? Its joints are spherical ones that nothing turns, no pull is on it, and the
// factorisation takes at most `most_products` products of 6×6 blocks, or what costs as much.
bool find_dual_structure(const Problem& p, const Island& island, const Iterate& it, double most_products,
                         DualSystem& system);

// Before the first iteration of a step: the forces are those of the last one.
void start_dual(const Problem& p, const Island& island, DualSystem& system);

// One iteration: δ, its forces, and E before it. False where it cannot be made, and nothing is changed: a
// contact pushes, or the system is not positive definite.
bool dual_step(const Problem& p, const Island& island, const Iterate& it, const Stop& stop,
               DualSystem& system, IslandStep& out, double& energy);

}  // namespace pabd
