// SPDX-License-Identifier: MIT
// See device_option.h.
#include "app/cli/device_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "app/cli/help_text.h"
#include "app/cli/streams.h"
#include "app/session/yielding_engine.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

std::string few_bodies(Index moving) {
  return fmt::format("{} move{}, fewer than {}", counted(moving, "body", "bodies"), moving == 1 ? "s" : "",
                     kFewestOnGpu);
}

// Why the processor does it; empty: the GPU, whose name is told.
std::string why_not_unasked(const FindCapacity& find, const std::vector<DeviceTask>& tasks,
                            const StepOptions& wanted, std::string& name) {
  Index moving = 0;
  for (const DeviceTask& task : tasks)
    moving = std::max(moving, SplitEngine::on_gpu(*task.model, *task.params, *task.state));
  if (moving < kFewestOnGpu) return few_bodies(moving);
  for (const DeviceTask& task : tasks) {
    const std::string why = SplitEngine::why_not(*task.model, *task.params, wanted, *task.state);
    if (!why.empty()) return why.substr(0, why.find(": --device cpu"));
  }
  try {
    const DeviceCapacity capacity = find();
    name = capacity.renderer;
    return why_processor(moving, capacity);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    return "there is no OpenGL";
  }
}

// Of the context that the GPU will have. `asked`: where it was asked for.
DeviceCapacity asked_for(const FindCapacity& find, const char* asked) {
  const auto refuse = [&](const std::string& why) { return Error(ErrorKind::no_context, asked, why); };
  DeviceCapacity capacity;
  try {
    capacity = find();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    throw refuse(std::string("--device cpu, or: ") + error.what());
  }
  if (!capacity.why_not.empty()) throw refuse(capacity.why_not);
  return capacity;
}

// Where parameters are tuned, the remedy is one of them.
std::string as_parameter(std::string text) {
  const std::string option = "--device cpu";
  for (auto at = text.find(option); at != std::string::npos; at = text.find(option))
    text.replace(at, option.size(), "solver.device=cpu");
  return text;
}

class GpuDevices : public StepDevices {
 public:
  GpuDevices(Backend backend, std::shared_ptr<SharedContext> drawing)
      : backend_(backend), drawing_(std::move(drawing)) {}

  Answer decide(const Model& model, const Params& params, const State& state) const override {
    Answer answer;
    try {
      const DeviceChoice choice =
          choose_device("", [this] { return capacity(); }, "", {{&model, &params, &state}}, {});
      answer.device = choice.gpu;
      if (choice.gpu) answer.name = choice.name;
      answer.why = choice.why;
    } catch (const Error& error) {
      answer.why = as_parameter(error.what());
      answer.refused = true;
      answer.kind = error.kind();
    }
    return answer;
  }

  std::shared_ptr<StepEngine> open() const override {
    return std::make_shared<SplitEngine>(backend_, drawing_.get());
  }

 private:
  DeviceCapacity capacity() const {
    const std::scoped_lock lock(mutex_);
    if (!capacity_) capacity_ = DeviceEngine::capacity(backend_);
    return *capacity_;
  }

  Backend backend_;
  std::shared_ptr<SharedContext> drawing_;
  mutable std::mutex mutex_;
  mutable std::optional<DeviceCapacity> capacity_;
};

}  // namespace

CLI::Option* add_device_option(const Command& command, std::string& device) {
  return command.word(
      group::kSimulation, "--device", device, {"cpu", "gpu", "auto"},
      fmt::format(
          "who makes the steps (default: what the scene says, which is cpu unless it has "
          "\"solver.device\"): cpu; gpu: compute shaders of OpenGL 4.3, in float, for contacts (what "
          "hangs on joints stays with the processor); auto: a GPU that is no software where it takes "
          "the scene and {} bodies or more move, else the processor. 'pabd doctor' tells what there is",
          kFewestOnGpu),
      "NAME");
}

std::string DeviceChoice::words() const {
  if (gpu) return " · steps by " + name;
  return why.empty() ? "" : " · steps by the processor: " + why;
}

