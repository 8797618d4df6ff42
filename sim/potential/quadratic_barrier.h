// SPDX-License-Identifier: MIT
// The quadratic penalty, made C²: the stiffness B″ grows from 0 to 1 over the onset, and stays.
//
//   u < ε    B = u³/(6ε)               B′ = u²/(2ε)      B″ = u/ε
//   u ≥ ε    B = u²/2 − εu/2 + ε²/6    B′ = u − ε/2      B″ = 1
//
// ½u² alone, which ε = 0 gives, has a stiffness that jumps from 0 to κ/d̂² at d̂, so it is C¹ only; the ramp
// mends that without a stiffness that grows for ever, as that of the penalty u³/3 does. Finite for d ≤ 0; N does
// not count. A load F per contact rests at d = d̂ (1 − ε/2 − F d̂/κ) once that is past the onset, at
// d̂ (1 − √(2ε F d̂/κ)) before.
#pragma once

#include "sim/potential/power_sum.h"

namespace pabd::barriers {

struct quadratic {
  static constexpr BarrierTraits traits{.help = "a quadratic penalty with a C² onset", .has_onset = true};

  template <class T>
  [[gnu::always_inline]] static PowerSum<T> sum(const Barrier& b, T u) {
    return BarrierSums<T>::quadratic_sum(u, b.onset);
  }
};

}  // namespace pabd::barriers
