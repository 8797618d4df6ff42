// SPDX-License-Identifier: MIT
// What a person does with a sweep in the window. The same form as app/workbench/command.h.
#pragma once

#include <string>

#include "app/workbench/command.h"

namespace pabd::command {

// The folder of a sweep is read and shown; again when it is open already.
struct OpenSweep {
  static constexpr const char* name = "open_sweep";
  std::string folder;
  void fields(auto&& f) {
    f(need("folder", "of 'pabd sweep', finished or not; empty: closes it", R"("sweep_out")"), folder);
  }
};
// What its cells show, over which parameters. What is left out is chosen: the first metric, the parameters with the
// most values.
struct SweepView {
  static constexpr const char* name = "sweep_view";
  std::string metric, x, y;
  int slice = 0;
  bool pictures = true;
  void fields(auto&& f) {
    f(may("metric", "whose colours the cells have, by its name", R"("penetration")"), metric);
    f(may("x", "parameter from left to right, by its key", R"("contact.N")"), x);
    f(may("y", "parameter from bottom to top, by its key", R"("contact.d_hat")"), y);
    f(may("slice", "of the combinations of the other parameters, from 0", "1"), slice);
    f(may("pictures", "of the ends in the cells; else colours alone", "false"), pictures);
  }
  bool operator==(const SweepView&) const = default;
};
// The scene with the parameters of a task of the open sweep.
struct LoadRun {
  static constexpr const char* name = "load_run";
  int task = 0;
  std::string at = "start";
  bool force = false;
  void fields(auto&& f) {
    f(need("task", "its index", "7"), task);
    f(may("at", "start; or end: as the task left it", R"("end")"), at);
    f(kGiveUp, force);
  }
};

}  // namespace pabd::command
