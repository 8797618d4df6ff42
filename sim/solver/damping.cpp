// SPDX-License-Identifier: MIT
// See damping.h.
#include "sim/solver/damping.h"

namespace pabd {

void damp_contacts(const Problem& p, Iterate& it) {
  const double steps = p.params->contact.damping / p.params->h;  // τ/h
  if (!(steps > 0) || is_feasible_only(p.law.barrier.kind)) return;
  for (ContactManifold& manifold : it.manifold) {
    if (manifold.recovers) continue;
    manifold.damped = 1 + steps;
    manifold.shift = -steps * smaller(manifold.start_d, lanes(p.law.barrier.d_hat));
  }
}

}  // namespace pabd
