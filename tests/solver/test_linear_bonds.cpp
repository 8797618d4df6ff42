// SPDX-License-Identifier: MIT
// The weights of contact manifolds that `newton` solves with, against differences of their own gradients.
#include <catch2/catch.hpp>

#include "sim/solver/linear_bonds.h"

namespace pabd::test_linear_bonds {

namespace {

constexpr double kRadiusA = 0.3, kRadiusB = 0.2;

// A ball a under a ball b, which has slid past it by `slid` since the step began; without turns.
struct Pair {
  ContactLaw law{{BarrierKind::polynomial, 5, 0.01, 1e3, 1}, 2e5};
  Iterate it;

  explicit Pair(const Vec3& slid, double limit) {
    it.pose = {{Vec3::Zero(), Mat3::Identity()},
               {Vec3(0, kRadiusA + kRadiusB + 0.004, 0) + slid, Mat3::Identity()},
               {Vec3::Zero(), Mat3::Identity()}};
    it.roll.resize(3);
    Rolling rolling;
    rolling.radius_b = rolling.arm_b = lanes(kRadiusB);
    rolling.arm_a = lanes(kRadiusA);
    it.rolling = {rolling};
    ContactManifold ball{};
    ball.b = 1;
    ball.count = 1;
    ball.separate = true;
    ball.mu = 0.5;
    const Vec3 n = Vec3::UnitY();
    set_lane(ball.n, 0, n);
    ball.gap[0] = -kRadiusA - kRadiusB;
    set_lane(ball.rolled, 0, Vec3(n * (kRadiusA + kRadiusB)));
    ball.limit = lanes(0);
    ball.limit[0] = limit;
    it.manifold = {ball};
  }

  void move(std::size_t body, const Vec6& by) {
    const Pose from = it.pose[body];
    it.pose[body] = {from.c + by.head<3>(), cayley(by.tail<3>()) * from.R};
    it.roll[body] = roll_since_prediction(Mat3::Identity(), it.pose[body].R);
  }
};

// T of sim/solver/newton.cpp: a move of b seen from the centre of a.
Mat6 seen_from_a(const Vec3& back) {
  Mat6 T = Mat6::Identity();
  T.topRightCorner<3, 3>() = -skew(back);
  return T;
}

}  // namespace

TEST_CASE("the weights of balls that slid past each other are the derivatives of their forces") {
  const double limit = GENERATE(0.0, 1e9);  // without friction; sticking
  const Vec3 slid = GENERATE(Vec3(0, 0, 0), Vec3(0.05, 0, 0), Vec3(-0.02, 0, 0.08));
  CAPTURE(limit, slid.transpose());
  Pair pair(slid, limit);
  const LinearManifold at = linearize(pair.law, pair.it, pair.it.manifold[0]);
  REQUIRE(at.active);
  const Mat6 T = seen_from_a(at.normal.back);
  const Mat6 of_b = T.transpose() * at.H_b() * T, of_both = -T.transpose() * at.H_ba();
  constexpr double kStep = 1e-7;
  for (int k = 0; k < 6; ++k) {
    const Vec6 by = kStep * Vec6::Unit(k);
    Pair moved_a(slid, limit), moved_b(slid, limit);
    moved_a.move(0, by);
    moved_b.move(1, by);
    const LinearManifold after_a = linearize(pair.law, moved_a.it, moved_a.it.manifold[0]);
    const LinearManifold after_b = linearize(pair.law, moved_b.it, moved_b.it.manifold[0]);
    CAPTURE(k);
    const double scale = 1e-4 * at.H.norm();
    CHECK(((after_a.g_a - at.g_a) / kStep - at.H.col(k)).norm() < scale);
    CHECK(((after_a.g_b - at.g_b) / kStep - of_both.col(k)).norm() < scale);
    CHECK(((after_b.g_b - at.g_b) / kStep - of_b.col(k)).norm() < scale);
    CHECK(((after_b.g_a - at.g_a) / kStep - of_both.row(k).transpose()).norm() < scale);
    // The normal force's answer too.
    Vec6 row_b;
    for (int c = 0; c < 3; ++c) row_b[c] = at.normal.row[c][0], row_b[c + 3] = at.normal.arm_b[c][0];
    const double told = -at.normal.alpha_n[0] * row_b.dot(T.col(k));
    CHECK((after_b.normal.force[0] - at.normal.force[0]) / kStep ==
          Approx(told).margin(1e-4 * at.normal.alpha_n[0]));
  }
}

TEST_CASE("the exact weight is the derivative of a force that bends, where its majoriser is too stiff") {
  // A ball on a ball, pressed beyond the onset: Ψ' = −κ/d̂ (1 + u + u²) with u = 0.6, so that Ψ'' = κ/d̂² (1 + 2 u).
  Pair pair(Vec3::Zero(), 0);
  pair.law.barrier.N = 3;
  pair.law.barrier.onset = 0.2;
  const auto stiffness = [&](NormalWeight weight) {
    return linearize(pair.law, pair.it, pair.it.manifold[0], weight).H(1, 1);
  };
  const double unit = pair.law.barrier.kappa / (pair.law.barrier.d_hat * pair.law.barrier.d_hat), u = 0.6;
  CHECK(stiffness(NormalWeight::exact) == Approx(unit * (1 + 2 * u)).epsilon(1e-9));
  CHECK(stiffness(NormalWeight::majorising) == Approx(unit * (1 + u + u * u) / u).epsilon(1e-9));
  // Within the onset both are the same.
  pair.it.pose[1].c += Vec3(0, 0.005, 0);
  CHECK(stiffness(NormalWeight::exact) == stiffness(NormalWeight::majorising));
}

}  // namespace pabd::test_linear_bonds
