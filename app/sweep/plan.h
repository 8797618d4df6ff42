// SPDX-License-Identifier: MIT
// The plan of a sweep: which scene, which parameter sets, what is measured (README.md of this folder).
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/metrics.h"
#include "sim/scene/document.h"
#include "sim/scene/scene.h"

namespace pabd {

inline constexpr std::size_t kMostTasks = 100'000;

// Keys that vary together, and what they go through: one value a key.
struct SweepGroup {
  std::vector<std::string> keys;
  std::vector<std::vector<Json>> points;
};

// Ends a run before its time: the number is below (or above) the bound in all steps of so long.
struct StopWhen {
  const StepNumber* number = nullptr;
  bool below = true;
  double bound = 0;
  double hold = 0;  // s
};

struct StopRule {
  std::optional<double> time;  // s; neither: the duration of the scene, or 5 s
  std::optional<std::int64_t> steps;
  std::optional<StopWhen> when;
};

using KeyValues = std::vector<std::pair<std::string, Json>>;

struct SweepPlan {
  std::string source;           // names it in messages
  std::string text;             // for DIR/plan.json: as read, with the whole path of its scene
  std::string scene_name;       // as the plan says it
  std::filesystem::path scene;  // its file
  KeyValues set;
  std::vector<SweepGroup> groups;
  std::vector<SweepMetric> metrics;
  StopRule stop;
  std::optional<KeyValues> reference;
  bool picture = true;
  std::string measures;  // what the hash of a task holds beside scene and parameters
};

// Finds the file of a shipped scene, or throws Error(file).
using FindScene = std::function<std::filesystem::path(const std::string& name)>;

// Throws Error(bad_input) naming file, JSON pointer, what was expected and what was found; Error(file) when it, or its
// scene, is not there. `folder`: what the path of the scene is relative to.
SweepPlan parse_plan(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                     const FindScene& find_scene);
SweepPlan read_plan(const std::filesystem::path& file, const FindScene& find_scene);

// As --set takes it.
std::vector<std::string> overrides_of(const KeyValues& values);

// Every key of a plan by the object that it belongs to, for the schema's test.
std::vector<std::pair<std::string, std::vector<std::string_view>>> plan_keys();

}  // namespace pabd
