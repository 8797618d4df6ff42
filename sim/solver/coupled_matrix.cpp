// SPDX-License-Identifier: MIT
#include "sim/solver/coupled_matrix.h"

namespace pabd {

double CoupledMatrix::add(const Island& island, const LinearCoupling& coupling, std::vector<Vec6>& g) {
  if (count_ == couplings_.size()) couplings_.emplace_back();
  Coupling& added = couplings_[count_++];
  added.stiffness = coupling.stiffness;
  added.count = coupling.count;
  for (int k = 0; k < coupling.count; ++k) {
    const auto& [body, gradient] = coupling.ends[k];
    const Index row = island.row[body];
    added.ends[k] = {row, gradient};
    g[row] += coupling.stiffness * coupling.error * gradient;
  }
  return 0.5 * coupling.stiffness * coupling.error * coupling.error;
}

double CoupledMatrix::along(const Coupling& coupling, const std::vector<Vec6>& x) {
  double sum = 0;
  for (int k = 0; k < coupling.count; ++k) {
    const End& end = coupling.ends[k];
    sum += end.G.dot(x[end.row]);
  }
  return sum;
}

bool CoupledMatrix::factorize(const Stop& stop) {
  if (!BlockCholesky<6>::factorize(stop)) return false;
  if (count_ == 0) return true;
  const auto size = static_cast<Eigen::Index>(count_);
  small_.resize(size, size);
  for (std::size_t n = 0; n < count_; ++n) {
    Coupling& coupling = couplings_[n];
    coupling.Z.assign(static_cast<std::size_t>(rows()), Vec6::Zero());
    for (int k = 0; k < coupling.count; ++k) {
      const End& end = coupling.ends[k];
      coupling.Z[end.row] += end.G;
    }
    BlockCholesky<6>::solve(coupling.Z);
    const auto column = static_cast<Eigen::Index>(n);
    for (Eigen::Index row = 0; row < size; ++row) small_(row, column) = along(couplings_[row], coupling.Z);
    small_(column, column) += 1 / coupling.stiffness;
  }
  factor_.compute(small_);
  return factor_.info() == Eigen::Success;
}

void CoupledMatrix::solve(std::vector<Vec6>& y) const {
  BlockCholesky<6>::solve(y);
  if (count_ == 0) return;
  share_.resize(static_cast<Eigen::Index>(count_));
  for (std::size_t n = 0; n < count_; ++n) share_[static_cast<Eigen::Index>(n)] = along(couplings_[n], y);
  factor_.solveInPlace(share_);
  for (std::size_t n = 0; n < count_; ++n) {
    const double share = share_[static_cast<Eigen::Index>(n)];
    for (std::size_t k = 0; k < y.size(); ++k) y[k] -= share * couplings_[n].Z[k];
  }
}

}  // namespace pabd
