// SPDX-License-Identifier: MIT
// See typed_number.h.
#include "sim/scene/typed_number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "sim/scene/text.h"

namespace pabd {
namespace {

struct KnownUnit {
  std::string_view name, of;
  double factor;
};
constexpr KnownUnit kUnits[] = {{"m", "m", 1},
                                {"mm", "m", 1e-3},
                                {"cm", "m", 1e-2},
                                {"km", "m", 1e3},
                                {"s", "s", 1},
                                {"ms", "s", 1e-3},
                                {"min", "s", 60},
                                {"m/s", "m/s", 1},
                                {"mm/s", "m/s", 1e-3},
                                {"cm/s", "m/s", 1e-2},
                                {"km/h", "m/s", 1 / 3.6},
                                {"m/s²", "m/s²", 1},
                                {"cm/s²", "m/s²", 1e-2},
                                {"J", "J", 1},
                                {"mJ", "J", 1e-3},
                                {"kJ", "J", 1e3},
                                {"MJ", "J", 1e6},
                                {"N", "N", 1},
                                {"mN", "N", 1e-3},
                                {"kN", "N", 1e3},
                                {"N m", "N m", 1},
                                {"kN m", "N m", 1e3},
                                {"N/m", "N/m", 1},
                                {"kN/m", "N/m", 1e3},
                                {"N/mm", "N/m", 1e3},
                                {"N s/m", "N s/m", 1},
                                {"kg", "kg", 1},
                                {"g", "kg", 1e-3},
                                {"t", "kg", 1e3},
                                {"kg m²", "kg m²", 1},
                                {"kg/m³", "kg/m³", 1},
                                {"g/cm³", "kg/m³", 1e3},
                                {"degrees", "degrees", 1},
                                {"deg", "degrees", 1},
                                {"°", "degrees", 1},
                                {"rad", "degrees", 57.29577951308232},
                                {"degrees/s", "degrees/s", 1},
                                {"deg/s", "degrees/s", 1},
                                {"rad/s", "degrees/s", 57.29577951308232}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// A number, and what stands behind it.
struct NumberAndUnit {
  std::string digits;
  std::string_view behind;
  double value = 0;
};
std::optional<NumberAndUnit> number_before_unit(const std::string& typed) {
  char* end = nullptr;
  const double value = std::strtod(typed.c_str(), &end);
  const auto digits = static_cast<std::size_t>(end - typed.c_str());
  if (digits == 0) return std::nullopt;
  return NumberAndUnit{typed.substr(0, digits), trimmed(std::string_view(typed).substr(digits)), value};
}

}  // namespace

std::optional<TypedQuantity> typed_quantity(std::string_view text) {
  const std::string typed(trimmed(text));
  const auto parts = number_before_unit(typed);
  if (!parts || !std::isfinite(parts->value)) return std::nullopt;
  for (const KnownUnit& unit : kUnits) {
    if (unit.name != parts->behind) continue;
    if (unit.factor == 1) return TypedQuantity{parts->digits, unit.of};
    // 0.3 mm are 0.0003 m, not 0.00029999999999999997
    return TypedQuantity{fmt::format("{:.15g}", parts->value * unit.factor), unit.of};
  }
  return std::nullopt;
}

std::string typed_number(std::string_view text, std::string_view unit) {
  const std::string typed(trimmed(text));
  const auto parts = number_before_unit(typed);
  if (!parts) return typed.substr(0, typed.find(' '));  // "auto 12.5 J"
  if (parts->behind.empty() || parts->behind == unit) return parts->digits;
  const auto quantity = typed_quantity(typed);
  return quantity && quantity->unit == unit ? quantity->number : typed;
}

std::string number_problem(const std::string& text, bool whole, std::string_view unit) {
  const std::string typed = typed_number(text, unit);
  std::int64_t number = 0;
  const auto [at, failure] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
  const bool is_whole = failure == std::errc() && at == typed.data() + typed.size();
  if (whole ? is_whole : number_of_text(typed).has_value()) return {};
  return fmt::format("expected a {}number{}, got {}", whole ? "whole " : "",
                     unit.empty() ? "" : fmt::format(" ({})", unit), in_quotes(text));
}

std::optional<double> number_of_text(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == 0 ? std::optional(value) : std::nullopt;
}

std::string number_to_write(std::string_view text, std::string_view unit) {
  const std::string number = typed_number(text, unit);
  const auto value = number_of_text(number);
  return value && std::isfinite(*value) ? "; write " + number : "";
}

}  // namespace pabd
