// SPDX-License-Identifier: MIT
// Published numbers against the program's own: a row a case and step.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/plots/plot.h"
#include "app/validate/case.h"

namespace pabd::validate {

// All of them, in the order of the table.
const std::vector<Case>& all_cases();

// Those with a key that one of the words is part of, in the order of the table; all without words. Throws
// Error(bad_input) for a word that no key has.
std::vector<const Case*> chosen_cases(const std::vector<std::string>& words);

struct Row {
  const Case* of = nullptr;
  double h = 0, margin = 0;
  Outcome outcome;
  std::string failure;  // why there is no outcome
  double error() const { return outcome.value - of->published; }
  bool passes() const;  // a value that is no number does not
};

// The rows of these cases, on so many threads; each is the same on any number of them. `stop` is asked before every time
// step, and `done` told of every row, both from any thread. Empty when it was stopped.
std::vector<Row> run_cases(const std::vector<const Case*>& cases, int threads,
                           const std::function<bool()>& stop, const std::function<void(const Row&)>& done);

// A table for a terminal, `markdown` for a report.
std::string table_of(const std::vector<Row>& rows);
std::string markdown_of(const std::vector<Row>& rows);
nlohmann::ordered_json json_of(const std::vector<Row>& rows);

// Ours over the published curve, a curve a step; no plots where the case has one number only.
Figure figure_of(const Case& of, const std::vector<Row>& rows);

}  // namespace pabd::validate
