// SPDX-License-Identifier: MIT
// The law of joints that say nothing of their own, as settings: "joints_default.kappa=50". It belongs to the joints of
// a scene, which is read again with another one; what compares two laws (a patch, the window's A/B) says it so.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/joint.h"

namespace pabd {

inline constexpr std::string_view kJointSettings = "joints_default";

// Whether "joints_default.kappa" or "joints_default.kappa=50" is meant.
bool is_joint_setting(std::string_view key);

// Those of "key=value" settings that are of joints; the others stay.
std::vector<std::string> take_joint_settings(std::vector<std::string>& settings);

// Those of a merge patch: "joints_default.kappa=50" for {"joints_default": {"kappa": 50}}, which is taken out of its
// text. A patch without them, and text that is no JSON, stays as it is. Throws Error(bad_input) that names `source`.
std::vector<std::string> take_joint_settings(std::string& patch, const std::string& source);

bool same_law(const BondLaw& a, const BondLaw& b);

// {"joints_default.potential", "hard"} and so on; N and d_hat are of the hard potential only.
std::vector<std::pair<std::string, std::string>> joint_settings(const BondLaw& law);
// Settings that differ, with the value in `to`.
std::vector<std::pair<std::string, std::string>> joint_differences(const BondLaw& from, const BondLaw& to);

// What leads from the scene's law by `now` to `settings`, for reading the scene again: another potential has κ "auto"
// unless they say it, for a number of the other one has another unit.
std::vector<std::string> joint_settings_after(const BondLaw& scene, const BondLaw& now,
                                              const std::vector<std::string>& settings);

// The merge patch `patch` with "joints_default" where the laws differ; ends in a line break.
std::string patch_with_joints(const std::string& patch, const BondLaw& from, const BondLaw& to);

}  // namespace pabd
