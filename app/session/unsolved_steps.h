// SPDX-License-Identifier: MIT
// What is said of steps that end unsolved, by the window and at the end of a run.
#pragma once

#include <string>

#include "sim/solver/params.h"

namespace pabd {

// Parts of d̂ by which a body still moved in the last iteration: with less, no picture and no reading is another one.
inline constexpr double kUnsolvedWorthTelling = 1e-3;

struct Remedy {
  std::string key;    // as for --set: "time_step"
  std::string value;  // …: "0.00833333"
  std::string why;
};
// What of the solver is less than by default, else half the step. More iterations than by default solve next to nothing:
// in 180 steps of the scene 'pile' 7 end unsolved with 20 and 12 with 80 of them, and 2 of 360 of half the length.
Remedy remedy_for_unsolved(const Params& params);

}  // namespace pabd
