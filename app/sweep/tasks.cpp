// SPDX-License-Identifier: MIT
// See tasks.h.
#include "app/sweep/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "app/sweep/plan_groups.h"
#include "sim/base/error.h"
#include "sim/base/hash.h"
#include "sim/import/import.h"

namespace pabd {
namespace {

constexpr std::size_t kTried = 16;

std::string hash_of(const SweepPlan& plan, const Scene& base, const KeyValues& parameters,
                    const std::string& program) {
  Json sorted = Json::object();
  for (const auto& [key, value] : parameters) sorted[key] = canonical(value);
  Hash64 hash;
  hash.add_text("pabd-sweep 1");
  if (!program.empty()) hash.add_text(program);
  hash.add_text(base.hash);
  hash.add_number(base.duration.value_or(-1));
  hash.add_text(plan.measures);
  hash.add_text(sorted.dump());
  return hash.hex();
}

Scene load(const SweepPlan& plan, const KeyValues& values, std::vector<ImportNote>* notes = nullptr) {
  std::vector<std::string> overrides = overrides_of(plan.set);
  for (std::string& text : overrides_of(values)) overrides.push_back(std::move(text));
  Scene scene = load_any_scene(plan.scene, overrides, notes);
  if (scene.params.solver.device == SolverDevice::gpu) {
    throw Error(ErrorKind::bad_input, plan.scene_name,
                "solver.device: a sweep makes its steps on the processor; set it to \"cpu\" or \"auto\"");
  }
  return scene;
}

}  // namespace

std::string sweep_program() { return "pabd " PABD_VERSION; }

nlohmann::ordered_json SweepTask::to_json() const {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const auto& [key, value] : parameters) values[key] = value;
  return {{"index", index}, {"hash", hash}, {"program", program}, {"parameters", std::move(values)}};
}

std::string SweepTask::text() const {
  std::string out;
  for (const auto& [key, value] : parameters)
    out +=
        (out.empty() ? "" : " ") + key + "=" + (value.is_string() ? value.get<std::string>() : value.dump());
  return out;
}

std::vector<SweepTask> tasks_of(const SweepPlan& plan, const Scene& base, const std::string& program) {
  std::vector<SweepTask> tasks;
  std::unordered_set<std::string> seen;
  std::vector<std::size_t> at(plan.groups.size(), 0);
  for (bool more = true; more;) {
    SweepTask task;
    for (std::size_t g = 0; g < at.size(); ++g) {
      const SweepGroup& group = plan.groups[g];
      for (std::size_t k = 0; k < group.keys.size(); ++k)
        task.parameters.emplace_back(group.keys[k], group.points[at[g]][k]);
    }
    task.program = program;
    task.hash = hash_of(plan, base, task.parameters, program);
    task.index = tasks.size();
    if (seen.insert(task.hash).second) tasks.push_back(std::move(task));
    more = false;
    for (std::size_t g = at.size(); g-- > 0 && !more;) {
      more = ++at[g] < plan.groups[g].points.size();
      if (!more) at[g] = 0;
    }
  }
  return tasks;
}

Scene base_scene(const SweepPlan& plan, std::vector<ImportNote>* notes) { return load(plan, {}, notes); }
Scene scene_of(const SweepPlan& plan, const SweepTask& task) { return load(plan, task.parameters); }
Scene reference_scene(const SweepPlan& plan) { return load(plan, *plan.reference); }

void check_plan(const SweepPlan& plan, const std::vector<SweepTask>& tasks) {
  const std::size_t count = std::min(tasks.size(), kTried);
  std::optional<Error> first;
  for (std::size_t i = 0; i < count; ++i) {
    try {
      (void)scene_of(plan, tasks[i * tasks.size() / count]);
      return;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::bad_input) throw;
      if (!first) first = error;
    }
  }
  throw Error(ErrorKind::bad_input, plan.source,
              fmt::format("its scene takes none of its tasks: {}", first->what()));
}

}  // namespace pabd
