// SPDX-License-Identifier: MIT
// A device that is not the processor: free flight without gravity, with a memory of its own that it leaves out of states
// until it is asked, and no joints.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/session/step_devices.h"
#include "tests/support/tiny_model.h"

namespace pabd::test {

// Two balls, one of which flies sideways.
inline std::shared_ptr<const Scene> thrown_balls(SolverDevice device) {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, Vec3(0, 10, 0));
  tiny.add(Sphere{0.5}, Vec3(0, 20, 0));
  tiny.state.v[0] = Vec3(3, 0, 0);
  auto scene = std::make_shared<Scene>();
  scene->model = tiny.model;
  scene->initial = tiny.state;
  scene->params.solver.device = device;
  scene->hash = "0123456789abcdef";
  return scene;
}

// A step of free flight without gravity.
inline void drift(const Params& params, State& state, StepReport& report) {
  for (std::size_t i = 0; i < state.c.size(); ++i) state.c[i] += params.h * state.v[i];
  ++state.step;
  state.time += params.h;
  state.contacts.clear();
  report = {};
  report.step = state.step;
  report.time = state.time;
  report.status = StepStatus::converged;
}

// Bodies as a step of the drift left them.
struct DriftPoses : PoseCopy {
  explicit DriftPoses(State s) : state(std::move(s)) {}
  State state;
};

class DriftEngine : public StepEngine {
 public:
  std::string name() const override { return "drift"; }
  void prepare(const Model&, const Params&, const StepOptions&, const State&) override {}
  void step(const Model& model, const Params& params, const StepOptions& options, State& state,
            StepReport& report) override {
    if (!options.pulls.empty() || options.record_iterations || options.report_bodies || !model.joints.empty())
      throw Error(ErrorKind::bad_input, "drift: not taken");
    if (steps == lost_after) throw Error(ErrorKind::no_context, "drift: lost");
    ++steps;
    State now = away && state.step == away->step ? *away : state;
    drift(params, now, report);
    if (steps == diverges_at) {
      report.status = StepStatus::non_finite;
      away.reset();
      return;
    }
    away.reset();
    if (options.bodies_stay) {
      away = now;
      state.step = now.step;
      state.time = now.time;
    } else {
      state = now;
    }
    if (options.report_contacts) report.contact_reports.resize(1);
    memory_of = state.step;
  }
  void complete(State& state) override {
    if (steps == lost_after) throw Error(ErrorKind::no_context, "drift: lost");
    if (away && state.step == away->step) state = *away;
    if (state.step == memory_of)
      state.contacts.assign(1, ContactMemory{1, 0, Vec3(static_cast<double>(state.step), 0, 0)});
  }
  void forget() override { ++forgotten; }

  bool keeps_bodies(const Model&) const override { return draws; }
  std::shared_ptr<const PoseCopy> copy_poses() override { return std::make_shared<DriftPoses>(*away); }

  bool draws = false;
  std::optional<State> away;  // the state that has its bodies here alone
  int steps = 0, forgotten = 0, lost_after = -1, diverges_at = -1;
  std::int64_t memory_of = -1;
};

class DriftDevices : public StepDevices {
 public:
  Answer decide(const Model& model, const Params& params, const State&) const override {
    Answer answer;
    const bool asked = params.solver.device == SolverDevice::gpu;
    if (!model.joints.empty()) {
      answer.why = "drift knows no joints";
      answer.refused = asked;
    } else if (!asked && model.size() < 3) {
      answer.why = "too few";
    } else {
      answer.device = true;
      answer.name = "drift";
    }
    return answer;
  }
  std::shared_ptr<StepEngine> open() const override {
    if (refuses) throw Error(ErrorKind::no_context, "drift: not there");
    ++opened;
    newest = std::make_shared<DriftEngine>();
    newest->draws = draws;
    return newest;
  }

  mutable int opened = 0;
  mutable std::shared_ptr<DriftEngine> newest;
  bool refuses = false;
  bool draws = false;  // pictures are drawn from where its bodies are
};

}  // namespace pabd::test
