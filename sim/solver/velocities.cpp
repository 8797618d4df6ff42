// SPDX-License-Identifier: MIT
#include "sim/solver/velocities.h"

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"

namespace pabd {

void find_velocities(const Problem& p, const Islands& islands, const Workers& workers, Iterate& it,
                     Velocities& out) {
  const Model& model = *p.model;
  out.v = p.flight->v;
  out.omega = p.flight->omega;
  workers.for_each(islands.solved.size(), [&](std::size_t k) {
    const Index i = islands.solved[k];
    const Pose& star = p.flight->star[i];
    Pose& pose = it.pose[i];
    if (pose.c == star.c && pose.R == star.R) return;  // flew freely
    if (!p.second_order(i) && pose.c == p.start->c[i] && pose.R == p.start->R[i]) {
      out.v[i] = out.omega[i] = Vec3::Zero();  // exactly, and so it stays
      return;
    }
    pose.R = reorthonormalized(pose.R);
    const double h = p.flight->h[i];
    out.v[i] += (pose.c - star.c) / h;
    const Mat3 I = inertia_tensor(model.J[i]);
    const Vec3 spin = star.R * (I * (star.R.transpose() * out.omega[i])) -
                      axial(star.R * model.J[i] * pose.R.transpose()) / h;
    out.omega[i] = pose.R * (symmetric_inverse(I) * (pose.R.transpose() * spin));
  });
}

}  // namespace pabd
