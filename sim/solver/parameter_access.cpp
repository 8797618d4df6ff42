// SPDX-License-Identifier: MIT
// What is read off a row. See parameter_table.h.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

// The struct that a member belongs to.
template <class AnyParams, class Type>
auto& owner(AnyParams& params, Type Params::*) {
  return params;
}
template <class AnyParams, class Type>
auto& owner(AnyParams& params, Type SolverParams::*) {
  return params.solver;
}
template <class AnyParams, class Type>
auto& owner(AnyParams& params, Type ContactParams::*) {
  return params.contact;
}

// The value that a row has in fresh parameters; says its type.
ParameterValue typical(const ParameterRow& row) { return value_of(row, Params{}); }

// ---- the words of each enumeration, in the order of scene files ----

// Words and values of the enumerators, in this order.
template <auto... enumerators>
std::span<const ParameterChoice> named() {
  static const std::array all{ParameterChoice{to_string(enumerators), enumerators}...};
  return all;
}

std::span<const ParameterChoice> choices(SolverMethod) {
  using enum SolverMethod;
  return named<automatic, sissm, descent, newton>();
}
std::span<const ParameterChoice> choices(Projection) {
  using enum Projection;
  return named<automatic, polar, weighted, tangent>();
}
std::span<const ParameterChoice> choices(Integrator) { return named<Integrator::euler, Integrator::bdf2>(); }
std::span<const ParameterChoice> choices(SolverDevice) {
  using enum SolverDevice;
  return named<cpu, gpu, automatic>();
}
std::span<const ParameterChoice> choices(FrictionRule) {
  using enum FrictionRule;
  return named<geometric_mean, average, min, max, product>();
}
// The usual one first.
std::span<const ParameterChoice> choices(BarrierKind) {
  static const auto all = [] {
    std::vector<ParameterChoice> kinds;
    for (const BarrierKind kind : kBarrierKinds) kinds.push_back({to_string(kind), kind});
    std::stable_partition(kinds.begin(), kinds.end(), [](const ParameterChoice& choice) {
      return std::get<BarrierKind>(choice.value) == BarrierKind::polynomial;
    });
    return kinds;
  }();
  return all;
}

// 1e-9, not 1e-09.
std::string short_number(double x) {
  std::string text = fmt::format("{}", x);
  const auto digits = text.find('e') + 1;  // 0: no exponent
  if (digits > 0 && text[digits] == '+') text.erase(digits, 1);
  const auto zero = digits + (digits > 0 && text[digits] == '-' ? 1 : 0);
  if (digits > 0 && text[zero] == '0') text.erase(zero, 1);
  return text;
}

}  // namespace

const ParameterSection* find_section(std::string_view key) {
  for (const ParameterSection& section : parameter_sections()) {
    if (key == section.key) return &section;
  }
  return nullptr;
}

const ParameterRow* find_parameter(std::string_view key, ParameterTable table) {
  for (const ParameterRow& row : table) {
    if (key == row.key) return &row;
  }
  return nullptr;
}

const ParameterRow& parameter_of(const ParameterMember& member) {
  for (const ParameterRow& row : parameter_table()) {
    if (row.member == member) return row;
  }
  throw std::logic_error("a member of Params that has no row in the table of parameters");
}

ParameterValue value_of(const ParameterRow& row, const Params& params) {
  return std::visit([&](auto member) -> ParameterValue { return owner(params, member).*member; }, row.member);
}

void set_value(const ParameterRow& row, Params& params, const ParameterValue& value) {
  std::visit(
      [&](auto member) {
        auto& place = owner(params, member).*member;
        place = std::get<std::remove_cvref_t<decltype(place)>>(value);
      },
      row.member);
}

ParameterKind kind_of(const ParameterRow& row) {
  return std::visit(
      []<class Type>(const Type&) {
        if constexpr (std::is_same_v<Type, int>) return ParameterKind::whole;
        if constexpr (std::is_same_v<Type, bool>) return ParameterKind::flag;
        if constexpr (std::is_same_v<Type, Vec3>) return ParameterKind::vector;
        return std::is_enum_v<Type> ? ParameterKind::choice : ParameterKind::real;
      },
      typical(row));
}

bool may_be_auto(const ParameterRow& row) {
  return std::holds_alternative<std::optional<double>>(typical(row));
}

std::optional<double> as_number(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<int>(&value)) return *whole;
  if (const auto* given = std::get_if<std::optional<double>>(&value)) return *given;
  return std::nullopt;
}

ParameterValue as_value(const ParameterRow& row, double number) {
  const ParameterKind kind = kind_of(row);
  if (kind == ParameterKind::whole) return static_cast<int>(std::lround(number));
  if (kind != ParameterKind::real) throw std::logic_error("this parameter takes no number");
  if (may_be_auto(row)) return std::optional(number);
  return number;
}

double allowed(const ParameterMember& member, double x) {
  const ParameterRange& range = parameter_of(member).range;
  assert(!range.above && !range.below);
  return std::clamp(x, range.lo, range.hi);
}

std::span<const ParameterChoice> choices_of(const ParameterRow& row) {
  return std::visit(
      []<class Type>(const Type& value) -> std::span<const ParameterChoice> {
        if constexpr (std::is_enum_v<Type>) return choices(value);
        return {};
      },
      typical(row));
}

const char* word_of(const ParameterValue& value) {
  return std::visit(
      []<class Type>(const Type& v) -> const char* {
        if constexpr (std::is_enum_v<Type>) return to_string(v);
        return "";
      },
      value);
}

std::string range_text(const ParameterRow& row) {
  const ParameterKind kind = kind_of(row);
  if (kind == ParameterKind::flag) return "true or false";
  std::string out;
  for (const ParameterChoice& choice : choices_of(row)) {
    out += fmt::format("{}{}", out.empty() ? "" : ", ", choice.word);
  }
  const ParameterRange& range = row.range;
  const bool lo = std::isfinite(range.lo), hi = std::isfinite(range.hi);
  if (lo) out += (range.above ? "above " : "from ") + short_number(range.lo);
  if (lo && hi) out += range.above ? " and up " : " ";
  if (hi) out += (range.below ? "to below " : "to ") + short_number(range.hi);
  return out;
}

std::string expected_of(const ParameterRow& row) {
  const ParameterKind kind = kind_of(row);
  std::string out = may_be_auto(row) ? "\"auto\" or " : "";
  if (kind != ParameterKind::choice && kind != ParameterKind::flag) {
    out += fmt::format("a {}{}", kind == ParameterKind::whole ? "whole " : "", row.noun);
  }
  const std::string range = range_text(row);
  if (!range.empty()) out += (out.empty() ? "" : " ") + range;
  return *row.unit ? fmt::format("{} ({})", out, row.unit) : out;
}

const char* symbol_of(const ParameterRow& row) { return *row.symbol ? row.symbol : row.label; }

const char* unit_of(const ParameterRow& row, const Params& params) {
  return row.unit_with ? row.unit_with(params) : row.unit;
}

std::string pointer_of(std::string_view key) {
  std::string out = "/";
  for (const char c : key) out += c == '.' ? '/' : c;
  return out;
}

}  // namespace pabd
