// SPDX-License-Identifier: MIT
// Whether a run is acceptable, whatever its metrics: large overlaps, created energy, unsolved steps. A run with faults
// is never ranked as best. The limits are those of the plan ("accept").
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "sim/solver/report.h"

namespace pabd {

struct Model;
class Node;

struct AcceptanceLimits {
  double overlap = 0.1, drift = 0.1;  // of the smallest movable body's inner radius: what is visible
  double energy = 0.05;               // that comes from nowhere, of the energy that moved
  double unsolved = 0.02;             // of the steps

  bool operator==(const AcceptanceLimits&) const = default;
};
// Those of an object {"overlap", "drift", "energy", "unsolved"}, each optional. Throws Error(bad_input).
AcceptanceLimits read_limits(const Node& node);
std::span<const std::string_view> limit_keys();
nlohmann::ordered_json to_json(const AcceptanceLimits& limits);
// "Acceptable: overlap up to 0.1 of the smallest movable body's inner radius, …", with a full stop.
std::string in_words(const AcceptanceLimits& limits);

class Acceptance {
 public:
  explicit Acceptance(const Model& model);

  // `gained`: kinetic, potential and elastic energy minus their start and the work of drives; J. `asked_to_converge`:
  // the solver has a tolerance.
  void add(const StepSummary& step, double gained, bool asked_to_converge);

  // "bodies overlap by 1.22 m, more than 0.1 of the smallest one's radius (0.05 m)", joined by ", "; empty: acceptable.
  std::string faults(const AcceptanceLimits& limits = {}) const;

  // What was added, as JSON; reading gives the same bits.
  NLOHMANN_DEFINE_TYPE_INTRUSIVE(Acceptance, overlap_, joint_error_, gained_, pressed_in_, lifted_, moved_,
                                 potential_start_, whole_, steps_, unsolved_, crowded_)

 private:
  double size_;  // inner radius of the smallest movable body; m
  double overlap_ = 0, joint_error_ = 0, gained_ = 0, pressed_in_ = 0, lifted_ = 0;
  double moved_ = 0, potential_start_ = 0;  // J; most energy that changed its kind
  double whole_ = 0;                        // J; largest energy of one kind
  std::int64_t steps_ = 0, unsolved_ = 0, crowded_ = 0;
};

}  // namespace pabd
