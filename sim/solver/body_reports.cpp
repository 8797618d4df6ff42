// See body_reports.h.
#include "sim/solver/body_reports.h"

#include <Eigen/LU>

#include "sim/solver/islands.h"
#include "sim/solver/solve.h"

namespace pabd {
namespace {

// Half of each contact's energy for each of its two bodies: the sum over bodies is that of the contacts.
void share_contacts(const StepWorkspace::Impl& w, std::vector<BodyReport>& out) {
  for (const ContactPatch& patch : w.patches) {
    const ContactState s = contact_state(patch, w.pose[patch.a], w.pose[patch.b]);
    const Lanes energy = contact_energy(law_of(w, patch), patch, s);
    for (int k = 0; k < patch.count; ++k) {
      if (s.d[k] >= w.law.barrier.d_hat) continue;
      for (const Index i : {patch.a, patch.b}) {
        ++out[i].contacts;
        out[i].contact_energy += 0.5 * energy[k];
      }
    }
  }
}

}  // namespace

void report_bodies(const Model& model, SolverMethod method, StepWorkspace::Impl& w,
                   std::vector<BodyReport>& out) {
  out.assign(model.shape.size(), {});
  share_contacts(w, out);
  join_islands(model, w);
  w.cursor.assign(model.shape.size(), -1);  // root to number
  Index islands = 0;
  for (const Index i : w.solved) {  // in order of number
    BodyReport& body = out[i];
    Index& number = w.cursor[root(w.parent, i)];
    if (number < 0) number = islands++;
    body.island = number;
    if (method == SolverMethod::sissm) {
      body.solver = method;
      body.projection_change = w.projected[i];
      body.det_A = w.A[i].determinant();
    } else {
      body.solver = w.is_newton[i] ? SolverMethod::newton : SolverMethod::descent;
    }
  }
}

}  // namespace pabd
