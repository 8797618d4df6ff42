// SPDX-License-Identifier: MIT
// `sissm`: the supplement's Jacobi iteration with its projection.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/workers.h"

namespace pabd {

// The affine iterate before the projection, one entry a body.
struct SissmMemory {
  std::vector<Mat3> A;
  std::vector<Vec3> c;
  std::vector<Pose> next;
  std::vector<double> projected;  // ‖A − R‖
};

// The supplement's global and local step, with relaxation. Fills it.moved. With `before` given, the smallest
// d before the projection is stored there.
void sissm_iteration(const Problem& p, const Island& island, const Workers& workers, double* before,
                     SissmMemory& memory, Iterate& it);

}  // namespace pabd
