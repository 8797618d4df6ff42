// SPDX-License-Identifier: MIT
// A step that ends unsolved is made again as two halves (Deviation D23), island by island, down to `solver.halvings` levels.
//
// Unsolved is an island
//   that is not finite or out of all bounds (runaway.h),
//   whose bodies moved by more than kUnsolved d̂ in the last iteration,
//   whose friction is off by more than kUnsettled (IslandReport::friction_error),
//   that has more energy than it may have, converged or not (gains() and gains_in_all() of energy_bound.h),
//   or that overlaps at its end where the step knew of no contact (late_contacts.h).
// Not with one iteration a step, which asks for what that gives, and not for `sissm`, whose bonds are as stiff as h lets them be.
// Not a crowd (Deviation D25), unless it is not finite.
#pragma once

#include "sim/solver/energy_bound.h"
#include "sim/solver/model_parts.h"
#include "sim/solver/time_step.h"

namespace pabd {

inline constexpr double kUnsolved = 0.03, kUnsettled = 0.01;
// Times the iterations: at the last depth, from where there is no other way, and where a solution is near.
inline constexpr int kLastChance = 4;

// Is a step with these parameters made again where it ends unsolved?
bool may_halve(const SolverParams& solver);

bool ends_unsolved(const IslandReport& island, const EnergyBalance& energy);
// The first of these only: the last kReserve levels are for no other. Links of a gram under a weight of 32 kg need them; what
// gains a little energy does not get better there.
bool is_far_from_solved(const IslandReport& island);
inline constexpr int kReserve = 2;

// What becomes of the step of an island: it stays, it is made again in halves, or it cannot be made and the whole step fails.
enum class Verdict : std::uint8_t { stays, again, fails };
struct StepMemory;
// Of island k, whose velocities are known. Fills its energies in `m`, and how far it is from solved in `outcome`.
Verdict judge_island(const Problem& p, std::size_t k, const Workers& workers, StepMemory& m,
                     IslandReport& outcome);

// What a half of such a step is made with; `kappa`: of contacts in the whole of it, "auto" or not; J.
Params of_half(const Params& whole, double kappa);

// What both halves report: work and times, and the worst of both. How it ends is the second's.
StepSummary both(const StepSummary& first, const StepSummary& second);

// The islands of a step that are made again, as a model of their own, and the memory of their halves.
class Halves {
 public:
  // Takes the bodies i with chosen[i] from the start of the step.
  void take(const Problem& p, const std::vector<std::uint8_t>& chosen);

  // Makes the two halves. The report, of both, has status non_finite or interrupted where they were not made; `team` works.
  const StepReport& make(const Problem& p, const StepOptions& options, Team& team);

  // Poses of its bodies where its halves end, into those of all.
  void place(std::vector<Pose>& pose) const;

  // Puts what came out into the state of the end, and into its report: of the other islands only (add_report).
  void put(const Islands& islands, State& state, StepReport& report) const;

 private:
  ModelPart part_;
  Params params_;
  StepOptions options_;
  State state_;
  StepWorkspace workspace_;
  StepReport half_, both_;
};

}  // namespace pabd
