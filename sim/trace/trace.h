// SPDX-License-Identifier: MIT
// Records of a run, and the files written from them (formats: README of this folder).
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

// 16 hex digits over time, step, poses, velocities and what friction remembers, bit by bit: equal states,
// equal hash.
std::string state_hash(const State& state);

// CSV: the line of column names, and a row for each step, iteration or joint.
void write_steps_header(std::ostream& out);
void write_steps_row(std::ostream& out, const StepSummary& step);
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
