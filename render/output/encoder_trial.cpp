// SPDX-License-Identifier: MIT
// See encoder_trial.h.
#include "render/output/encoder_trial.h"

#include <fmt/format.h>

#include "sim/base/child_process.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kPatience = 30;  // s

// What follows is about what follows from it: "[h264_nvenc @ 0x5632…] Cannot load libcuda.so.1".
std::string first_reason(const std::string& errors) {
  std::string line = errors.substr(0, errors.find('\n'));
  if (line.ends_with('.')) line.pop_back();
  const auto end = line.starts_with('[') ? line.find("] ") : std::string::npos;
  return one_line(end == std::string::npos ? line : line.substr(end + 2));
}

}  // namespace

std::string encoder_complaint(const std::vector<std::string>& device, const std::vector<std::string>& codec) {
  std::vector<std::string> command = {"ffmpeg", "-nostdin", "-hide_banner", "-nostats", "-loglevel", "error"};
  const auto add = [&](const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
  };
  add(device);
  add({"-f", "lavfi", "-i", "color=size=256x256:rate=10:duration=0.1"});
  add(codec);
  add({"-f", "null", "-"});
  const ChildOutcome outcome = run_child(
      command, kPatience, [](std::string_view) {}, kPatience);
  if (!outcome.found) return "ffmpeg was not found in PATH";
  if (outcome.status == 0) return "";
  if (outcome.too_slow) return fmt::format("it did not answer within {:g} s", kPatience);
  return outcome.errors.empty() ? "it gave no reason" : first_reason(outcome.errors);
}

}  // namespace pabd
