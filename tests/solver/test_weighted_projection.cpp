// SPDX-License-Identifier: MIT
// The weighted projection is the exact minimiser of the body's quadratic model over SE(3).

#include "sim/solver/weighted_projection.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/support/draws.h"

namespace pabd::test_weighted_projection {

namespace {

// The model's energy, from its definition: ½ tr(Q H Qᵀ) − tr(Q bᵀ) with Q = [δc R].
double energy(const AffineModel& q, const Vec3& dc, const Mat3& R) {
  Mat4 H;
  H << q.h_c, q.h_A.transpose(), q.h_A, q.H_A;
  Mat34 b, Q;
  b << q.b_c, q.b_A;
  Q << dc, R;
  return 0.5 * (Q * H * Q.transpose()).trace() - (Q * b.transpose()).trace();
}

}  // namespace

TEST_CASE("no rigid pose has less energy than the weighted projection") {
  std::mt19937 rng(3);
  std::normal_distribution<double> normal;
  const auto vector = [&](double scale) {
    return Vec3(scale * testing::draw_vector([&] { return normal(rng); }));
  };
  for (int k = 0; k < 50; ++k) {
    AffineModel q{5, Vec3::Zero(), Mat3(Vec3(1, 2, 3).asDiagonal()), vector(3), Mat3::Zero()};
    q.b_A = exp_so3(vector(1)) * q.H_A;
    for (int bond = 0; bond < 4; ++bond) {
      const double alpha = 10 * std::abs(normal(rng));
      const Vec3 r = vector(1), target = alpha * vector(1);
      q.h_c += alpha;
      q.h_A += alpha * r;
      q.H_A += alpha * r * r.transpose();
      q.b_c += target;
      q.b_A += target * r.transpose();
    }
    const Mat3 R = weighted_rotation(q, Mat3::Identity());
    const Vec3 dc = weighted_translation(q, R);
    const double best = energy(q, dc, R);
    for (int trial = 0; trial < 200; ++trial) {
      const double reach = trial % 2 ? 1.0 : 1e-3;
      const Vec3 moved = dc + vector(reach);
      const Mat3 turned = exp_so3(vector(reach)) * R;
      CHECK(energy(q, moved, turned) >= best - 1e-12 * std::abs(best));
    }
  }
}

}  // namespace pabd::test_weighted_projection
