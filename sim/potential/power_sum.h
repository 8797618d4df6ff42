// SPDX-License-Identifier: MIT
// B as a function of u = 1 − d/d̂, with two derivatives with respect to u, for one distance or for four of
// them (T = double or Lanes).
#pragma once

#include "sim/math/lanes.h"
#include "sim/potential/barrier.h"

namespace pabd {

template <class T>
struct BarrierSums {
  using lane = T;
  using wide = double;
#include "sim/potential/barrier_sums.inl"
};

template <class T>
using PowerSum = typename BarrierSums<T>::BarrierSum;

}  // namespace pabd
