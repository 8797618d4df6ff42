// SPDX-License-Identifier: MIT
// Parameters in words, as captions and marks show them.
#pragma once

#include <string>
#include <vector>

#include "sim/solver/parameter_table.h"

namespace pabd {

// What of the tunable parameters differs, one line a key in the order of the scene's schema: "κ 100 → 50 J",
// "solver descent → newton", "N 3 → 8". Rich text. `kappa_a` and `kappa_b` are the resolved contact
// stiffnesses, shown for "auto"; where both are automatic and differ, that is a line too.
std::vector<std::string> difference_words(const Params& a, double kappa_a, const Params& b, double kappa_b,
                                          ParameterTable table = parameter_table());

// One of them with its unit: "κ 50 J"; a key that is none of them as --set takes it: "KEY TEXT". Rich text.
std::string setting_words(const std::string& key, const std::string& text, const Params& params,
                          double kappa);

}  // namespace pabd
