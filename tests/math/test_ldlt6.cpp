// SPDX-License-Identifier: MIT
// The unrolled 6×6 solver against Eigen's, and the sums of lanes against one at a time.

#include "sim/math/ldlt6.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "sim/math/lanes.h"

namespace pabd::test_ldlt6 {

namespace {

Mat6 random_matrix(std::mt19937& rng) {
  Mat6 A;
  for (int k = 0; k < 36; ++k) A(k) = rng() / 2147483648.0 - 1;
  return A;
}

}  // namespace

TEST_CASE("solve_ldlt leaves a residual of rounding size, also for stiffness ratios up to 1e14") {
  std::mt19937 rng(3);
  for (int k = 0; k < 2000; ++k) {
    const Mat6 Q = random_matrix(rng).householderQr().householderQ();
    Vec6 D, b;
    for (int i = 0; i < 6; ++i) {
      D(i) = std::pow(10.0, (k % 15) * (rng() / 4294967296.0));
      b(i) = rng() / 2147483648.0 - 1;
    }
    Mat6 H = Q * D.asDiagonal() * Q.transpose();
    H = Mat6(0.5 * (H + H.transpose()));
    bool definite = false;
    const Vec6 x = solve_ldlt(H, b, definite);
    if (k % 15 < 13) CHECK(definite);  // beyond, rounding may have made H indefinite
    if (!definite) continue;
    CHECK((H * x - b).norm() <= 1e-14 * (H.norm() * x.norm() + b.norm()));
  }
}

TEST_CASE("solve_ldlt says when a matrix is not positive definite, and stays finite") {
  Mat6 H = Mat6::Identity();
  H(4, 4) = -2;
  bool definite = true;
  CHECK(solve_ldlt(H, Vec6::Ones(), definite).allFinite());
  CHECK_FALSE(definite);
  CHECK(solve_ldlt(Mat6::Zero(), Vec6::Ones(), definite).allFinite());
  CHECK_FALSE(definite);
}

TEST_CASE("four sums at once are the same bits as one at a time") {
  std::mt19937 rng(4);
  Lanes v[4];
  for (Lanes& x : v) {
    for (int k = 0; k < kLanes; ++k) x[k] = rng() / 3.0e7 - 70;
  }
  const Lanes together = sums(v[0], v[1], v[2], v[3]);
  for (int k = 0; k < 4; ++k) CHECK(together[k] == sum(v[k]));
}

}  // namespace pabd::test_ldlt6
