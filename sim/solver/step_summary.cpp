#include "sim/solver/step_summary.h"

#include <algorithm>
#include <limits>

#include "sim/body/mass_properties.h"

namespace pabd {

double incremental_potential(const SolveContext& s) {
  double energy = 0;
  for (const Index i : s.w.colored) energy += inertia_energy(inertia_of(s, i), s.w.c[i], s.w.R[i]);
  for (const ContactBond& bond : s.w.bonds) energy += contact_energy(s.w.law, bond, state_of(s.w, bond));
  return energy;
}

double kinetic_energy(const Model& model, const State& state) {
  double energy = 0;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    const Vec3 w = state.R[i].transpose() * state.omega[i];
    energy += 0.5 * (model.mass[i] * state.v[i].squaredNorm() + w.dot(inertia_tensor(model.J[i]) * w));
  }
  return energy;
}

double potential_energy(const Model& model, const Params& params, const State& state) {
  double energy = 0;
  for (Index i = 0; i < model.size(); ++i) energy -= model.mass[i] * params.gravity.dot(state.c[i]);
  return energy;
}

double smallest_gap(const StepWorkspace::Impl& w) {
  double gap = std::numeric_limits<double>::infinity();
  for (const ContactBond& bond : w.bonds) gap = std::min(gap, state_of(w, bond).d);
  return gap;
}

void summarize_contacts(const StepWorkspace::Impl& w, bool with_reports, StepReport& report) {
  report.elastic = 0;
  report.contacts = 0;
  report.min_gap = std::numeric_limits<double>::infinity();
  report.contact_reports.clear();
  for (const ContactBond& bond : w.bonds) {
    const ContactState s = state_of(w, bond);
    report.min_gap = std::min(report.min_gap, s.d);
    if (s.d >= w.law.barrier.d_hat) continue;
    const ContactForce f = contact_force(w.law, bond, s);
    report.elastic += f.energy;
    ++report.contacts;
    if (!with_reports) continue;
    const bool sticking = bond.limit > 0 && w.law.k_t * s.u.norm() <= bond.limit;
    report.contact_reports.push_back(
        {bond.a, bond.b, s.y - s.d * s.n, s.y, s.n, s.d, -f.first, -f.alpha_t * s.u, sticking});
  }
  report.max_penetration = report.min_gap < 0 ? -report.min_gap : 0.0;
}

}  // namespace pabd
