// SPDX-License-Identifier: MIT
// What captions and legends say: of a run, and of a parameter.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/solver/parameter_table.h"

namespace pabd {

// "pile, step 180, h = 0.008333 s, N = 3, κ = 916.2 J"; `kappa` is the resolved one. A barrier that has no
// orders is named in place of N; no scene: left out. `d_hat`: with d̂ and the onset too.
std::string run_caption(const std::string& scene, std::int64_t step, const Params& params, double kappa,
                        bool d_hat = false);

// ", ε = 0.2" or ", printed formula (ε = 0)" for titles of barriers; empty where none of them has an onset.
std::string onset_words(const std::vector<BarrierKind>& kinds, double onset);

// A parameter and its `value` in its own unit: "d̂ = 0.01 m".
std::string parameter_text(const ParameterMember& member, double value);

}  // namespace pabd
