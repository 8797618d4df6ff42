// SPDX-License-Identifier: MIT
// One simulation that is being run: its scene, parameters, state and scratch memory. No drawing and no printing; any
// number of sessions may live side by side.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "app/session/frame_view.h"
#include "app/session/model_edit.h"
#include "sim/scene/scene.h"
#include "sim/solver/step_engine.h"

namespace pabd {

class Session {
 public:
  // `threads` ≥ 1; results do not depend on it.
  explicit Session(Scene scene, int threads = 1);
  // Shares the scene with others. Precondition: not null.
  explicit Session(std::shared_ptr<const Scene> scene, int threads = 1);

  const Scene& scene() const { return *scene_; }
  const std::shared_ptr<const Scene>& shared_scene() const { return scene_; }
  const Model& model() const { return *model_; }
  const std::shared_ptr<const Model>& shared_model() const { return model_; }
  const Params& params() const { return *params_; }  // of the next step
  const std::shared_ptr<const Params>& shared_params() const { return params_; }
  const State& state() const { return state_; }
  const StepReport& report() const { return report_; }  // of the last step; energies only before the first
  double kappa() const;                                 // resolved contact stiffness; J
  // Of now, without a history. `state`: state() as somebody has it who shares it; null: a copy is made.
  FrameView view(std::shared_ptr<const State> state = nullptr) const;
  // The same, with the bodies where the engine has them.
  FrameView view_on_device(std::shared_ptr<const PoseCopy> poses) const;

  // What later steps put into their reports. None changes a result.
  void record_iterations(bool on) { options_.record_iterations = on; }
  void report_contacts(bool on) { options_.report_contacts = on; }
  void report_bodies(bool on) { options_.report_bodies = on; }
  void report_joints(bool on) { options_.report_joints = on; }
  // The engine may keep the bodies: state() is then valid only after complete_state().
  void let_bodies_stay(bool on) { options_.bodies_stay = on; }

  // Later steps ask `stop` now and then and end when it returns true (StepOptions::stop).
  void stop_when(std::function<bool()> stop) { options_.stop = std::move(stop); }

  // Hands on bodies in later steps. Precondition: as for step().
  void set_pulls(std::vector<Pull> pulls) { options_.pulls = std::move(pulls); }

  // Later steps are made by `engine`; null (the default): by this processor. step() throws what the engine throws.
  // Precondition: the engine has forgotten models that no longer exist (StepEngine::forget).
  void solve_with(std::shared_ptr<StepEngine> engine);
  bool has_engine() const { return engine_ != nullptr; }
  bool can_let_bodies_stay() const { return engine_ && engine_->keeps_bodies(*model_); }
  // As StepEngine::copy_poses.
  std::shared_ptr<const PoseCopy> copy_poses() { return engine_->copy_poses(); }
  // Does ahead of time what the engine does before its first step, such as compiling. Throws as the engine does.
  void prepare();
  // Fetches what the engine has left out of state().
  void complete_state();
  // A copy of the complete state.
  State whole_state() const;

  // One time step. A step that diverges (its report says so; numbers of its end are NaN) or is stopped leaves the state
  // as it was.
  const StepReport& step();

  // Back to the scene's initial state and parameters.
  void reset();

  // Takes effect at the next step. Throws Error(bad_input) naming the parameter; nothing has changed then.
  void set_params(const Params& params);
  void set_params(std::shared_ptr<const Params> params);  // not null; shared with whoever has them

  // Continues from another state of the same model. Throws Error(bad_input) when it does not fit the model.
  void set_state(State state);

  // Continues with bodies or joints added or removed, as the JSON form of the edit says it, and without pulls. Throws
  // Error(bad_input) as edit_from_json and apply_edit do; nothing has changed then.
  void edit(const ModelEdit& edit);

  // Continues from a state of `model`. Throws as set_state. `made`: the report of the step that led there.
  void restore(std::shared_ptr<const Model> model, State state);
  void restore(std::shared_ptr<const Model> model, State state, StepReport made);

 private:
  void describe_start();
  void take(std::shared_ptr<const Model> model);

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Model> model_;  // the scene's own until it is edited
  std::shared_ptr<const Params> params_;
  State state_;
  StepOptions options_;
  StepWorkspace workspace_;
  std::shared_ptr<StepEngine> engine_;  // null: this processor
  StepReport report_;
};

}  // namespace pabd
