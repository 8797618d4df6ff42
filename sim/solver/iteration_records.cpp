// SPDX-License-Identifier: MIT
#include "sim/solver/iteration_records.h"

#include <algorithm>
#include <limits>

#include "sim/math/extremes.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// Incremental potential E of an island; J.
double incremental_potential(const Problem& p, const Island& island, const Iterate& it) {
  double energy = 0;
  for (const Index i : island.bodies) energy += inertia_energy(p.inertia(i), it.pose[i]);
  for (const Index k : island.manifolds) {
    const ContactManifold& manifold = it.manifold[k];
    energy += sum(contact_energy(p.law_of(manifold), manifold, state_of(it, manifold))) +
              turn_energy(p.law_of(manifold), manifold, it);
  }
  for (const Index k : island.joints) energy += potential_of_joint(p, it, k);
  return energy;
}

double smallest_gap(const Island& island, const Iterate& it) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Index j : island.manifolds) {
    const ContactState s = state_of(it, it.manifold[j]);
    for (int k = 0; k < it.manifold[j].count; ++k) gap = smaller(gap, s.d[k]);
  }
  return gap;
}

void add(const IterationRecord& one, IterationRecord& sum) {
  sum.energy += one.energy;
  sum.residual = larger(sum.residual, one.residual);
  sum.max_penetration_before = larger(sum.max_penetration_before, one.max_penetration_before);
  sum.max_penetration_after = larger(sum.max_penetration_after, one.max_penetration_after);
  sum.min_gap_before = smaller(sum.min_gap_before, one.min_gap_before);
  sum.min_gap_after = smaller(sum.min_gap_after, one.min_gap_after);
  sum.max_joint_error = larger(sum.max_joint_error, one.max_joint_error);
  sum.projection_change = larger(sum.projection_change, one.projection_change);
}

}  // namespace

IterationRecord record(const Problem& p, const Island& island, const Iterate& it) {
  IterationRecord r{};
  r.energy = incremental_potential(p, island, it);
  r.min_gap_after = r.min_gap_before = smallest_gap(island, it);
  r.max_penetration_after = r.max_penetration_before = larger(0, -r.min_gap_after);
  for (const Index k : island.joints)
    r.max_joint_error = larger(r.max_joint_error, result_of_joint(p, it, k).error);
  return r;
}

void merge_records(const std::vector<std::vector<IterationRecord>>& islands, std::size_t count,
                   StepReport& report) {
  std::size_t longest = 0;
  for (std::size_t k = 0; k < count; ++k) longest = std::max(longest, islands[k].size());
  for (std::size_t j = 0; j < longest; ++j) {
    IterationRecord sum{};
    sum.min_gap_before = sum.min_gap_after = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k) {
      if (!islands[k].empty()) add(islands[k][std::min(j, islands[k].size() - 1)], sum);
    }
    if (j == 0) {
      report.first_iterate = sum;
    } else {
      report.records.push_back(sum);
    }
  }
}

}  // namespace pabd
