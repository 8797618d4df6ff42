// SPDX-License-Identifier: MIT
// What the numbers of a step say about the contact parameters, and which single change would help.
//
//   m g     weight of a body                                              N
//   F       load on one of its contacts: (weight + what presses from above) / contacts    N
//   d_eq    gap at which the barrier carries that: Ψ′(d_eq) = −F           m
//   S       κ h²/(m d̂²): contact stiffness against inertia over one step    1
//   u       1 − d/d̂: how far a contact is pressed in                        1
//   ε       onset width: for u < ε the barrier is stiffest (deviation D2)   1
//
// κ of the log barrier is in J/m²; in S it counts as κ d̂².
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/potential/barrier.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// Of the movable bodies; kg; 0 without any. Sorts the masses: call it once a model.
struct MassRange {
  double median = 0, heaviest = 0;
};
MassRange mass_range(const Model& model);

// The largest d with −Ψ′(d) ≥ force, where a force pushes a contact to; m. d̂ for a force that the jump of the
// printed barrier at d̂ exceeds, and for none; −∞ where the barrier cannot carry it (N = 1).
double gap_under_load(const Barrier& barrier, double force);

struct RestGap {
  Index body = 0;   // the heaviest resting one, of equals the most loaded; without a resting one the heaviest
  double gap = 0;   // d_eq, m
  double load = 0;  // F, N
  int contacts = 0;      // that carry the body; assumed: 4
  bool assumed = false;  // no body rests on contacts: four contacts under the weight alone
};

struct ContactNumbers {
  std::optional<RestGap> rest;  // empty without gravity or without movable bodies
  double largest_force = 0;     // N; 0 without contacts
  double stiffness_median = 0;  // S for the median and for the heaviest movable mass; 0 without any
  double stiffness_heaviest = 0;
};

// `report` must hold contact_reports of the step that ended in `state`. A body rests when it is slower than
// what one step of free fall gives it, and contacts carry it.
ContactNumbers contact_numbers(const Model& model, const MassRange& masses, const Params& params,
                               const State& state, const StepReport& report);

enum class AdviceKind : std::uint8_t {
  non_finite,          // the step left the numbers
  log_overlap,         // log barrier, bodies overlap
  overlap,             // d < 0
  unsolved_halves,     // steps in a row ended before their tolerance in halves as well
  iteration_limit,     // the solve ended before its tolerance
  friction_excess,     // friction above μ f_n by more than 1 %: the solve ended before its bounds were right
  pressed_past_onset,  // more than half of the contacts have u > ε
  no_onset,            // ε = 0 where contacts are solved body by body
};

struct Advice {
  AdviceKind kind;
  std::string what;   // one line, with numbers
  std::string why;    // what causes it and what the change does
  std::string key;    // as for --set: "contact.kappa"
  std::string value;  // JSON or a bare word, as for --set: "240"
};

// The most serious first. Every suggestion passes check_params when put into `params`. Estimated changes are meant to be
// repeated if one was not enough.
// `past`: the steps up to this one that were made with `params`, or the last of them.
std::vector<Advice> contact_advice(const Model& model, const Params& params, const State& state,
                                   const StepReport& report, std::span<const StepSummary> past = {});

// As many of the last steps are looked at for advice about many of them.
inline constexpr std::size_t kStepsLookedAt = 60;

// Of steps that are made again in halves (halving.h) and unsolved all the same, one after the other (unsolved_steps.h
// has what helps). A hit that is halved and solved is no news.
// `past`: steps that were made with `params`, the last one last.
std::optional<Advice> halving_advice(const Params& params, std::span<const StepSummary> past);

}  // namespace pabd
