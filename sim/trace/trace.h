// SPDX-License-Identifier: MIT
// Records of a run, and the files written from them (formats: README of this folder).
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

// 16 hex digits over time, step, poses, velocities and what friction remembers, bit by bit: equal states,
// equal hash.
std::string state_hash(const State& state);

// The column of a steps CSV that is in no two runs the same: wall clock of the step, ms.
inline constexpr std::string_view kStepTime = "step_ms";

// CSV: the line of column names, and a row for each step, iteration or joint.
void write_steps_header(std::ostream& out);
void write_steps_row(std::ostream& out, const StepSummary& step);

// A steps CSV, read back.
struct StepsFile {
  std::vector<StepSummary> steps;    // in order of time; those that failed are left out
  std::vector<std::string> columns;  // of numbers that it has; what others would hold is 0
  bool has(std::string_view column) const;
};
// The columns may be in any order; unknown ones, as other versions write, are skipped. Times are finite and do not
// fall. Throws Error(bad_input) with the line, also without steps and for more than `most`. `source` names it.
StepsFile steps_from_csv(std::string_view text, const std::string& source, std::size_t most);

void write_iterations_header(std::ostream& out);
void write_iterations_rows(std::ostream& out, const StepReport& report);  // one row an IterationRecord
void write_joints_header(std::ostream& out);
// One row a joint of the model; nothing without StepReport::joint_reports.
void write_joints_rows(std::ostream& out, const Model& model, const StepReport& report);

// State JSON. Numbers are printed so that reading them gives the same bits.
std::string state_to_json(const Model& model, const State& state);
// A file that is longer holds no state of this model.
std::size_t most_state_bytes(const Model& model);
// Throws Error(bad_input) when the text is malformed or does not fit the model (names, count, finite, unit
// rotations).
State state_from_json(const Model& model, const std::string& text, const std::string& source);

}  // namespace pabd
