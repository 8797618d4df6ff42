// SPDX-License-Identifier: MIT
// The runs of a video: one, two that are compared, or those of a grid.
#pragma once

#include <string>
#include <vector>

#include "app/cli/common.h"
#include "app/frames/run_grid.h"
#include "app/session/run.h"
#include "sim/base/output_path.h"

namespace pabd::cli {

// As options name them. All outlive this.
struct AskedRuns {
  const std::string& scene;
  const CommonOptions& common;
  const std::string& from;
  const std::string& ab;  // file of a patch; empty: there is no B
  const RunGrid& grid;

  std::string name(std::size_t run) const;  // for messages; empty: the scene as it is
};

// `a` is the scene as it is, where they start. What is read is added to `inputs`.
std::vector<Run> open_runs(const AskedRuns& asked, Run a, InputFiles& inputs);

}  // namespace pabd::cli
