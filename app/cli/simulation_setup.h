// SPDX-License-Identifier: MIT
// From the command line to a session.
#pragma once

#include <memory>
#include <string>

#include "app/cli/common.h"
#include "app/session/diverged.h"
#include "app/session/run.h"
#include "sim/base/output_path.h"
#include "sim/import/notes.h"

namespace pabd::cli {

// What of a robot is not in its scene, a line each, to standard error.
void write_import_notes(const std::string& robot, const std::vector<ImportNote>& notes);

// Loads `scene` (file, robot or shipped name) with the overrides of --set. What is read is added to `inputs`, and
// what of a robot is left out is said.
std::shared_ptr<const Scene> open_scene(const std::string& scene, const CommonOptions& common,
                                        InputFiles& inputs);
// The same as a simulation; `from`, if not empty, is a state file to start at.
Session open_session(const std::string& scene, const CommonOptions& common, const std::string& from,
                     InputFiles& inputs);
// The same as a run that keeps no past.
Run open_run(const std::string& scene, const CommonOptions& common, const std::string& from,
             InputFiles& inputs);

}  // namespace pabd::cli
