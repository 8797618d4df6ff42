// Friction from step to step and from iterate to iterate: coefficients, bounds, anchors (Deviation D6).
#pragma once

#include <algorithm>

#include "sim/solver/workspace.h"

namespace pabd {

// Names of contacts that last from step to step.
inline std::uint64_t pair_key(Index a, Index b) {
  const auto [lo, hi] = std::minmax(a, b);
  return static_cast<std::uint64_t>(lo) << 32 | static_cast<std::uint32_t>(hi);
}
// The top bit tells which body owns the normal: an anchor is lost when the owner changes, its frame being
// another.
inline std::uint32_t owned_feature(Index a, Index b, std::uint32_t feature) {
  return (feature & 0x7fffffffu) | (a > b ? 0x80000000u : 0u);
}

// Gives the contacts of w.patches the stretch and coefficient that the last step left. Both lists are sorted.
void recall_friction(const std::vector<FrictionAnchor>& anchors, StepWorkspace::Impl& w);

// Static or dynamic friction for contacts without a past: a new one slides if at the first iterate its
// tangential force is beyond the static bound. Then the first bounds.
void start_friction(int threads, StepWorkspace::Impl& w);

// μ f_n of every contact from the current iterate.
enum class LimitsOf { all, newton };  // descent's sweeps move those of their bodies themselves
void update_friction_limits(int threads, LimitsOf which, StepWorkspace::Impl& w);

// Remembers the stretch of every loaded contact, and whether it slid, for the next step.
void store_friction(const StepWorkspace::Impl& w, std::vector<FrictionAnchor>& anchors);

}  // namespace pabd
