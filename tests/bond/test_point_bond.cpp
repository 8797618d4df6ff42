// SPDX-License-Identifier: MIT
// Bonds between points: energy against the closed form, force and weight against finite differences of it.

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/bond/point_bond.h"

namespace pabd::test_point_bond {

namespace {

const Vec3 kAlong = Vec3(2, -1, 3).normalized();
const Vec3 kFree = Vec3(1, 4, -2).normalized();

std::vector<BondLaw> laws() {
  std::vector<BondLaw> out{{BondPotential::soft, 0, 350, 0}};
  for (const int N : {2, 4, 7}) out.push_back({BondPotential::hard, N, 12, 0.02});
  return out;
}

// Stretched by s along kAlong, length l.
PointBond bond_of(double l, double s, bool slides) {
  PointBond bond{Vec3(0.3, -0.2, 0.9), Vec3(0.3, -0.2, 0.9) + (l + s) * kAlong, l};
  if (slides) {
    bond.slides = true;
    bond.free_axis = kFree;
    bond.y_b += 0.4 * kFree;
  }
  return bond;
}

double energy_at(const BondLaw& law, PointBond bond, const Vec3& y_b) {
  bond.y_b = y_b;
  return evaluate(law, bond).energy;
}

}  // namespace

TEST_CASE("a soft bond holds ½ κ s², a hard one the even part of the barrier, term by term") {
  for (const double l : {0.0, 0.5}) {
    for (const double s : {1e-4, 0.003, 0.05}) {
      CHECK(evaluate(BondLaw{BondPotential::soft, 0, 350, 0}, bond_of(l, s, false)).energy ==
            Approx(0.5 * 350 * s * s).epsilon(1e-10));
      for (const int N : {2, 5, 8}) {
        double sum = 0;
        for (int m = 1; m <= N / 2; ++m) sum += std::pow(s / 0.02, 2 * m) / (2 * m);
        const PointBondForce f = evaluate(BondLaw{BondPotential::hard, N, 12, 0.02}, bond_of(l, s, false));
        CHECK(f.energy == Approx(12 * sum).epsilon(1e-10));
        CHECK(f.stretch == Approx(s).epsilon(1e-10));
      }
    }
  }
}

TEST_CASE("the force of a bond is the slope of its energy") {
  const double step = 1e-6;
  for (const BondLaw& law : laws()) {
    for (const bool slides : {false, true}) {
      for (const double l : {0.0, 0.5}) {
        for (const double s : {-0.011, 0.004, 0.017}) {
          const PointBond bond = bond_of(l, s, slides);
          const PointBondForce f = evaluate(law, bond);
          CAPTURE(law.N, slides, l, s);
          Vec3 slope;
          for (int k = 0; k < 3; ++k) {
            const Vec3 shift = step * Vec3::Unit(k);
            slope[k] = (energy_at(law, bond, bond.y_b + shift) - energy_at(law, bond, bond.y_b - shift)) /
                       (2 * step);
          }
          CHECK((f.gradient - slope).norm() < 1e-6 * slope.norm());
          CHECK((!slides || std::abs(f.gradient.dot(kFree)) < 1e-12 * f.gradient.norm()));
        }
      }
    }
  }
}

TEST_CASE("the weight of a stretched bond is its Hessian, of a squeezed one without what would soften it") {
  const double step = 1e-6;
  for (const BondLaw& law : laws()) {
    for (const double s : {-0.011, 0.004, 0.017}) {
      const PointBond bond = bond_of(0.5, s, false);
      const PointBondForce f = evaluate(law, bond);
      CAPTURE(law.N, s);
      Mat3 hessian;
      for (int k = 0; k < 3; ++k) {
        PointBond more = bond, less = bond;
        more.y_b += step * Vec3::Unit(k);
        less.y_b -= step * Vec3::Unit(k);
        hessian.col(k) = (evaluate(law, more).gradient - evaluate(law, less).gradient) / (2 * step);
      }
      const Mat3 along = kAlong * kAlong.transpose();
      const Mat3 expected = s > 0 ? hessian : Mat3(along * hessian * along);
      CHECK((f.weight - expected).norm() < 1e-5 * hessian.norm());
      CHECK(f.largest == Approx(f.weight.operatorNorm()).epsilon(1e-9));
      CHECK(f.weight.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > -1e-9 * f.largest);
    }
  }
}

}  // namespace pabd::test_point_bond
