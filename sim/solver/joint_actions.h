// SPDX-License-Identifier: MIT
// Motors, dampers, springs and friction of the joints of a step (joint/action.h).
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/problem.h"

namespace pabd {

// How body i moves in the free flight of the step: as fast as it is now, since what is at rest has not begun to fall. Zero for
// what is fixed.
SmallMotion in_flight(const Problem& p, Index i);

// At the start of a step: fills it.action and p.action_at for the joints of p.acting.
void start_actions(Problem& p, Iterate& it);

// The bodies of an island are about to move by `step`, rows (δc, δω): fills ActionStep::ahead of its joints.
void foresee_actions(const Problem& p, const Island& island, const std::vector<Vec6>& step, Iterate& it);

// Where a hold cannot stand as it does in what `newton` foresaw, for other solvers at the iterate, it gives way or holds
// again. Did any change? `converged`: the bodies no longer move; else what the way of the last iteration may have left
// over decides nothing.
bool switch_actions(const Problem& p, const Island& island, bool converged, Iterate& it);

// Energy of the spring of joint k at the iterate; J.
double spring_energy(const Problem& p, const Iterate& it, Index k);

// Work of what else acts along joint k in this step, up to the iterate; J.
double action_work(const Problem& p, const Iterate& it, Index k);

}  // namespace pabd
