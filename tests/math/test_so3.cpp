// SPDX-License-Identifier: MIT
// SO(3) against identities and an independent SVD.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "sim/math/so3.h"
#include "tests/support/draws.h"

namespace pabd::test_so3 {

namespace {

Vec3 random_vector(std::mt19937& rng, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  return {uniform(rng), uniform(rng), uniform(rng)};
}

Mat3 random_matrix(std::mt19937& rng) {
  Mat3 B;
  for (int k = 0; k < 3; ++k) B.col(k) = random_vector(rng, 1);
  return B;
}

// max tr(Rᵀ B) over SO(3) is σ₁ + σ₂ ± σ₃, the sign that of det B (Kabsch).
double best_trace(const Mat3& B) {
  const Vec3 sigma = Eigen::JacobiSVD<Mat3>(B).singularValues();
  return sigma[0] + sigma[1] + (B.determinant() < 0 ? -sigma[2] : sigma[2]);
}

}  // namespace

TEST_CASE("a short turn is the exponential, both ways") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double angle : {0.0, 1e-300, 1e-9, 1e-3, 0.3, 1.0}) {
    for (int k = 0; k < 20; ++k) {
      const auto draw = [&] { return number(random); };
      const Vec3 axis = testing::draw_vector(draw).normalized(), x = testing::draw_vector(draw);
      const Mat3 R = exp_so3(angle * axis);
      const ShortTurn turn(angle * axis);
      CHECK((turn.turn(x) - R * x).norm() < 1e-15);
      CHECK((turn.back(x) - R.transpose() * x).norm() < 1e-15);
    }
  }
}

TEST_CASE("exp of a rotation vector turns by its angle about its axis") {
  const Mat3 R = exp_so3({0, 0, kPi / 2});
  CHECK((R * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-15);
  const Vec3 w(1e-9, -2e-9, 3e-9);
  CHECK((exp_so3(w) - Mat3::Identity() - skew(w)).norm() < 1e-16);
}

TEST_CASE("log undoes exp from zero angle to nearly pi") {
  std::mt19937 rng(7);
  for (const double angle : {0.0, 1e-15, 1e-9, 1e-4, 0.5, 2.0, 3.1, 3.14159}) {
    const Vec3 w = angle * random_vector(rng, 1).normalized();
    CHECK((log_so3(exp_so3(w)) - w).norm() < 1e-9 * angle + 1e-15);
  }
}

TEST_CASE("the projection is a rotation that maximises the trace, for every sign of the determinant") {
  std::mt19937 rng(11);
  for (int k = 0; k < 2000; ++k) {
    Mat3 B = random_matrix(rng);
    if (k % 5 == 0) B.col(2) = B.col(0);  // rank 2
    if (k % 7 == 0) B = -B;               // det changes its sign
    const Mat3 R = project_to_so3(B, exp_so3(random_vector(rng, 2)));
    CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-13);
    CHECK(R.determinant() == Approx(1).epsilon(1e-13));
    CHECK((R.transpose() * B).trace() == Approx(best_trace(B)).margin(1e-12));
  }
}

TEST_CASE("the projection of a rotation is that rotation, and of nothing the guess") {
  const Mat3 R = exp_so3({0.3, -0.2, 0.9});
  CHECK((project_to_so3(1e6 * R, Mat3::Identity()) - R).norm() < 1e-14);
  CHECK(project_to_so3(Mat3::Zero(), R) == R);
}

TEST_CASE("reorthonormalisation squares the distance to SO(3)") {
  Mat3 R = exp_so3({1, 2, 3});
  R(0, 1) += 1e-7;
  CHECK((reorthonormalized(R).transpose() * reorthonormalized(R) - Mat3::Identity()).norm() < 1e-13);
}

TEST_CASE("the Cayley map gives rotations by 2 atan(|w|/2) about w, and is undone by its inverse") {
  for (const double length : {0.0, 1e-9, 1e-3, 0.137, 1.0, 5.0}) {
    const Vec3 w = length * Vec3(1, -2, 3).normalized();
    const Mat3 R = cayley(w);
    CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-15);
    CHECK((R - exp_so3(2 * std::atan(length / 2) * Vec3(1, -2, 3).normalized())).norm() < 1e-14);
    CHECK((cayley_inverse(R) - w).norm() < 1e-13 * (1 + length));
  }
}

TEST_CASE("the shortest turn of one direction into another, also where they are nearly or quite opposite") {
  std::mt19937 rng(7);
  const auto check = [](const Vec3& from, const Vec3& to, double tolerance) {
    const Mat3 R = rotation_between(from, to);
    const double cosine = from.normalized().dot(to.normalized());
    CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-13);
    CHECK(R.determinant() == Approx(1).epsilon(1e-13));
    CHECK((R * from.normalized() - to.normalized()).norm() < tolerance);
    CHECK(R.trace() == Approx(1 + 2 * cosine).margin(1e-12));
  };
  for (int k = 0; k < 200; ++k) {
    const Vec3 from = random_vector(rng, 3), to = random_vector(rng, 0.2);
    check(from, to, 1e-13);
    check(from, from, 1e-13);
    check(from, -0.5 * from, 1e-13);
    // Taken for opposite from an angle of 1e-6 on; before, the cosine has lost half of its digits.
    for (double off = 1e-1; off > 1e-12; off *= 0.1)
      check(from, exp_so3(off * from.unitOrthogonal()) * -from, std::min(off, 1e-6) + 1e-9);
  }
  for (int axis = 0; axis < 3; ++axis) check(Vec3::Unit(axis), -Vec3::Unit(axis), 1e-15);
}

}  // namespace pabd::test_so3
