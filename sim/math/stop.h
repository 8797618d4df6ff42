// SPDX-License-Identifier: MIT
// Whether long work is still wanted. Asked between pieces of work, from any thread; empty: it is.
#pragma once

#include <functional>

namespace pabd {

struct Stop {
  const std::function<bool()>* asked = nullptr;
  bool requested() const { return asked && *asked && (*asked)(); }
};

}  // namespace pabd
