// SPDX-License-Identifier: MIT
// See halving_advice.h.
#include "app/session/halving_advice.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/counted.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr int kWorthAWord = 15;  // steps of those that are looked at
// d̂ that a body still moved: with less, no picture and no reading is another one.
constexpr double kWorthTelling = 1e-3;
// What 80 iterations, in up to 16 parts of the step, do not solve, more of them seldom do: half the step gains more.
constexpr int kIterationsEnough = 80;
constexpr int kTimes = 4;

}  // namespace

std::optional<Advice> halving_advice(const Params& params, std::span<const StepSummary> past) {
  const SolverParams& solver = params.solver;
  if (solver.tolerance == 0) return std::nullopt;  // that asks for all iterations
  past = past.last(std::min(past.size(), kStepsLookedAt));
  int unsolved = 0, deepest = 0;
  for (const StepSummary& step : past) {
    if (step.status != StepStatus::iteration_limit || !(step.residual > kWorthTelling)) continue;
    ++unsolved;
    deepest = std::max(deepest, step.halvings);
  }
  if (unsolved < kWorthAWord) return std::nullopt;
  Advice advice{AdviceKind::unsolved_halves,
                fmt::format("{} of {} ended unsolved{}", unsolved, counted(past.size(), "step"),
                            deepest > 0 ? fmt::format(", in up to {} parts too", 1 << deepest) : ""),
                "", "", ""};
  const std::string few =
      fmt::format("Too much happens in one step for {}. ", counted(solver.iterations, "iteration"));
  if (solver.iterations < kIterationsEnough) {
    advice.why = few + "More of them solve more of its parts.";
    advice.key = "solver.iterations";
    advice.value = std::to_string(kTimes * solver.iterations);
  } else {
    advice.why = few + "Half the time step halves every move.";
    advice.key = "time_step";
    advice.value = fmt::format("{:.12g}", allowed(&Params::h, 0.5 * params.h));
  }
  return advice;
}

}  // namespace pabd
