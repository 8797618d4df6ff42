// SPDX-License-Identifier: MIT
// See split_engine.h.
#include "render/device/split_engine.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/solver/time_step.h"

namespace pabd {
namespace {

// κ of "auto" is that of the whole scene.
Params of_whole(const Model& model, const Params& params) {
  Params out = params;
  out.contact.kappa = resolve_kappa(model, params);
  return out;
}

// Of joints the processor tells.
StepOptions of_device(StepOptions options) {
  options.report_joints = options.bodies_stay = false;
  return options;
}

Index movable(const Model& model) {
  return static_cast<Index>(std::count(model.fixed.begin(), model.fixed.end(), 0));
}

}  // namespace

std::string SplitEngine::why_not(const Model& model, const Params& params, const StepOptions& options,
                                 const State& state) {
  if (model.joints.empty()) return DeviceEngine::why_not(model, params, options);
  const ModelParts parts = split_model(model, jointed_bodies(model, params, state));
  if (movable(parts.free.model) == 0)
    return "all bodies of the scene hang on joints or are near those that do, which is the processor's: "
           "--device cpu";
  return DeviceEngine::why_not(parts.free.model, params, of_device(options));
}

Index SplitEngine::on_gpu(const Model& model, const Params& params, const State& state) {
  if (model.joints.empty()) return movable(model);
  const std::vector<std::uint8_t> jointed = jointed_bodies(model, params, state);
  return movable(model) - static_cast<Index>(std::count(jointed.begin(), jointed.end(), 1));
}

void SplitEngine::split(const Model& model, const Params& params, const State& state) {
  if (model_ == &model) return;
  forget();
  parts_ = std::make_unique<ModelParts>(split_model(model, jointed_bodies(model, params, state)));
  model_ = &model;
}

void SplitEngine::prepare(const Model& model, const Params& params, const StepOptions& options,
                          const State& state) {
  if (model.joints.empty()) return device_.prepare(model, params, options, state);
  split(model, params, state);
  take_part(parts_->free, state, free_);
  device_.prepare(parts_->free.model, of_whole(model, params), of_device(options), free_);
}

void SplitEngine::step(const Model& model, const Params& params, const StepOptions& options, State& state,
                       StepReport& report) {
  if (model.joints.empty()) return device_.step(model, params, options, state, report);
  split(model, params, state);
  if (state.time != left_ && coupling(model, *parts_, params, state)) {  // of another moment than the split
    forget();
    split(model, params, state);
    if (movable(parts_->free.model) == 0)
      throw Error(ErrorKind::bad_input, why_not(model, params, options, state));
  }
  if (const auto pair = coupling(model, *parts_, params, state)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("at t = {:.4g} s {} comes near {}, which is the GPU's, and joints are the processor's: "
                    "--device cpu, or --device auto",
                    state.time, model.name[static_cast<std::size_t>(pair->first)],
                    model.name[static_cast<std::size_t>(pair->second)]));
  }
  const Params whole = of_whole(model, params);
  take_part(parts_->free, state, free_);
  take_part(parts_->jointed, state, jointed_);
  // First the processor: what it did can be thrown away, what the GPU did takes its memory along.
  pabd::step(parts_->jointed.model, whole, options, jointed_, workspace_, report_);
  if (report_.status == StepStatus::non_finite || report_.status == StepStatus::interrupted) {
    report = report_;
    return;
  }
  device_.step(parts_->free.model, whole, of_device(options), free_, report);
  if (report.status == StepStatus::non_finite || report.status == StepStatus::interrupted) return;
  std::vector<ContactReport> of_free = std::move(report.contact_reports);
  report.contact_reports.clear();
  put_contacts(parts_->free, of_free, report.contact_reports);
  add_report(parts_->jointed, report_, report);
  report.joint_reports = report_.joint_reports;
  if (jointed_.change.empty()) state.change.clear();  // what has no joints remembers nothing
  put_part(parts_->jointed, jointed_, state);
  put_part(parts_->free, free_, state);
  left_ = state.time;
}

void SplitEngine::complete(State& state) {
  if (parts_ == nullptr) return device_.complete(state);
  if (state.size() != static_cast<Index>(parts_->free.place.size())) return;
  take_part(parts_->free, state, free_);
  device_.complete(free_);
  put_part(parts_->free, free_, state);
}

void SplitEngine::forget() {
  device_.forget();
  model_ = nullptr;
  parts_.reset();
}

}  // namespace pabd
