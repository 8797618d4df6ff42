// SPDX-License-Identifier: MIT
// Contexts tried in a child process first: a driver may crash, or never answer, when it is asked for one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/context/candidate.h"

namespace pabd {

// Candidates that come from one library.
struct ContextFamily {
  std::string name;
  std::function<void(std::vector<ContextCandidate>&)> add;
};

// Tries the candidates in order, in a child of this process, up to the first that works: every attempt with
// its failure, empty for the one that works. What crashes is told from what says no. Where no child can be
// started: nothing.
std::vector<ContextAttempt> probe_contexts(const std::vector<ContextFamily>& families);

}  // namespace pabd
