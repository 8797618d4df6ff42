// SPDX-License-Identifier: MIT
// Memory that steps reuse, so that a warm step allocates nothing; it does not influence results.
#pragma once

#include <memory>
#include <vector>

#include "sim/solver/contact_setup.h"
#include "sim/solver/energy_bound.h"
#include "sim/solver/momentum.h"
#include "sim/solver/second_order.h"
#include "sim/solver/solve.h"
#include "sim/solver/time_step.h"

namespace pabd {

class Halves;

// Of joints: Ψ, J, and the largest error, m.
struct JointSum {
  double elastic = 0, error = 0;
  void operator+=(const JointSum& other) {
    elastic += other.elastic;
    error = larger(error, other.error);
  }
};

struct StepMemory {
  Flight flight;
  SecondOrder second_order;
  Detection detection, late;  // at the start, and where it ends
  std::vector<Joint> pulls;
  Problem problem;
  Iterate iterate;
  BondGraph graph;
  Islands islands;
  SolverMemory solvers;
  FreeGroups groups;
  Velocities velocities;
  EnergyMemory energy;
  std::vector<EnergyBalance> balance;  // of each island
  std::vector<std::uint8_t> again;     // per body: its island is made again in halves
  std::vector<Index> reported_joints;  // of the others
  std::vector<JointSum> joint_sums;
  std::unique_ptr<Halves> halves;  // once there were some
};

}  // namespace pabd
