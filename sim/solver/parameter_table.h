// SPDX-License-Identifier: MIT
// The table of parameters: a new one is a member of a struct in params.h and a row in parameter_table.cpp. The scene reader and
// writer, --set, checks, manifolds, sliders, captions, the JSON Schema and the reference in assets/README.md read the row.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "sim/body/model.h"
#include "sim/solver/params.h"

namespace pabd {

// A value is of the type of its member. An empty optional is "auto".
using ParameterValue = std::variant<double, int, bool, Vec3, std::optional<double>, SolverMethod, Projection,
                                    Integrator, SolverDevice, BarrierKind, FrictionRule>;

template <class... Types>
using MemberOfParams = std::variant<Types Params::*..., Types SolverParams::*..., Types ContactParams::*...>;
using ParameterMember = MemberOfParams<double, int, bool, Vec3, std::optional<double>, SolverMethod,
                                       Projection, Integrator, SolverDevice, BarrierKind, FrictionRule>;

enum class ParameterScale : std::uint8_t { linear, log };
enum class ParameterKind : std::uint8_t { real, whole, flag, choice, vector };

struct ParameterRange {
  double lo = -std::numeric_limits<double>::infinity(), hi = std::numeric_limits<double>::infinity();
  bool above = false, below = false;  // without the end: lo < x, x < hi
  bool contains(double x) const { return (above ? x > lo : x >= lo) && (below ? x < hi : x <= hi); }
};

struct ParameterRow {
  const char* key;          // as for --set, and its place in a scene file: "contact.d_hat"
  const char* label;        // beside a slider: "thickness d̂"
  const char* symbol = "";  // in formulas: "d̂"; "μ_static" has an index. Empty: none, the label stands for it
  const char* unit = "";                              // SI
  const char* (*unit_with)(const Params&) = nullptr;  // where other parameters change the unit
  const char* noun = "number";                        // what a message expects: a "thickness"
  const char* help;  // in words; may be several sentences, no stop at the end
  ParameterMember member;
  ParameterRange range = {};                      // of a number, or of each of three; see expected_of
  double slider_lo = 0, slider_hi = 1;            // what a slider spans; range says what is allowed
  ParameterScale scale = ParameterScale::linear;  // of the slider
  const char* follows = nullptr;  // key of the row above whose value this one has where a scene leaves it out
  bool hashed = true;             // part of a scene's hash: not what says who computes, only what
  bool hashed_default = true;     // false: only where it is not the default, for keys that came later
  bool (*applies)(const Model&) = nullptr;  // has it an effect on that model? null: always
};
using ParameterTable = std::span<const ParameterRow>;

// Of `Params`, in the order of scene files.
ParameterTable parameter_table();

// An object of a scene file that holds parameters: "contact", "contact.friction".
struct ParameterSection {
  const char* key;
  const char* help;
  const char* as_number =
      nullptr;  // what one number means, of the first row and those that follow it; null: it is refused
};
std::span<const ParameterSection> parameter_sections();
const ParameterSection* find_section(std::string_view key);  // null: none of that name

// Null for a key that is not in the table.
const ParameterRow* find_parameter(std::string_view key, ParameterTable table = parameter_table());

// The row of a member: parameter_of(&ContactParams::kappa). Throws std::logic_error when it has none.
const ParameterRow& parameter_of(const ParameterMember& member);

ParameterKind kind_of(const ParameterRow& row);
bool may_be_auto(const ParameterRow& row);

ParameterValue value_of(const ParameterRow& row, const Params& params);
// Does not check the range. Throws std::bad_variant_access for a value of another type than the member's.
void set_value(const ParameterRow& row, Params& params, const ParameterValue& value);

// For a slider: the value as a number, empty for "auto" and what is no number; and a number as a value, to
// the nearest whole one where it must be. as_value throws std::logic_error when the row takes no number.
std::optional<double> as_number(const ParameterValue& value);
ParameterValue as_value(const ParameterRow& row, double number);

// The number nearest to x that the member's row allows. Not for ranges without an end of theirs.
double allowed(const ParameterMember& member, double x);

// The words of an enumeration, in the order of scene files; empty for other values.
struct ParameterChoice {
  const char* word;
  ParameterValue value;
};
std::span<const ParameterChoice> choices_of(const ParameterRow& row);
const char* word_of(const ParameterValue& value);  // "" for what has no word

// What the range allows, in words: "from 1e-9 to 1000"; the words of a choice.
std::string range_text(const ParameterRow& row);
// For messages: "a thickness from 1e-9 to 1000 (m)".
std::string expected_of(const ParameterRow& row);
// "d̂", or the label where there is no symbol.
const char* symbol_of(const ParameterRow& row);
// The unit while the other parameters are these: κ is in J, with the log barrier in J/m².
const char* unit_of(const ParameterRow& row, const Params& params);
// The place in a scene file: "/contact/d_hat".
std::string pointer_of(std::string_view key);

// check_params (params.h) with the ranges of another table.
std::optional<ParamError> check_params(const Params& params, ParameterTable table);

}  // namespace pabd