std::shared_ptr<StepEngine> DeviceChoice::engine(Backend backend) const {
  if (!gpu) return nullptr;
  auto engine = std::make_shared<SplitEngine>(backend);
  if (!left_to) return engine;
  return std::make_shared<YieldingEngine>(std::move(engine), [](const std::string& reason) {
    write_note("pabd: note: the processor makes the steps from here on: " + reason);
  });
}

std::string why_processor(Index moving, const DeviceCapacity& capacity) {
  if (moving < kFewestOnGpu) return few_bodies(moving);
  if (!capacity.why_not.empty()) return fmt::format("{} cannot take it", capacity.renderer);
  if (!capacity.hardware) return fmt::format("{} is no GPU", capacity.renderer);
  if (moving > capacity.bodies)
    return fmt::format("{} has room for about {} bodies", capacity.renderer, capacity.bodies);
  return {};
}

DeviceChoice choose_device(const std::string& option, const FindCapacity& find, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted) {
  const std::string device = option.empty() ? to_string(tasks.front().params->solver.device) : option;
  DeviceChoice choice;
  if (device == "auto") {
    std::string name;
    choice.why = why_not_unasked(find, tasks, wanted, name);
    choice.gpu = choice.left_to = choice.why.empty();
    if (choice.gpu) choice.name = name;
  } else if (device == "gpu") {
    for (const DeviceTask& task : tasks) {
      const std::string why = SplitEngine::why_not(*task.model, *task.params, wanted, *task.state);
      if (!why.empty() && source.empty()) throw Error(ErrorKind::bad_input, why);
      if (!why.empty()) throw Error(ErrorKind::bad_input, source, why);
    }
    const DeviceCapacity capacity = asked_for(find, option.empty() ? "solver.device gpu" : "--device gpu");
    choice.gpu = true;
    choice.name = capacity.renderer;
  }
  return choice;
}

DeviceChoice choose_device(const std::string& option, Backend backend, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted) {
  return choose_device(
      option, [&] { return DeviceEngine::capacity(backend); }, source, tasks, wanted);
}

DeviceChoice prepare_on_device(const std::string& option, const std::string& source, Session& session,
                               const StepOptions& wanted) {
  DeviceChoice choice = choose_device(option, Backend::automatic, source,
                                      {{&session.model(), &session.params(), &session.state()}}, wanted);
  const auto start = std::chrono::steady_clock::now();
  session.solve_with(choice.engine(Backend::automatic));
  session.prepare();
  choice.preparing = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return choice;
}

std::string DeviceChoices::words() const {
  if (of.size() == 1) return of.front().words();
  std::string out;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const std::string run = of.size() == 2 ? k == 0 ? "A" : "B" : fmt::format("run {}", k + 1);
    out += fmt::format("{} of {} by {}", out.empty() ? " · steps" : ",", run,
                       of[k].gpu ? of[k].name : "the processor");
  }
  return out;
}

DeviceChoices choose_devices(const std::string& option, Backend backend, const std::string& source,
                             const std::vector<Run>& runs, const StepOptions& wanted) {
  std::vector<DeviceTask> tasks;
  bool same = true;
  for (const Run& run : runs) {
    tasks.push_back({&run.model(), &run.params(), &run.state()});
    same = same && run.params().solver.device == runs.front().params().solver.device;
  }
  if (!option.empty() || same) return {{choose_device(option, backend, source, tasks, wanted)}};
  DeviceChoices out;
  for (const DeviceTask& task : tasks)
    out.of.push_back(choose_device(option, backend, source, {task}, wanted));
  return out;
}

void solve_by(const DeviceChoices& choices, Backend backend, std::vector<Run>& runs) {
  for (std::size_t k = 0; k < runs.size(); ++k) runs[k].solve_with(choices.run(k).engine(backend));
}

std::shared_ptr<const StepDevices> gpu_devices(Backend backend, std::shared_ptr<SharedContext> drawing) {
  return std::make_shared<GpuDevices>(backend, std::move(drawing));
}

}  // namespace pabd::cli
