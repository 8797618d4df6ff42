// SPDX-License-Identifier: MIT
// See external.h.
#include "sim/solver/external.h"

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"

namespace pabd {

void add_external(const Model& model, Index i, double time, double h, Flight& flight) {
  const ExternalForce& external = *model.external[static_cast<std::size_t>(i)];
  const Vec3 dv = h / model.mass[i] * external.force_at(time), dL = h * external.torque_at(time);
  Pose& star = flight.star[i];
  star.c += h * dv;
  flight.v[i] += dv;
  if (dL.isZero(0)) return;
  const Mat3 I = inertia_tensor(model.J[i]), inverse = symmetric_inverse(I);
  const Vec3 L = turned(star.R, I) * flight.omega[i] + dL, turn = h * (turned(star.R, inverse) * dL);
  star.R = reorthonormalized(exp_so3(turn) * star.R);
  flight.turn[i] += turn;
  flight.omega[i] = turned(star.R, inverse) * L;
}

double external_work(const Problem& p, Index i, const Pose& end) {
  if (!has_external(*p.model, i)) return 0;
  const ExternalForce& external = *p.model->external[static_cast<std::size_t>(i)];
  const double from = p.time - p.params->h;
  const auto mean = [&](const Vec3& first, const Vec3& last) {
    return p.second_order(i) ? Vec3(0.5 * (first + last)) : last;
  };
  const Vec3 F = mean(external.force_at(from), external.force_at(p.time));
  const Vec3 torque = mean(external.torque_at(from), external.torque_at(p.time));
  return F.dot(end.c - p.start->c[i]) + torque.dot(turn_between(p.start->R[i], end.R));
}

}  // namespace pabd
