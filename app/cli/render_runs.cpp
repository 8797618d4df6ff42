// SPDX-License-Identifier: MIT
// See render_runs.h.
#include "app/cli/render_runs.h"

#include <fmt/format.h>

#include "app/cli/simulation_setup.h"
#include "app/frames/frame_source.h"
#include "app/session/joint_settings.h"
#include "sim/base/input_file.h"
#include "sim/scene/tuning.h"

namespace pabd::cli {
namespace {

constexpr std::size_t kMostPatchBytes = std::size_t{1} << 20;

Run open_with(const AskedRuns& asked, const std::vector<std::string>& settings, InputFiles& inputs) {
  CommonOptions common = asked.common;
  common.quiet = true;  // what there is to say of the scene was said of `a`
  common.sets.insert(common.sets.end(), settings.begin(), settings.end());
  return open_run(asked.scene, common, asked.from, inputs);
}

// B: the same scene and start with other parameters. Laws of joints belong to the bodies and joints of a scene: with
// others it is read again.
Run open_patched(const AskedRuns& asked, const Run& a, InputFiles& inputs) {
  std::string patch = read_file(asked.ab, kMostPatchBytes, "a JSON merge patch");
  const std::vector<std::string> joints = take_joint_settings(patch, asked.ab);
  Run b = joints.empty() ? a.fork() : open_with(asked, joints, inputs);
  b.set_params(patched(a.params(), patch, asked.ab));
  return b;
}

}  // namespace

std::string AskedRuns::name(std::size_t run) const {
  if (grid.empty()) return run == 0 ? "" : ab;
  return fmt::format("{}", fmt::join(grid.settings(run), " "));
}

std::vector<Run> open_runs(const AskedRuns& asked, Run a, InputFiles& inputs) {
  if (asked.grid.empty()) {
    std::optional<Run> b;
    if (!asked.ab.empty()) b.emplace(open_patched(asked, a, inputs));
    return runs_of(std::move(a), std::move(b));
  }
  std::vector<Run> runs;
  for (std::size_t cell = 0; cell < asked.grid.size(); ++cell)
    runs.push_back(open_with(asked, asked.grid.settings(cell), inputs));
  return runs;
}

}  // namespace pabd::cli
