// SPDX-License-Identifier: MIT
// What a run says whose steps are made again in halves (halving.h) and are unsolved all the same.
//
// A hit is halved and solved: that is no news. Steps that end at the iteration limit in their parts as well, one after
// the other, are: more iterations solve more of the parts, and a smaller step what many iterations do not.
#pragma once

#include <optional>
#include <span>

#include "app/session/contact_advice.h"

namespace pabd {

// As many of the last steps are looked at.
inline constexpr std::size_t kStepsLookedAt = 60;

// `past`: steps that were made with `params`, the last one last.
std::optional<Advice> halving_advice(const Params& params, std::span<const StepSummary> past);

}  // namespace pabd
