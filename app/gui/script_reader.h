// SPDX-License-Identifier: MIT
// The actions of a script file, read and checked before anything is played. Knows no window.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace pabd {

// A JSON list of actions, or an object with "actions". Throws Error(bad_input) with number and place.
std::vector<nlohmann::ordered_json> read_script(const std::string& json, const std::string& source);

}  // namespace pabd
