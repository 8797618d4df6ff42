// SPDX-License-Identifier: MIT
// See body_reports.h.
#include "sim/solver/body_reports.h"

#include <Eigen/LU>

#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

// Half of each contact's energy for each of its two bodies: the sum over bodies is that of the contacts.
void share_contacts(const Problem& p, const Iterate& it, std::vector<BodyReport>& out) {
  for (const ContactManifold& manifold : it.manifold) {
    const ContactState s = state_of(it, manifold);
    const Lanes energy = contact_energy(p.law_of(manifold), manifold, s);
    for (const Index i : {manifold.a, manifold.b})
      out[i].contact_energy += 0.5 * turn_energy(p.law_of(manifold), manifold, it);
    for (int k = 0; k < manifold.count; ++k) {
      if (s.d[k] >= p.law.barrier.d_hat) continue;
      for (const Index i : {manifold.a, manifold.b}) {
        ++out[i].contacts;
        out[i].contact_energy += 0.5 * energy[k];
      }
    }
  }
}

}  // namespace

void report_bodies(const Problem& p, const Islands& islands, const std::vector<IslandReport>& solved,
                   const Iterate& it, const SissmMemory& sissm, std::vector<BodyReport>& out) {
  out.assign(p.model->shape.size(), {});
  share_contacts(p, it, out);
  for (const Index i : islands.solved) {
    BodyReport& body = out[i];
    body.island = islands.of[i];
    body.solver = solved[body.island].solver;
    if (body.solver != SolverMethod::sissm) continue;
    body.projection_change = sissm.projected[i];
    body.det_A = sissm.A[i].determinant();
  }
}

}  // namespace pabd
