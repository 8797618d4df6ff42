// SPDX-License-Identifier: MIT
#include "sim/bond/point_bond.h"

#include <algorithm>
#include <cmath>

namespace pabd {

BondSlope evaluate(const BondLaw& law, double s) {
  if (law.potential == BondPotential::soft) return {0.5 * law.kappa * s * s, law.kappa * s, law.kappa};
  const double x = s / law.d_hat, x2 = x * x;
  double value = 0, first = 0, second = 0;
  for (int m = law.N / 2; m >= 1; --m) {
    value = value * x2 + 1.0 / (2 * m);
    first = first * x2 + 1;
    second = second * x2 + (2 * m - 1);
  }
  return {law.kappa * value * x2, law.kappa * first * x / law.d_hat,
          law.kappa * second / (law.d_hat * law.d_hat)};
}

PointBondForce evaluate(const BondLaw& law, const PointBond& bond) {
  if (bond.given) return *bond.given;
  Vec3 e = bond.y_b - bond.y_a;
  Mat3 P = Mat3::Identity();  // onto what the bond may feel
  if (bond.slides) {
    P -= bond.free_axis * bond.free_axis.transpose();
    e = P * e;
  }
  const double distance = e.norm();
  BondSlope psi = evaluate(law, distance - bond.length);
  psi = {bond.scale * psi.value, bond.scale * psi.first, bond.scale * psi.second};
  if (bond.length == 0) {
    // Ψ'/r is finite at r = 0: the mean slope over [0, r] is at most Ψ''.
    const double ratio = distance > 0 ? psi.first / distance : psi.second;
    return {psi.value, ratio * e, psi.second * P, psi.second, distance};
  }
  const Vec3 n = distance > 0 ? Vec3(e / distance) : Vec3::UnitY();
  const double across = distance > 0 ? std::max(0.0, psi.first / distance) : 0.0;
  const Mat3 nn = n * n.transpose();
  return {psi.value, psi.first * n, psi.second * nn + across * (P - nn), std::max(psi.second, across),
          std::abs(distance - bond.length)};
}

}  // namespace pabd
