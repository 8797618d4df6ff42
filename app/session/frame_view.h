// SPDX-License-Identifier: MIT
// One simulation at one moment, and all that pictures, panels, plots and files see of it: a value. Nobody
// changes it once it is made, so that any thread may keep it while the simulation goes on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/reports.h"
#include "app/session/trails.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/step_engine.h"

namespace pabd {

struct FrameView {
  std::shared_ptr<const Model> model;  // null only in a view of nothing
  Params params;
  double kappa = 0;  // contact stiffness that params.contact.kappa comes to; J
  // Never null; shared with the past of the run. Where `poses` has the bodies it has a step and a time only.
  std::shared_ptr<const State> state = std::make_shared<const State>();
  std::shared_ptr<const PoseCopy> poses = {};  // where the bodies are, if not in `state`
  StepReport report;  // of the step that led here, with what was observed; energies only where none did
  Reports history;    // of the run that it is a moment of
  std::vector<Trail> trails;  // of the points that somebody asked for
  std::string label;          // which of two runs: "A" or "B"; empty where there is one
};

}  // namespace pabd
