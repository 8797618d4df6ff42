// SPDX-License-Identifier: MIT
// See device_option.h.
#include "app/cli/device_option.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/help_text.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

Index moving_bodies(const Model& model) {
  return static_cast<Index>(std::count(model.fixed.begin(), model.fixed.end(), 0));
}

std::string few_bodies(Index moving) {
  return fmt::format("{} move{}, fewer than {}", counted(moving, "body", "bodies"), moving == 1 ? "s" : "",
                     kFewestOnGpu);
}

// Why the processor does it; empty: the GPU, whose name is told.
std::string why_not_unasked(Backend backend, const std::vector<DeviceTask>& tasks, const StepOptions& wanted,
                            std::string& name) {
  Index moving = 0;
  for (const DeviceTask& task : tasks) moving = std::max(moving, moving_bodies(*task.model));
  if (moving < kFewestOnGpu) return few_bodies(moving);
  for (const DeviceTask& task : tasks) {
    const std::string why = DeviceEngine::why_not(*task.model, *task.params, wanted);
    if (!why.empty()) return why.substr(0, why.find(": --device cpu"));
  }
  try {
    const DeviceCapacity capacity = DeviceEngine::capacity(backend);
    name = capacity.renderer;
    return why_processor(moving, capacity);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    return "there is no OpenGL";
  }
}

// Of the context that --device gpu will have.
DeviceCapacity asked_for(Backend backend) {
  const auto refuse = [](const std::string& why) {
    return Error(ErrorKind::no_context, "--device gpu", why);
  };
  DeviceCapacity capacity;
  try {
    capacity = DeviceEngine::capacity(backend);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    throw refuse(std::string("--device cpu, or: ") + error.what());
  }
  if (!capacity.why_not.empty()) throw refuse(capacity.why_not);
  return capacity;
}

}  // namespace

void add_device_option(CLI::App& command, std::string& device) {
  command
      .add_option(
          "--device", device,
          fmt::format("who makes the steps: cpu (default); gpu: compute shaders of OpenGL 4.3, in float, "
                      "for scenes without joints; auto: a GPU that is no software where it takes the "
                      "scene and {} bodies or more move, else the processor. 'pabd doctor' tells what "
                      "there is",
                      kFewestOnGpu))
      ->type_name("NAME")
      ->group(group::kSimulation)
      ->check(CLI::IsMember({"cpu", "gpu", "auto"}));
}

std::string DeviceChoice::words() const {
  if (gpu) return " · steps by " + name;
  return why.empty() ? "" : " · steps by the processor: " + why;
}

std::shared_ptr<StepEngine> DeviceChoice::engine(Backend backend) const {
  return gpu ? std::make_shared<DeviceEngine>(backend) : nullptr;
}

std::string why_processor(Index moving, const DeviceCapacity& capacity) {
  if (moving < kFewestOnGpu) return few_bodies(moving);
  if (!capacity.why_not.empty()) return fmt::format("{} cannot take it", capacity.renderer);
  if (!capacity.hardware) return fmt::format("{} is no GPU", capacity.renderer);
  if (moving > capacity.bodies)
    return fmt::format("{} has room for about {} bodies", capacity.renderer, capacity.bodies);
  return {};
}

DeviceChoice choose_device(const std::string& device, Backend backend, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted) {
  DeviceChoice choice;
  if (device == "auto") {
    std::string name;
    choice.why = why_not_unasked(backend, tasks, wanted, name);
    choice.gpu = choice.why.empty();
    if (choice.gpu) choice.name = name;
  } else if (device == "gpu") {
    for (const DeviceTask& task : tasks) {
      const std::string why = DeviceEngine::why_not(*task.model, *task.params, wanted);
      if (!why.empty()) throw Error(ErrorKind::bad_input, source, why);
    }
    const DeviceCapacity capacity = asked_for(backend);
    choice.gpu = true;
    choice.name = capacity.renderer;
  }
  return choice;
}

DeviceChoice solve_on_device(const std::string& device, Backend backend, const std::string& source, Run& a,
                             Run* b, const StepOptions& wanted) {
  std::vector<DeviceTask> tasks = {{&a.model(), &a.params()}};
  if (b != nullptr) tasks.push_back({&b->model(), &b->params()});
  DeviceChoice choice = choose_device(device, backend, source, tasks, wanted);
  a.solve_with(choice.engine(backend));
  if (b != nullptr) b->solve_with(choice.engine(backend));
  return choice;
}

}  // namespace pabd::cli
