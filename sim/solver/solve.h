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

inline ContactState state_of(const StepWorkspace::Impl& w, const ContactPatch& patch) {
  return contact_state(patch, w.pose[patch.a], w.pose[patch.b]);
}

// Gauss–Seidel over the colours; E does not rise (for fixed friction bounds). `backward` turns the order
// round. Fills w.moved for the bodies that have bonds.
void descent_sweep(const SolveContext& s, bool backward);

// The supplement's global and local step: Jacobi over bodies with relaxation. Fills w.moved, w.projected and
// w.A. With `before` given, the smallest d before the projection is stored there.
void sissm_iteration(const SolveContext& s, double* before);

// Incremental potential E at the current iterate; J.
double incremental_potential(const SolveContext& s);

}  // namespace pabd
