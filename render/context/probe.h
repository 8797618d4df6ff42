// SPDX-License-Identifier: MIT
// Contexts tried in another process first: a driver may crash, or never answer, when it is asked for one.
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

// Tries the candidates in order, up to the first that works, and returns every attempt with its failure, empty
// for the one that works. `command` starts a program that ends in try_contexts() with the names that follow;
// what crashes, leaves or does not answer is told from what says no. Nothing where no such program starts.
std::vector<ContextAttempt> probe_contexts(const std::vector<std::string>& command);

// The other side: tries what is not in `skip`, and says so on the standard output. The process ends with this,
// or with whoever started it.
[[noreturn]] void try_contexts(const std::vector<ContextFamily>& families,
                               const std::vector<std::string>& skip);

}  // namespace pabd
