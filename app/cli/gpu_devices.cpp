// SPDX-License-Identifier: MIT
// See gpu_devices.h.
#include "app/cli/gpu_devices.h"

#include <mutex>
#include <optional>
#include <string>

#include "app/cli/device_option.h"

namespace pabd::cli {
namespace {

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

std::shared_ptr<const StepDevices> gpu_devices(Backend backend, std::shared_ptr<SharedContext> drawing) {
  return std::make_shared<GpuDevices>(backend, std::move(drawing));
}

}  // namespace pabd::cli
