// SPDX-License-Identifier: MIT
// See metrics.h.
#include "app/sweep/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pabd {

std::span<const std::string_view> take_words() {
  static constexpr std::array<std::string_view, 5> kWords = {"end", "max", "min", "mean", "sum"};
  return kWords;
}

std::span<const SweepMetric> built_in_metrics() {
  using Kind = MetricKind;
  static const std::array kMetrics = {
      SweepMetric{"penetration", "penetration", "m", Kind::number, find_step_number("/max_penetration"),
                  Take::max},
      SweepMetric{"drift", "joint drift", "m", Kind::drift, nullptr, Take::max},
      SweepMetric{"energy_error", "energy error", "J", Kind::energy_error, nullptr, Take::max},
      SweepMetric{"iterations", "iterations a step", "", Kind::number, find_step_number("/iterations"),
                  Take::mean},
      SweepMetric{"step_time", "time a step", "ms", Kind::step_time, nullptr, Take::mean},
      SweepMetric{"distance", "distance to the reference", "m", Kind::distance, nullptr, Take::end}};
  return kMetrics;
}

const SweepMetric* find_metric(std::string_view name) {
  const auto all = built_in_metrics();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& m) { return m.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<double> measured(const SweepMetric& metric, const StepMeasures& step) {
  std::optional<double> value;
  switch (metric.kind) {
    case MetricKind::number:
      value = metric.number->value(*step.report);
      break;
    case MetricKind::drift:
      if (step.joints) value = step.report->max_joint_error;
      break;
    case MetricKind::energy_error:
      value = step.energy_error;
      break;
    case MetricKind::step_time:
      value = step.step_time;
      break;
    case MetricKind::distance:
      value = step.distance;
      break;
  }
  return value && std::isfinite(*value) ? value : std::nullopt;
}

void Taken::add(const std::optional<double>& value) {
  has_end_ = value.has_value();
  if (!value) return;
  end_ = *value;
  max_ = count_ > 0 ? std::max(max_, *value) : *value;
  min_ = count_ > 0 ? std::min(min_, *value) : *value;
  sum_ += *value;
  ++count_;
}

std::optional<double> Taken::value(Take take) const {
  if (take == Take::end ? !has_end_ : count_ == 0) return std::nullopt;
  switch (take) {
    case Take::end:
      return end_;
    case Take::max:
      return max_;
    case Take::min:
      return min_;
    case Take::sum:
      return sum_;
    case Take::mean:
      break;
  }
  return sum_ / static_cast<double>(count_);
}

}  // namespace pabd
