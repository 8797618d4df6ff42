// SPDX-License-Identifier: MIT
// What a sweep measures in each of its runs.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/solver/step_numbers.h"

namespace pabd {

enum class Take : std::uint8_t { end, max, min, mean, sum };
std::span<const std::string_view> take_words();  // in the order of Take

enum class MetricKind : std::uint8_t { number, drift, energy_error, step_time, distance };

struct SweepMetric {
  std::string name, words, unit;  // of built-in metrics only
  MetricKind kind = MetricKind::number;
  const StepNumber* number = nullptr;  // of kind `number`
  Take take = Take::end;
};

// With what is taken of them by default.
std::span<const SweepMetric> built_in_metrics();
const SweepMetric* find_metric(std::string_view name);  // null: none

// What metrics need of a step.
struct StepMeasures {
  const StepSummary* report = nullptr;
  bool joints = false;             // the model has some
  double energy_error = 0;         // J
  double step_time = 0;            // ms
  std::optional<double> distance;  // m
};
// Empty: the step has no such value.
std::optional<double> measured(const SweepMetric& metric, const StepMeasures& step);

// Running end, maximum, minimum, mean and sum of a metric.
class Taken {
 public:
  void add(const std::optional<double>& value);
  std::optional<double> value(Take take) const;  // empty: there is none

  // As JSON; reading gives the same bits.
  NLOHMANN_DEFINE_TYPE_INTRUSIVE(Taken, has_end_, end_, max_, min_, sum_, count_)

 private:
  bool has_end_ = false;
  double end_ = 0, max_ = 0, min_ = 0, sum_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace pabd
