// SPDX-License-Identifier: MIT
// A scene, a workbench with it, and what it says to a command that it refuses.
#pragma once

#include <memory>
#include <string>

#include "app/workbench/workbench.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"
#include "tests/support/places.h"

namespace pabd::test {

inline Workbench open(const std::string& scene = places::scenes() + "/two_boxes.json") {
  return Workbench({}, command::Load{scene, {}, false});
}

inline std::shared_ptr<const Scene> two_boxes() {
  return std::make_shared<const Scene>(load_scene(places::scenes() + "/two_boxes.json"));
}
inline constexpr std::size_t kPlenty = std::size_t{64} << 20;  // bytes for its past

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
