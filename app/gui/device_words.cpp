// SPDX-License-Identifier: MIT
// See device_words.h.
#include "app/gui/device_words.h"

namespace pabd {
namespace {

// Drivers tell more than a name: "llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA H200/PCIe/SSE2".
std::string short_name(const std::string& renderer) {
  return renderer.substr(0, renderer.find_first_of("(/"));
}

std::string words(const RunView& run) {
  if (run.params.solver.device == SolverDevice::cpu) return "";
  std::string name = short_name(run.device.name);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  return name.empty() ? "CPU" : "GPU · " + name;
}

std::string story(const RunView& run) {
  if (run.params.solver.device == SolverDevice::cpu) return "";
  if (run.device.name.empty()) return "The processor makes the steps: " + run.device.why;
  return run.device.name + " makes the steps (solver.device)";
}

}  // namespace

std::string device_words(const Snapshot& snapshot) {
  const std::string a = words(snapshot.a), b = snapshot.b ? words(*snapshot.b) : a;
  if (a == b) return a;
  return "A " + (a.empty() ? "CPU" : a) + ", B " + (b.empty() ? "CPU" : b);
}

std::string device_story(const Snapshot& snapshot) {
  const std::string a = story(snapshot.a), b = snapshot.b ? story(*snapshot.b) : a;
  if (a == b) return a;
  return (a.empty() ? "" : "A: " + a) + (a.empty() || b.empty() ? "" : "\n") + (b.empty() ? "" : "B: " + b);
}

}  // namespace pabd
