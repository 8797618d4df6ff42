// SPDX-License-Identifier: MIT
// A simulation that can be wound back: a session and a head in the tree of moments. A change in the past starts a branch;
// the future that it leaves is kept for comparison. Edits and pulls are part of the past and are replayed with it.
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

// A place in the tree of moments, and how a run goes on from there. Heads share moments: one costs a pointer for each.
// Undo, A/B and copies keep heads, and move runs to them.
struct Head {
  std::shared_ptr<const Scene> scene;
  Timeline timeline;                          // the branch that it is on
  std::size_t cursor = 0;                     // the moment where it is
  std::shared_ptr<const Params> params = {};  // of the next step
  std::shared_ptr<const Params> newest = {};  // of the next step at the end, while the cursor is elsewhere
  Pulls pulls = {};                           // of the next step
  std::optional<Timeline> left = {};          // the future that the last branch left
  std::optional<Parting> parting = {};
};

class Run {
 public:
  // Precondition: scene is not null, threads ≥ 1. `memory`: bytes for states of the past, or kNoPast. `start`: another
  // state of the scene's model to begin with; throws Error(bad_input) when it does not fit.
  Run(std::shared_ptr<const Scene> scene, int threads, std::size_t memory,
      const std::optional<State>& start = {});

  // Goes on where a recording ends. Precondition: `past` is of this scene and has a moment.
  Run(std::shared_ptr<const Scene> scene, int threads, Timeline past);

  const Scene& scene() const { return *head_.scene; }
  const std::shared_ptr<const Scene>& shared_scene() const { return head_.scene; }
  const Model& model() const { return session_.model(); }
  const std::shared_ptr<const Model>& shared_model() const { return session_.shared_model(); }
  const State& state() const { return session_.state(); }
  const StepReport& report() const { return session_.report(); }  // of the step that led here
  const Params& params() const { return session_.params(); }      // of the next step
  double kappa() const { return session_.kappa(); }               // J

  // Of now, with the parameters of the next step, without a history.
  FrameView view() const {
    return poses_ && may_stay_ ? session_.view_on_device(poses_)
                               : session_.view(head_.timeline[head_.cursor].state);
  }

  const Timeline& timeline() const { return head_.timeline; }
  std::size_t cursor() const { return head_.cursor; }
  bool at_end() const { return head_.cursor + 1 == head_.timeline.size(); }

  // The future that the last branch left, and where the two part; null without one.
  const Timeline* left() const { return head_.left ? &*head_.left : nullptr; }
  const std::optional<Parting>& parting() const { return head_.parting; }

  // Where it is; with the state of now, which a device may still have. Throws Error(bad_input) as solve_with, and
  // Error(no_context).
  Head head() const;
  // Goes on from there. Precondition: the head is of a run with as much memory.
  void go_to(Head head);
  // A run of its own with the same head.
  Run fork() const;

  // What reports carry from the next step or seek on.
  void observe(bool iterations, bool contacts, bool bodies = false);

  // New steps are made by `engine`; null: by this processor. Only for runs with kNoPast, because replaying computes on the
  // processor: throws Error(bad_input) for others, as head(), fork(), seek() and restart() do afterwards.
  void solve_with(std::shared_ptr<StepEngine> engine);

  // New steps are made by the device that the parameters ask for (solver.device), if `devices` offers it; null (the
  // default): by this processor. When a device fails, the processor goes on. A device does not report iterations and
  // bodies; steps with hands are the processor's. Forks are offered the same devices.
  void offer(std::shared_ptr<const StepDevices> devices);
  // Who would make steps with those parameters.
  StepDevices::Answer answer(const Params& params) const;
  // Who makes the next step, as far as it is known before.
  const DeviceStatus& device() const { return devices_.status(); }
  // Fetches what a device has left out of state() and the timeline. If the device is lost together with bodies that
  // stayed there, the run is back at the last moment whose state was kept.
  void complete();
  // In later steps bodies may stay on a device that pictures are drawn from. While they do, state() is that of an earlier
  // step until complete(), and view() has no bodies.
  void let_bodies_stay(bool on) { may_stay_ = on; }
  bool bodies_stayed() const { return stayed_; }

  // A step that is under way ends when it says true, as do the steps of forks (StepOptions::stop).
  void stop_when(const std::function<bool()>& stop);

  // One step on: in the past the one that was made, at the end a new one. False when the new one diverged or was
  // stopped (see report()); the state is then as before, or, if bodies had stayed on a device, the last one that was kept.
  bool advance();
  // To moment i of the timeline, or the last before that is kept (Timeline::kept). Precondition: it exists.
  void seek(std::size_t i);
  // Back to the beginning, with the present parameters; what was is left.
  void restart();

  // For the next step; in the past this starts a branch. Throws Error(bad_input) as Session does.
  void set_params(const Params& params);

  // Hands on bodies in later steps, until they are set anew or the run goes elsewhere; in the past this starts a branch.
  // Throws Error(bad_input) for a body that does not exist or is fixed, and for numbers out of range.
  void set_pulls(std::vector<Pull> pulls);
  const Pulls& pulls() const { return head_.pulls; }  // of the next step

  // Adds or removes a body or joint, as a moment of its own; in the past this starts a branch. Pulls end. Throws
  // Error(bad_input) as Session::edit; nothing has changed then. The result identifies the edit in the timeline.
  std::shared_ptr<const MadeEdit> edit(const ModelEdit& edit);
  // Back to the moment before an edit, and drops what followed. False, and nothing happens, when the timeline does not
  // hold the edit any more.
  bool undo_edit(const MadeEdit& edit);

  // Goes on with `scene`, this run's scene read again with other laws of its joints, as a moment of its own; in the past
  // this starts a branch. A branch from a moment before it repeats it. Throws Error(bad_input), and nothing has changed,
  // when bodies or joints were added or removed before.
  void continue_as(std::shared_ptr<const Scene> scene);

  // Repeats the step that led here with another method and records its iterations; an empty report at a start. Throws
  // Error(bad_input) when the state before it was not kept.
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
  void open_session();
  void stand_at(std::size_t i);
  void replay_to(std::size_t i);
  bool tells_again(std::size_t i) const;
  void branch();
  bool continued_after_now() const;
  void take_model_of_scene();
  void add_moment(std::shared_ptr<const MadeEdit> edit = nullptr, bool start = false);
  void compare();

  Head head_;  // params: where it is head() alone
  Session session_;
  DeviceSwitch devices_;
  int threads_;
  bool iterations_ = false, contacts_ = false, bodies_ = false;
  bool may_stay_ = false;
  bool stayed_ = false;                    // state() has no bodies of now
  std::shared_ptr<const PoseCopy> poses_;  // of now, where a device keeps bodies; else null
  std::function<bool()> stop_;
};

// ---- two runs in step: B beside A, by the rule of step_at_time.h ----

// The moment of B's past that belongs to moment i of A's.
std::size_t moment_in_step(const Timeline& a, std::size_t i, const Timeline& b);

// B to where A went on to, as far as B has been there already.
void rejoin(const Run& a, Run& b);
// And from there with new steps; `made` is called after each. False when one could not be made
// (Run::advance).
bool follow(const Run& a, Run& b, const std::function<void()>& made = {});

// Whether the steps that led A and B to where they are end at the same time, with the same number of bodies:
// then the two states can be compared.
bool at_common_time(const Run& a, const Run& b);

}  // namespace pabd
