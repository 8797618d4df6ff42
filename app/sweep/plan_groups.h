// SPDX-License-Identifier: MIT
// "parameters" of a plan: lists, ranges and samples. Internal to app/sweep.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/sweep/plan.h"
#include "sim/scene/reader.h"

namespace pabd {

// Throws Error(bad_input).
std::vector<SweepGroup> read_groups(const ObjectReader& plan);

// Refuses what is no key for --set.
void check_key(const Node& node, std::string_view key);

// One representation for equal values: 1.0 as 1.
Json canonical(const Json& value);

std::vector<PlanObjectKeys> group_keys();

}  // namespace pabd
