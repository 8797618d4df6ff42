// SPDX-License-Identifier: MIT
// What whoever made a run needs to be told at its end, in whatever form its steps are written: overlaps that are seen, and
// steps that ended unsolved.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/sweep/acceptance.h"
#include "sim/solver/params.h"

namespace pabd::cli {

class RunNotes {
 public:
  // `params`: of all steps.
  RunNotes(const Model& model, const Params& params);

  void add(const StepSummary& step);

  // A line each, with what helps; none: nothing is to be told.
  std::vector<std::string> lines() const;

 private:
  Params params_;
  bool driven_;  // a joint has a drive
  bool soft_;    // κ is stated, and smaller than "auto"
  Acceptance acceptance_;
  std::int64_t steps_ = 0, unsolved_ = 0;
  double residual_ = 0;  // largest of an unsolved step, as a part of d̂
};

// "pabd: note: …" each, to standard error.
void write_notes(const std::vector<std::string>& lines);

}  // namespace pabd::cli
