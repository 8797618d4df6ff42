// SPDX-License-Identifier: MIT
// See metrics.h.
#include "app/sweep/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pabd {

std::span<const std::string_view> take_words() {
  static constexpr std::array<std::string_view, 5> kWords = {"end", "max", "min", "mean", "sum"};
  return kWords;
}

std::span<const SweepMetric> built_in_metrics() {
  static const std::array kMetrics = {
      SweepMetric{"penetration", MetricKind::number, find_step_number("/max_penetration"), Take::max},
      SweepMetric{"drift", MetricKind::drift, nullptr, Take::max},
      SweepMetric{"energy_error", MetricKind::energy_error, nullptr, Take::max},
      SweepMetric{"iterations", MetricKind::number, find_step_number("/iterations"), Take::mean},
      SweepMetric{"step_time", MetricKind::step_time, nullptr, Take::mean},
      SweepMetric{"distance", MetricKind::distance, nullptr, Take::end}};
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
  end_ = value;
  if (!value) return;
  max_ = count_ > 0 ? std::max(max_, *value) : *value;
  min_ = count_ > 0 ? std::min(min_, *value) : *value;
  sum_ += *value;
  ++count_;
}

std::optional<double> Taken::value(Take take) const {
  if (take == Take::end) return end_;
  if (count_ == 0) return std::nullopt;
  switch (take) {
    case Take::max:
      return max_;
    case Take::min:
      return min_;
    case Take::sum:
      return sum_;
    default:
      return sum_ / static_cast<double>(count_);
  }
}

nlohmann::ordered_json Taken::to_json() const {
  nlohmann::ordered_json json = {{"max", max_}, {"min", min_}, {"sum", sum_}, {"count", count_}};
  if (end_) json["end"] = *end_;
  return json;
}

Taken Taken::from_json(const nlohmann::json& json) {
  Taken taken;
  taken.max_ = json.at("max").get<double>();
  taken.min_ = json.at("min").get<double>();
  taken.sum_ = json.at("sum").get<double>();
  taken.count_ = json.at("count").get<std::int64_t>();
  if (json.contains("end")) taken.end_ = json.at("end").get<double>();
  return taken;
}

}  // namespace pabd
