// SPDX-License-Identifier: MIT
// The plan of a sweep: which scene, which parameter sets, what is measured (README.md of this folder).
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/sweep/acceptance.h"
#include "app/sweep/metrics.h"
#include "sim/scene/document.h"
#include "sim/scene/scene.h"

namespace pabd {

inline constexpr std::size_t kMostTasks = 100'000;

// Keys that vary together, and their values: one point has a value per key.
struct SweepGroup {
  std::vector<std::string> keys;
  std::vector<std::vector<Json>> points;
};

// Ends a run early: when the number was below (or above) the bound for `hold`.
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
  std::string source;           // name for messages
  std::string text;             // for DIR/plan.json: as read, with the whole path of its scene
  std::string scene_name;       // as the plan says it
  std::filesystem::path scene;  // its file
  KeyValues set;
  std::vector<SweepGroup> groups;
  std::vector<SweepMetric> metrics;
  StopRule stop;
  std::optional<KeyValues> reference;
  AcceptanceLimits accept;
  bool picture = true;
  std::string measures;  // part of the hash of a task, beside scene and parameters
};

// Finds the file of a shipped scene, or throws Error(file).
using FindScene = std::function<std::filesystem::path(const std::string& name)>;

// Throws Error(bad_input) naming file, JSON pointer, what was expected and what was found; Error(file) when it or its
// scene does not exist. Paths of scenes are relative to `folder`.
SweepPlan parse_plan(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                     const FindScene& find_scene);
SweepPlan read_plan(const std::filesystem::path& file, const FindScene& find_scene);

// As --set takes it.
std::vector<std::string> overrides_of(const KeyValues& values);

using PlanObjectKeys = std::pair<std::string, std::span<const std::string_view>>;
// All keys of each object of a plan, for the test of the schema.
std::vector<PlanObjectKeys> plan_keys();

}  // namespace pabd
