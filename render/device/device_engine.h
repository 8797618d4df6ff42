// SPDX-License-Identifier: MIT
// The solver on the GPU as the maker of the steps of a run, in an OpenGL context of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/context/context.h"
#include "render/device/device_capacity.h"
#include "render/device/device_solver.h"
#include "render/device/shared_context.h"
#include "sim/solver/step_engine.h"

namespace pabd {

class DeviceEngine : public StepEngine {
 public:
  // What a GPU would take here: a context is made and dropped again; none is current afterwards. Throws
  // Error(no_context) where there is no OpenGL at all.
  static DeviceCapacity capacity(Backend backend);

  // Why it does not take the scene, or cannot tell what is asked of its reports: one line with the remedy; empty: it
  // does. Linear in the number of bodies.
  static std::string why_not(const Model& model, const Params& params, const StepOptions& options);

  // In the context that `drawing` lends, so that bodies can stay, where that is of the same GPU; else in one of its own. Throws
  // Error(no_context), with the remedy, where there is no context that can take it.
  explicit DeviceEngine(Backend backend, SharedContext* drawing = nullptr);
  // From any thread; what is current in it stays.
  ~DeviceEngine() override;
  DeviceEngine(const DeviceEngine&) = delete;
  DeviceEngine& operator=(const DeviceEngine&) = delete;

  std::string name() const override { return name_; }

  // prepare(), step() and complete() leave no context current in their thread. The solver is compiled for the model
  // that comes first, and anew where contacts are to be told of that were not before. step() leaves the memory of
  // contacts on the GPU. A state that is not the one that it left is taken over whole; it is known by its step, its
  // time, and where bodies are and how they move; where they stayed (StepOptions::bodies_stay), by step and time.
  // Phases are times of the GPU.
  void prepare(const Model& model, const Params& params, const StepOptions& options,
               const State& state) override;
  void step(const Model& model, const Params& params, const StepOptions& options, State& state,
            StepReport& report) override;
  void complete(State& state) override;
  bool keeps_bodies(const Model&) const override { return copies_ != nullptr; }
  std::shared_ptr<const PoseCopy> copy_poses() override;
  void forget() override { model_ = nullptr; }

 private:
  static constexpr std::int64_t kNone = -1;  // no state is at this step

  // What tells one state from another.
  struct Left {
    std::int64_t step = kNone;
    double time = 0;
    std::vector<Vec3> c, v, omega;
    std::vector<Mat3> R;

    void set(const State& state);
    bool is(const State& state) const;
  };

  void work_beside(SharedContext::Lent lent);
  void check(const Model& model, const Params& params, const StepOptions& options);
  bool knows(const State& state) const { return left_.is(state) || whole_.is(state); }
  void make_ready(const Model& model, const StepOptions& options, const State& state);

  std::shared_ptr<GlContext> context_;  // current only while this works
  std::shared_ptr<PoseCopies> copies_;  // null: nobody draws from its buffers
  std::unique_ptr<ComputeFunctions> gl_;
  std::string name_;
  std::unique_ptr<DeviceSolver> solver_;
  const Model* model_ = nullptr;  // that the solver is compiled for
  bool contacts_ = false;         // it tells of them
  const Model* checked_ = nullptr;
  Params checked_params_;
  Left left_;                  // by step()
  Left whole_;                 // by complete(), where step() had left bodies out
  bool stayed_ = false;        // it had
  std::int64_t away_ = kNone;  // step of the state that has them nowhere else
};

}  // namespace pabd
