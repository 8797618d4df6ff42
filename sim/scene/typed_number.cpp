// SPDX-License-Identifier: MIT
// See typed_number.h.
#include "sim/scene/typed_number.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace pabd {
namespace {

struct Scaled {
  std::string_view name, of;
  double factor;
};
constexpr Scaled kScaled[] = {
    {"mm", "m", 1e-3},     {"cm", "m", 1e-2},        {"km", "m", 1e3},
    {"ms", "s", 1e-3},     {"min", "s", 60},         {"mm/s", "m/s", 1e-3},
    {"cm/s", "m/s", 1e-2}, {"km/h", "m/s", 1 / 3.6}, {"mJ", "J", 1e-3},
    {"kJ", "J", 1e3},      {"MJ", "J", 1e6},         {"mN", "N", 1e-3},
    {"kN", "N", 1e3},      {"kN/m", "N/m", 1e3},     {"g", "kg", 1e-3},
    {"deg", "degrees", 1}, {"°", "degrees", 1},      {"rad", "degrees", 57.29577951308232}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string typed_number(std::string_view text, std::string_view unit) {
  const std::string typed(trimmed(text));
  char* end = nullptr;
  const double value = std::strtod(typed.c_str(), &end);
  const auto digits = static_cast<std::size_t>(end - typed.c_str());
  if (digits == 0) return typed.substr(0, typed.find(' '));  // "auto 12.5 J"
  const std::string_view behind = trimmed(std::string_view(typed).substr(digits));
  if (behind.empty() || behind == unit) return typed.substr(0, digits);
  for (const Scaled& scaled : kScaled)  // 0.3 mm are 0.0003 m, not 0.00029999999999999997
    if (scaled.name == behind && scaled.of == unit) return fmt::format("{:.15g}", value * scaled.factor);
  return typed;
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
