// SPDX-License-Identifier: MIT
// Robots of tests as scenes that run.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "sim/base/error.h"
#include "sim/import/import.h"
#include "sim/solver/time_step.h"

namespace pabd::test {

struct ImportedRun {
  explicit ImportedRun(const std::string& text, const std::vector<std::string>& sets = {})
      : scene(parse_scene(text, "robot", {}, sets)), state(scene.initial) {}

  void run(double until) {
    while (state.time < until - scene.params.h / 2)
      step(scene.model, scene.params, {}, state, workspace, report);
  }
  std::size_t body(const std::string& name) const {
    const auto& names = scene.model.name;
    const auto found = std::find(names.begin(), names.end(), name);
    REQUIRE(found != names.end());
    return static_cast<std::size_t>(found - names.begin());
  }

  Scene scene;
  State state;
  StepWorkspace workspace;
  StepReport report;
};

// The note that holds `part`; its text must be there once.
inline ImportNote note_with(const ImportedScene& imported, const std::string& part) {
  for (const ImportNote& note : imported.notes)
    if (note.text.find(part) != std::string::npos) return note;
  FAIL("no note holds: " + part);
  return {};
}

}  // namespace pabd::test
