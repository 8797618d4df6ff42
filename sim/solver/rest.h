// SPDX-License-Identifier: MIT
// Islands that rest where the step starts: seen from the gradient of E there, before anything is factored.
#pragma once

#include "sim/solver/islands.h"

namespace pabd {

// What `rests` needs of each body of an island.
struct RestMemory {
  std::vector<Vec6> g;       // gradient of E
  std::vector<double> hold;  // stiffness of its contacts; N/m
};

// Does an island of contacts alone rest? Then its bodies are placed where they start, and `error` is how far from there the
// solution may be, at most; d̂. A body rests where the step so far has hardly moved it, and where its gradient is less than what
// its contacts would push back with after as short a way: a small part of the tolerance, or rounding.
bool rests(const Problem& p, const Island& island, RestMemory& memory, Iterate& it, double& error);

}  // namespace pabd
