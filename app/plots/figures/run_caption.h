// SPDX-License-Identifier: MIT
// What every plot of a run says about it: which scene, which step, and the parameters that matter.
#pragma once

#include <cstdint>
#include <string>

#include "sim/solver/params.h"

namespace pabd {

// "pile, step 180, h = 0.008333 s, N = 3, κ = 916.2 J"; `kappa` is the resolved one. A barrier that has no
// orders is named in place of N; no scene: left out. `d_hat`: with d̂ and the onset too.
std::string run_caption(const std::string& scene, std::int64_t step, const Params& params, double kappa,
                        bool d_hat = false);

}  // namespace pabd
