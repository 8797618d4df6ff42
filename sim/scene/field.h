// SPDX-License-Identifier: MIT
// Keys of scene files, as data. Every entry of a scene file is a struct that lists its keys once, each with its range,
// unit, default and meaning: `void fields(auto&& f)` calls f(field, member) for each, or f(field, member, default). What
// reads, writes and explains scene files visits these lists (fields.h), so that a new key is one member and one call.
#pragma once

#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "sim/math/types.h"

namespace pabd {

// Numbers lo … hi; `open` leaves out the ends.
struct Range {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  std::string_view unit = {};
  bool open = false;

  bool contains(double x) const { return open ? x > lo && x < hi : x >= lo && x <= hi; }
  std::string text() const;  // "a number from 0 to 1 (m)"
  // Of its unit, in rad where that is degrees.
  double size() const { return unit.starts_with("degrees") ? kDegree : 1; }
};

inline constexpr std::int64_t kMostBodies = 4'000'000;
inline constexpr std::int64_t kMostJoints = 8'000'000;
inline constexpr double kFarthest = 1e6;    // |coordinate| of a position; m
inline constexpr double kMostForce = 1e12;  // N, N m

inline constexpr Range kSizeRange{1e-6, 1e6, "m"};
inline constexpr Range kGapRange{0, 1e3, "m"};
inline constexpr Range kPositionRange{-kFarthest, kFarthest, "m"};
inline constexpr Range kDirectionRange{-1e6, 1e6};
inline constexpr Range kDensityRange{1e-6, 1e9, "kg/m³"};
inline constexpr Range kMassRange{1e-9, 1e12, "kg"};
inline constexpr Range kVelocityRange{-1e6, 1e6, "m/s"};
inline constexpr Range kSpinRange{-1e7, 1e7, "degrees/s"};
inline constexpr Range kAngleRange{-180, 180, "degrees"};
inline constexpr Range kTurnRange{-360, 360, "degrees"};
inline constexpr Range kManyTurnsRange{-1e6, 1e6, "degrees"};  // a drive may go round many times
inline constexpr Range kBodyCountRange{1, kMostBodies};

// What may stand under a key. The form of its value is that of the member it belongs to.
struct Field {
  std::string_view key = {};
  std::string_view help = {};  // one sentence or more, without the last full stop
  Range range = {};            // of its numbers
  bool required = false;
  bool of_type = true;              // false: entries of this type do not have it
  bool direction = false;           // three numbers of any length but 0, read as a unit vector
  bool may_be_auto = false;         // kAutoKappa stands as "auto"
  bool or_constant = false;         // a quantity over time may stand as one value
  bool turns = false;               // what is in it acts about an axis, rather than along one
  std::string_view otherwise = {};  // where it is left out, when that is no constant: "as at the start"
  std::string_view file = {};       // "a scene file": a text that names one
  std::span<const std::string_view> words = {};  // the only texts or enumerators that may stand here

  template <class T>
  constexpr Field with(T Field::*member, const T& value) const {
    Field out = *this;
    out.*member = value;
    return out;
  }
  constexpr Field only(bool there) const { return with(&Field::of_type, there); }
  constexpr Field as_direction() const { return with(&Field::direction, true); }
  constexpr Field or_auto() const { return with(&Field::may_be_auto, true); }
  constexpr Field or_value() const { return with(&Field::or_constant, true); }
  constexpr Field turning(bool about_axis) const { return with(&Field::turns, about_axis); }
  constexpr Field or_else(std::string_view text) const { return with(&Field::otherwise, text); }
  constexpr Field as_file(std::string_view what) const { return with(&Field::file, what); }
  constexpr Field one_of(std::span<const std::string_view> list) const { return with(&Field::words, list); }
  constexpr Field one_of(std::initializer_list<std::string_view> list) const {  // for the call that visits it
    return one_of(std::span(list.begin(), list.size()));
  }
};

constexpr Field need(std::string_view key, std::string_view help, const Range& range = {}) {
  return {.key = key, .help = help, .range = range, .required = true};
}
constexpr Field may(std::string_view key, std::string_view help, const Range& range = {}) {
  return {.key = key, .help = help, .range = range};
}

}  // namespace pabd
