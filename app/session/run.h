// SPDX-License-Identifier: MIT
// A simulation that can be wound back: a session, its timeline, and a place in it. What is changed in the
// past starts a new branch; the future that it leaves is kept for comparison. Edits and pulls are part of the
// past: it is replayed and computed again with them.
#pragma once

#include <optional>

#include "app/session/session.h"
#include "app/session/step_devices.h"
#include "app/session/timeline.h"

namespace pabd {

// Where a branch leaves the run that it came from.
struct Parting {
  double time = 0;                // of the moment where it begins; s
  std::optional<double> differs;  // first moment with another bit; s
  std::optional<double> parted;   // first moment with a body more than d̂ away; s
};

class Run {
 public:
  // Precondition: scene is not null, threads ≥ 1. `memory`: bytes for states of the past, or kNoPast.
  // `start`: another state of the scene's model to begin with; throws Error(bad_input) when it does not fit.
  Run(std::shared_ptr<const Scene> scene, int threads, std::size_t memory,
      const std::optional<State>& start = {});

  // Goes on where a recording ends. Precondition: `past` is of this scene and has a moment.
  Run(std::shared_ptr<const Scene> scene, int threads, Timeline past);

  const Scene& scene() const { return *scene_; }
  const std::shared_ptr<const Scene>& shared_scene() const { return scene_; }
  const Model& model() const { return session_.model(); }
  const std::shared_ptr<const Model>& shared_model() const { return session_.shared_model(); }
  const State& state() const { return session_.state(); }
  const StepReport& report() const { return session_.report(); }  // of the step that led here
  const Params& params() const { return session_.params(); }      // of the next step
  double kappa() const { return session_.kappa(); }               // J

  // Of now, with the parameters of the next step, without a history.
  FrameView view() const { return poses_ && may_stay_ ? session_.view_on_device(poses_) : session_.view(); }

  const Timeline& timeline() const { return timeline_; }
  std::size_t cursor() const { return cursor_; }
  bool at_end() const { return cursor_ + 1 == timeline_.size(); }

  // The future that the last branch left, and where the two part; null without one.
  const Timeline* left() const { return left_ ? &*left_ : nullptr; }
  const std::optional<Parting>& parting() const { return parting_; }

  // A run of its own at the same place of the same past, with what the last branch left. States are shared.
  Run fork() const;

  // What reports carry from the next step or seek on.
  void observe(bool iterations, bool contacts, bool bodies = false);

  // New steps are made by `engine`; null: by this processor. What replays the past computes on the processor, so
  // that a run with an engine keeps none: throws Error(bad_input) where this one does, and fork(), seek() and
  // restart() do so afterwards.
  void solve_with(std::shared_ptr<StepEngine> engine);

  // New steps are made by what the parameters ask for (solver.device) and `devices` offer; null: by this processor, as
  // unless this is called. A device that fails leaves the rest to the processor. The past is kept as its budget allows
  // (timeline.h); iterations and bodies are not observed, hands are the processor's. Forks are offered the same.
  void offer(std::shared_ptr<const StepDevices> devices);
  // Who would make steps with those parameters.
  StepDevices::Answer answer(const Params& params) const;
  // Who makes the next step, as far as it is known before.
  const DeviceStatus& device() const { return devices_.status(); }
  // The device and what it holds, to a run that takes the place of this one; null: nobody needs it.
  void give_device_to(Run* other);
  // After this, state() and the timeline have all of the present: a device may leave something out. Where it is lost with
  // bodies that stayed, the run is back at the last moment whose state was kept.
  void complete();
  // Bodies may stay on a device that pictures are drawn from, in steps to come; where they did, state() has those of a step
  // before until complete(), and view() none.
  void let_bodies_stay(bool on) { may_stay_ = on; }
  bool bodies_stayed() const { return stayed_; }

  // A step that is under way ends when it says true, as do the steps of forks (StepOptions::stop).
  void stop_when(const std::function<bool()>& stop);

  // One step on: in the past the one that was made, at the end a new one. False, with the state as it was,
  // when the new one left the numbers or was stopped; report() tells of it. Where bodies had stayed on a device that left the
  // numbers, the state is the last one that was kept.
  bool advance();
  // To moment i of the timeline, or the last before that is kept (Timeline::kept). Precondition: it exists.
  void seek(std::size_t i);
  // Back to the beginning, with the present parameters; what was is left.
  void restart();

  // For the next step. Throws Error(bad_input) as Session does. In the past this starts a branch.
  void set_params(const Params& params);

  // Hands on bodies in the steps to come, until they are set anew or another moment is gone to. In the past
  // this starts a branch. Throws Error(bad_input) for a body that is none or fixed and numbers that are none.
  void set_pulls(std::vector<Pull> pulls);
  const Pulls& pulls() const { return pulls_; }  // of the next step

  // Bodies or joints added or removed, here and now: a moment of its own that no step led to. In the past
  // this starts a branch; pulls end. Throws Error(bad_input) as apply_edit does: nothing has changed then.
  // The result identifies the edit in the timeline.
  std::shared_ptr<const MadeEdit> edit(const ModelEdit& edit);
  // Back to the moment before an edit, from where everything goes on anew. False, and nothing happens, when
  // the timeline does not hold it (any more).
  bool undo_edit(const MadeEdit& edit);

  // Goes on with `scene`: this run's scene read again with other laws of its joints. A moment of its own that no step
  // led to, here and now, again wherever a branch leaves what is before it; in the past this starts a branch. Throws
  // Error(bad_input), and nothing has changed, when bodies or joints were added or removed before.
  void continue_as(std::shared_ptr<const Scene> scene);

  // All edits of the timeline, as JSON, one a line.
  std::string edits() const;

  // The step that led here again, with another method, its iterations recorded; of a start none. Throws Error(bad_input) where
  // the state before it was not kept.
  StepReport step_with(SolverMethod method) const;

 private:
  void needs_processor() const;
  StepStatus make_step();
  void ask_device();
  void work_with(const std::shared_ptr<StepEngine>& engine);
  void leave_device();
  bool bring_back();
  bool keeps_state() const;
  void go_back_to_kept(StepReport report);
  void go_to(std::size_t i);
  bool tells_again(std::size_t i) const;
  void branch();
  bool continued_after_now() const;
  void take_model_of_scene();
  void add_moment(std::shared_ptr<const MadeEdit> edit = nullptr, bool start = false);
  void compare();

  std::shared_ptr<const Scene> scene_;
  Session session_;
  DeviceSwitch devices_;
  int threads_;
  bool iterations_ = false, contacts_ = false, bodies_ = false;
  bool may_stay_ = false;
  bool stayed_ = false;                    // state() has no bodies of now
  std::shared_ptr<const PoseCopy> poses_;  // of now, where a device keeps bodies; else null
  Timeline timeline_;
  std::size_t cursor_ = 0;
  std::shared_ptr<const Params> newest_;  // of the next step at the end, while the cursor is elsewhere
  Pulls pulls_;                           // of the next step
  std::function<bool()> stop_;
  std::optional<Timeline> left_;
  std::optional<Parting> parting_;
};

}  // namespace pabd
