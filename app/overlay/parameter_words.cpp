// SPDX-License-Identifier: MIT
// Parameters in words.
#include "app/overlay/parameter_words.h"

#include <fmt/format.h>

#include "app/plots/axis_ticks.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

// A symbol is set in italics, its index is not: "μ_static". Where there is none, the label says it.
std::string rich_symbol(const ParameterRow& row) {
  const std::string symbol = row.symbol;
  if (symbol.empty()) return row.label;
  const auto index = symbol.find('_');
  if (index == std::string::npos) return "*{" + symbol + "}";
  return "*{" + symbol.substr(0, index) + "}_{" + symbol.substr(index + 1) + "}";
}

// A number for people, `resolved` for "auto"; anything else as --set takes it.
std::string value_words(const ParameterValue& value, double resolved) {
  if (const auto* v = std::get_if<Vec3>(&value)) {
    return fmt::format("({}, {}, {})", format_value(v->x()), format_value(v->y()), format_value(v->z()));
  }
  if (const auto* given = std::get_if<std::optional<double>>(&value)) {
    return format_value(given->value_or(resolved));
  }
  const auto number = as_number(value);
  return number ? format_value(*number) : value_text(value);
}

// With its unit, and whether it is automatic.
std::string full_words(const ParameterRow& row, const Params& params, double resolved) {
  const ParameterValue value = value_of(row, params);
  const std::string unit = unit_of(row, params);
  return value_words(value, resolved) + (unit.empty() ? "" : " " + unit) +
         (value == ParameterValue(std::optional<double>()) ? " (auto)" : "");
}

std::string change_words(const ParameterRow& row, const Params& a, double kappa_a, const Params& b,
                         double kappa_b) {
  // The unit once, unless it changes.
  const ParameterValue from = value_of(row, a);
  const bool once =
      std::string_view(unit_of(row, a)) == unit_of(row, b) && from != ParameterValue(std::optional<double>());
  return fmt::format("{} {} → {}", rich_symbol(row),
                     once ? value_words(from, kappa_a) : full_words(row, a, kappa_a),
                     full_words(row, b, kappa_b));
}

}  // namespace

std::vector<std::string> difference_words(const Params& a, double kappa_a, const Params& b, double kappa_b,
                                          ParameterTable table) {
  std::vector<std::string> lines;
  for (const ParameterRow* row : differing(a, b, table)) {
    lines.push_back(change_words(*row, a, kappa_a, b, kappa_b));
  }
  if (!a.contact.kappa && !b.contact.kappa && kappa_a != kappa_b) {  // it follows d̂, N, …
    const ParameterRow& row = parameter_of(&ContactParams::kappa);
    lines.push_back(
        fmt::format("{} {} → {}", rich_symbol(row), format_value(kappa_a), full_words(row, b, kappa_b)));
  }
  return lines;
}

std::string setting_words(const std::string& key, const std::string& text, const Params& params,
                          double kappa) {
  const ParameterRow* row = find_parameter(key);
  return row ? rich_symbol(*row) + " " + full_words(*row, params, kappa) : key + " " + text;
}

}  // namespace pabd
