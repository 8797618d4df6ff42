// SPDX-License-Identifier: MIT
// How much memory a thread has taken, for programs that allocations.cpp is part of.
#pragma once

#include <cstddef>

namespace pabd::test {

struct Allocations {
  std::size_t count, bytes;
};

// Of this thread since it began.
Allocations allocations();

}  // namespace pabd::test
