// SPDX-License-Identifier: MIT
// A workbench with a scene, and what it says to a command that it refuses.
#pragma once

#include <string>

#include "app/workbench/workbench.h"
#include "sim/base/error.h"

namespace pabd::test {

inline Workbench open(const std::string& scene = PABD_SCENES "/two_boxes.json") {
  return Workbench({}, command::Load{scene, {}, false});
}

// Empty when it takes it.
inline std::string refusal(Workbench& bench, const Command& command) {
  try {
    bench.apply(command);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace pabd::test
