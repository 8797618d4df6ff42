// One iteration of each solver, on the arrays of the workspace.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/inertia.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"
#include "sim/solver/workspace.h"

namespace pabd {

struct SolveContext {
  const Model& model;
  const Params& params;
  int threads;
  double time;  // at the end of the step, for driven joints; s
  StepWorkspace::Impl& w;
};

inline Inertia inertia_of(const SolveContext& s, Index i) {
  return {s.model.mass[i], s.model.J[i], s.w.star[i], 1 / (s.params.h * s.params.h)};
}

[[gnu::always_inline]] inline ContactState state_of(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  return contact_state(patch, w.pose[patch.a], w.pose[patch.b]);
}

// Laws of a contact patch and of a joint in this step: `sissm` caps their stiffness.
inline ContactLaw law_of(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  return scaled(w.law, patch.share);
}
inline BondLaw law_of(const StepWorkspace::Impl& w, Index joint) {
  const auto k = static_cast<std::size_t>(joint);
  BondLaw law = w.all_joints[k].law;
  law.kappa *= w.joint_share[k];
  return law;
}

struct DescentSweep {
  bool first;        // of the solve
  bool move_limits;  // move the friction bounds to the current iterate on the way
  bool every_body;   // relax quiet bodies too
};

// Gauss–Seidel over the colours; E does not rise (for fixed friction bounds). Fills w.moved for the bodies
// that have bonds: of those that are left alone it stays what it was.
void descent_sweep(const SolveContext& s, const DescentSweep& sweep);

// Was any body left alone in the last sweep?
bool any_rests(const StepWorkspace::Impl& w);

// Does the sweep move the friction bounds as well?
inline bool sweeps_limits(const SolveContext& s, SolverMethod method) {
  return method != SolverMethod::sissm && s.params.solver.projection != Projection::weighted;
}

// The supplement's global and local step: Jacobi over bodies with relaxation. Fills w.moved, w.projected and
// w.A. With `before` given, the smallest d before the projection is stored there.
void sissm_iteration(const SolveContext& s, double* before);

// Incremental potential E at the current iterate; J.
double incremental_potential(const SolveContext& s);

}  // namespace pabd
