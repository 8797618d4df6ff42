// SPDX-License-Identifier: MIT
// From the command line to a session.
#pragma once

#include <string>

#include "app/cli/common.h"
#include "app/session/diverged.h"
#include "app/session/run.h"
#include "sim/base/output_path.h"

namespace pabd::cli {

// Loads `scene` (file or shipped name) with the overrides of --set; `from`, if not empty, is a state file to
// start at. What is read is added to `inputs`.
Session open_session(const std::string& scene, const CommonOptions& common, const std::string& from,
                     InputFiles& inputs);
// The same as a run that keeps no past.
Run open_run(const std::string& scene, const CommonOptions& common, const std::string& from,
             InputFiles& inputs);

}  // namespace pabd::cli
