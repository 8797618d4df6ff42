// SPDX-License-Identifier: MIT
// JSON that keeps the order in which its keys were given: what people read.
#pragma once

#include <nlohmann/json.hpp>

namespace pabd {

using OrderedJson = nlohmann::ordered_json;

}  // namespace pabd
