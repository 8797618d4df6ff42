// SPDX-License-Identifier: MIT
// What plots show, once: words or symbol, unit, and the label of an axis that has it.
#pragma once

#include <string>

namespace pabd {

struct Quantity {
  const char* words;  // rich text
  const char* unit;   // "1": none
  const char* axis;   // "words [unit]"
};

// clang-format off
#define PABD_QUANTITIES(X) \
  X(time,              "time",               "s")     \
  X(wall_clock,        "wall clock",         "ms")    \
  X(gap,               "d",                  "m")     \
  X(relative_gap,      "d/d̂",                "1")     \
  X(overlap,           "max(0, −d)",         "m")     \
  X(depth,             "penetration −d",     "m")     \
  X(depth_before,      "depth before",       "m")     \
  X(depth_after,       "after",              "m")     \
  X(penetration,       "penetration",        "m")     \
  X(length,            "length",             "m")     \
  X(distance,          "distance",           "m")     \
  X(position,          "position",           "m")     \
  X(joint_error,       "largest error",      "m")     \
  X(joints,            "joints",             "m")     \
  X(any_force,         "force",              "N")     \
  X(error,             "error",              "m")     \
  X(ratio,             "ratio",              "1")     \
  X(count,             "count",              "1")     \
  X(energy,            "energy",             "J")     \
  X(incremental,       "E",                  "J")     \
  X(above_end,         "E − E_{end}",        "J")     \
  X(above_least,       "E − E_{min}",        "J")     \
  X(residual,          "residual",           "1")     \
  X(step_size,         "largest step / d̂",   "1")     \
  X(projection_change, "‖A − R‖",            "1")     \
  X(gap_change,        "Δd",                 "m")     \
  X(overlap_change,    "Δ max(0, −d)",       "m")     \
  X(energy_change,     "ΔE",                 "J")     \
  X(error_change,      "Δ error",            "m")     \
  X(barrier,           "B_{N}",              "1")     \
  X(barrier_slope,     "B_{N}′",             "1/m")   \
  X(barrier_curvature, "B_{N}″",             "1/m²")  \
  X(potential,         "Ψ",                  "J")     \
  X(force,             "Ψ′",                 "N")     \
  X(curvature,         "Ψ″",                 "N/m")   \
  X(log_barrier,       "B/d̂²",               "1")     \
  X(log_barrier_slope, "B′/d̂²",              "1/m")   \
  X(log_potential,     "κ B/d̂²",             "J")     \
  X(log_force,         "κ B′/d̂²",            "N")     \
  X(total,             "total energy",       "J")     \
  X(stiffness,         "κ",                  "J")     \
  X(thickness,         "d̂",                  "m")     \
  X(solve_time,        "time of solving",    "ms")    \
  X(collision_time,    "time of collision",  "ms")
// clang-format on

namespace quantities {
#define PABD_DEFINE(name, words, unit) inline constexpr Quantity name{words, unit, words " [" unit "]"};
PABD_QUANTITIES(PABD_DEFINE)
#undef PABD_DEFINE
}  // namespace quantities

// Of a barrier of order N: "B_{3} [1]" for "B_{N} [1]".
inline std::string axis_of_order(const Quantity& quantity, int N) {
  std::string out = quantity.axis;
  return out.replace(out.find("{N}") + 1, 1, std::to_string(N));
}
// Of a barrier that has no order: "B [1]".
inline std::string axis_without_order(const Quantity& quantity) {
  std::string out = quantity.axis;
  return out.erase(out.find("_{N}"), 4);
}

}  // namespace pabd
