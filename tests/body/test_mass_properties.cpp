// SPDX-License-Identifier: MIT
// Mass and second moment against textbook inertia tensors and against numerical quadrature.
//
//   The textbook gives the inertia tensor I about the centre of mass; J follows from J = ½ tr(I) 1 − I.
//   The quadrature is a midpoint rule over disks or slabs across y: error O(1/n²), about 1e-7 relative here.
#include <catch2/catch.hpp>
#include <functional>

#include "sim/body/mass_properties.h"
#include "sim/body/model.h"

namespace pabd::test_mass_properties {

namespace {

double relative_error(const Mat3& a, const Mat3& b) { return (a - b).norm() / b.norm(); }

// Solid of revolution about y with profile radius(y) on [−top, top].
MassProperties revolve(const std::function<double(double)>& radius, double top, double density) {
  const int n = 20000;
  const double dy = 2 * top / n;
  MassProperties sum{0, Mat3::Zero()};
  for (int k = 0; k < n; ++k) {
    const double y = -top + (k + 0.5) * dy, r = radius(y);
    const double disk = density * kPi * r * r * dy;
    sum.mass += disk;
    sum.J += Vec3(disk * r * r / 4, disk * y * y, disk * r * r / 4).asDiagonal();
  }
  return sum;
}

}  // namespace

TEST_CASE("a box has the textbook mass and inertia") {
  const double density = 700, x = 0.4, y = 1.2, z = 2.5;  // full edges
  const MassProperties p = mass_properties(Box{{x / 2, y / 2, z / 2}}, density);
  const double m = density * x * y * z;
  const Mat3 I = (m / 12 * Vec3(y * y + z * z, x * x + z * z, x * x + y * y)).asDiagonal();
  CHECK(p.mass == Approx(m).epsilon(1e-14));
  CHECK(relative_error(p.J, second_moment_of(I)) < 1e-14);
  CHECK(relative_error(inertia_tensor(p.J), I) < 1e-14);
}

TEST_CASE("a box agrees with quadrature over its volume") {
  const Vec3 half(0.3, 0.7, 0.2);
  const int n = 60;
  Mat3 J = Mat3::Zero();
  const Vec3 step = 2 * half / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3 r = -half + step.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5));
        J += 1000 * step.prod() * r * r.transpose();
      }
  // The midpoint rule over a uniform grid is low by exactly 1/n².
  CHECK(relative_error(J / (1 - 1.0 / (n * n)), mass_properties(Box{half}, 1000).J) < 1e-12);
}

TEST_CASE("a ball has the textbook inertia and agrees with quadrature") {
  const double density = 2500, r = 0.35;
  const MassProperties p = mass_properties(Sphere{r}, density);
  const double m = density * 4 / 3 * kPi * r * r * r;
  CHECK(p.mass == Approx(m).epsilon(1e-14));
  CHECK(relative_error(inertia_tensor(p.J), 0.4 * m * r * r * Mat3::Identity()) < 1e-14);

  const MassProperties q = revolve([&](double y) { return std::sqrt(r * r - y * y); }, r, density);
  CHECK(p.mass == Approx(q.mass).epsilon(1e-6));
  CHECK(relative_error(p.J, q.J) < 1e-6);
}

TEST_CASE("a capsule agrees with quadrature and with its limits") {
  const double density = 900, r = 0.2, length = 0.9;
  const MassProperties p = mass_properties(Capsule{r, length}, density);
  const auto profile = [&](double y) {
    const double beyond = std::max(0.0, std::abs(y) - length / 2);
    return std::sqrt(std::max(0.0, r * r - beyond * beyond));
  };
  const MassProperties q = revolve(profile, length / 2 + r, density);
  CHECK(p.mass == Approx(q.mass).epsilon(1e-6));
  CHECK(relative_error(p.J, q.J) < 1e-6);

  // Without a straight part it is a ball.
  CHECK(relative_error(mass_properties(Capsule{r, 0}, density).J, mass_properties(Sphere{r}, density).J) <
        1e-14);

  // Parallel axes, with half balls about their own centroids: I_xx = m_s (83/320 r² + (L/2 + 3r/8)²) +
  // cylinder.
  const double caps = density * 4 / 3 * kPi * r * r * r, rod = density * kPi * r * r * length;
  const double off = length / 2 + 3 * r / 8;
  const double I_xx = caps * (83.0 / 320 * r * r + off * off) + rod * (3 * r * r + length * length) / 12;
  const double I_yy = caps * 0.4 * r * r + rod * r * r / 2;
  CHECK(relative_error(inertia_tensor(p.J), Vec3(I_xx, I_yy, I_xx).asDiagonal()) < 1e-14);
}

TEST_CASE("inertia tensor and second moment are inverse to each other") {
  Mat3 root;
  root << 1.0, 0.2, -0.3, 0.1, 2.0, 0.4, -0.5, 0.3, 0.7;
  const Mat3 J = root * root.transpose();
  const Mat3 I = inertia_tensor(J);
  CHECK(relative_error(second_moment_of(I), J) < 1e-14);
  CHECK(I.trace() == Approx(2 * J.trace()).epsilon(1e-14));
}

TEST_CASE("a plane has no volume, mass grows with density, fixed bodies are not heavy") {
  CHECK(volume(Plane{Vec3::UnitY(), 0}) == 0);
  CHECK(volume(Box{{1, 2, 3}}) == Approx(48).epsilon(1e-15));
  CHECK(mass_properties(Sphere{1}, 20).mass ==
        Approx(2 * mass_properties(Sphere{1}, 10).mass).epsilon(1e-15));

  Model model;
  CHECK(movable_mass(model).heaviest == 0);
  model.shape = {Sphere{1}, Sphere{1}, Sphere{1}};
  model.mass = {2, 7, 5};
  model.fixed = {0, 1, 0};
  CHECK(movable_mass(model).heaviest == 5);
  CHECK(movable_mass(model).lightest == 2);
  CHECK(movable_mass(model).total == 7);
}

}  // namespace pabd::test_mass_properties
