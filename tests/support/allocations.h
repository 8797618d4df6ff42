// SPDX-License-Identifier: MIT
// How much memory a thread has taken, for programs that allocations.cpp is part of.
#pragma once

#include <cstddef>

#include "tests/support/sanitized.h"

namespace pabd::test {

struct Allocations {
  std::size_t count, bytes;
};

// Of this thread since it began. Not under a sanitizer, which brings its own operator new.
#ifndef PABD_SANITIZED
Allocations allocations();
#endif

}  // namespace pabd::test
