// SPDX-License-Identifier: MIT
// From predicted poses to contact manifolds: detection, and where the iteration starts.
#pragma once

#include "sim/collision/detect.h"
#include "sim/solver/problem.h"

namespace pabd {

// Memory of the detection of a step.
struct Detection {
  CollisionWorkspace collision;
  std::vector<Vec3> c;  // where bodies are looked at, and how they come there: see Passage
  std::vector<Mat3> R;
  std::vector<Vec3> way;
  std::vector<double> spin, reach;  // m
  std::vector<ContactPoint> points;
  std::vector<std::size_t> first_point;  // of each manifold, and their number
  std::vector<ContactManifold> made;     // those of the last step as they were made, if any body rests
  std::vector<std::size_t> made_at;      // per manifold: its place among them, where it may be the same
};

// The law of all contacts of a step.
ContactLaw contact_law(const Model& model, const Params& params);

// Fills the manifolds of the iterate, sorted by pair and feature, with what friction remembers, and
// Problem::rolls. Precondition: p.model, params, start, flight and law are set.
void find_contacts(Problem& p, const Workers& workers, Detection& memory, Iterate& it);

// Damping of normal motion, `contact.damping` τ, for contacts that do not recover (recovery.h): the force is Ψ′ at d + τ ḋ,
// more while bodies come together, less while they part, never a pull. With ḋ = (d − d₀)/h at the end of a step that is
//
//   f = Ψ′(g d + s)      g = 1 + τ/h, s = −τ/h min(d₀, d̂)
//
// the slope of Ψ(g d + s)/g. Near rest it is a damper τ Ψ″ beside the spring Ψ″.
void damp_contacts(const Problem& p, Iterate& it);

// Fills the poses with the first iterate: Q* for a free body; for one that is touched the pose without this
// step's gravity, so that a resting body starts at its equilibrium. Log barrier: the start of the step, which
// is feasible.
void first_iterate(const Problem& p, Iterate& it);

}  // namespace pabd
