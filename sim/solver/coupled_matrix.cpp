// SPDX-License-Identifier: MIT
// See coupled_matrix.h.
#include "sim/solver/coupled_matrix.h"

namespace pabd {

double CoupledMatrix::add(const Island& island, const LinearCoupling& coupling, std::vector<Vec6>& g) {
  Coupling& added = couplings_.emplace_back();
  added.stiffness = coupling.stiffness;
  added.count = coupling.count;
  for (int k = 0; k < coupling.count; ++k) {
    const auto& [body, gradient] = coupling.ends[static_cast<std::size_t>(k)];
    const Index row = island.row[body];
    added.ends[static_cast<std::size_t>(k)] = {row, gradient};
    g[static_cast<std::size_t>(row)] += coupling.stiffness * coupling.error * gradient;
  }
  return 0.5 * coupling.stiffness * coupling.error * coupling.error;
}

double CoupledMatrix::along(const Coupling& coupling, const std::vector<Vec6>& x) {
  double sum = 0;
  for (int k = 0; k < coupling.count; ++k) {
    const End& end = coupling.ends[static_cast<std::size_t>(k)];
    sum += end.G.dot(x[static_cast<std::size_t>(end.row)]);
  }
  return sum;
}

bool CoupledMatrix::factorize(const Stop& stop) {
  if (!BlockCholesky<6>::factorize(stop)) return false;
  if (couplings_.empty()) return true;
  const auto count = static_cast<Eigen::Index>(couplings_.size());
  for (Coupling& coupling : couplings_) {
    coupling.Z.assign(static_cast<std::size_t>(rows()), Vec6::Zero());
    for (int k = 0; k < coupling.count; ++k) {
      const End& end = coupling.ends[static_cast<std::size_t>(k)];
      coupling.Z[static_cast<std::size_t>(end.row)] += end.G;
    }
    BlockCholesky<6>::solve(coupling.Z);
  }
  Eigen::MatrixXd small(count, count);
  for (Eigen::Index m = 0; m < count; ++m)
    for (Eigen::Index n = 0; n < count; ++n)
      small(m, n) = along(couplings_[static_cast<std::size_t>(m)], couplings_[static_cast<std::size_t>(n)].Z);
  for (Eigen::Index n = 0; n < count; ++n)
    small(n, n) += 1 / couplings_[static_cast<std::size_t>(n)].stiffness;
  small_.compute(small);
  return small_.info() == Eigen::Success;
}

void CoupledMatrix::solve(std::vector<Vec6>& y) const {
  BlockCholesky<6>::solve(y);
  if (couplings_.empty()) return;
  Eigen::VectorXd x(static_cast<Eigen::Index>(couplings_.size()));
  for (Eigen::Index n = 0; n < x.size(); ++n) x[n] = along(couplings_[static_cast<std::size_t>(n)], y);
  const Eigen::VectorXd share = small_.solve(x);
  for (Eigen::Index n = 0; n < x.size(); ++n) {
    const std::vector<Vec6>& Z = couplings_[static_cast<std::size_t>(n)].Z;
    for (std::size_t k = 0; k < y.size(); ++k) y[k] -= share[n] * Z[k];
  }
}

}  // namespace pabd
