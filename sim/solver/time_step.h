// SPDX-License-Identifier: MIT
// One time step: the only thing that moves bodies.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// A hand on a body: during a step a soft spring of rest length 0 S(1) from a place in the world to a point of
// the body. Not part of the model; its energy is part of E and of StepReport::elastic. Every solver takes it;
// it does not change which solver `auto` chooses.
struct Pull {
  Index body;    // a number of the model; a fixed body is not pulled
  Vec3 r;        // where it is held; body frame, m
  Vec3 target;   // where it is pulled to; world, m
  double kappa;  // stiffness, > 0; N/m
};

// What a step does beside moving the bodies. Only pulls change where they go, and `stop` whether they go at all.
struct StepOptions {
  bool record_iterations = false;  // fill StepReport::records (costs one pass over the contacts an iteration)
  bool report_contacts = false;    // fill StepReport::contact_reports
  int threads = 1;                 // results are bit-identical for every value
  std::vector<Pull> pulls = {};    // finite
  bool report_bodies = false;      // fill StepReport::body_reports (one pass over bodies and contacts)
  bool report_joints = false;      // fill StepReport::joint_reports (one pass over the joints)
  bool bodies_stay = false;        // an engine need not say where bodies are: StepEngine::step
  bool is_half = false;            // of a step that is made again (halving.h)
  // Asked between pieces of work, in a slow step many times and from any thread: true ends the step at once,
  // as StepStatus::interrupted.
  std::function<bool()> stop = {};
};

struct StepMemory;

// Scratch memory that survives from step to step so that a step does not allocate once it is warm. Holds
// nothing that influences a result: a fresh one gives the same bytes.
class StepWorkspace {
 public:
  StepWorkspace();
  ~StepWorkspace();
  StepWorkspace(StepWorkspace&&) noexcept;
  StepWorkspace& operator=(StepWorkspace&&) noexcept;

  StepMemory& memory() { return *memory_; }

 private:
  std::unique_ptr<StepMemory> memory_;
};

// Advances `state` by params.h. Precondition: check_params(params) is empty, state.size() == model.size(),
// options.pulls are of bodies of the model.
// Never throws for physics: a step with a result that is not finite reports StepStatus::non_finite, one that was
// stopped StepStatus::interrupted, and both keep the state of their start. `report` is overwritten; its
// vectors are reused.
void step(const Model& model, const Params& params, const StepOptions& options, State& state,
          StepWorkspace& workspace, StepReport& report);

// κ of the contacts in J: the given one, or for "auto" the κ at which all that can press on a body rests on
// four contacts at d = 0.9 d̂: the weight of all movable bodies, at most that of a hundred of the heaviest and
// at least that of ten (with 9.81 m/s² where gravity is zero). Not so stiff that the rounding of a place 10
// km from the origin outweighs the lightest body, unless ten of the heaviest ask for it. Linear in the number
// of bodies.
double resolve_kappa(const Model& model, const Params& params);

}  // namespace pabd
