// SPDX-License-Identifier: MIT
// See opened_sweep.h.
#include "app/gui/opened_sweep.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/workbench/snapshot.h"
#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace pabd {

ShownSweep shown_of(const CollectedSweep& sweep, const command::SweepView& view) {
  ShownSweep out;
  out.grid = grid_of(sweep, view.x, view.y);
  out.criteria = criteria_of(sweep);
  std::vector<std::string_view> names;
  for (const Criterion& criterion : out.criteria) names.push_back(criterion.quantity.key);
  const auto found = std::find(names.begin(), names.end(), view.metric);
  if (!view.metric.empty() && found == names.end())
    throw Error(ErrorKind::bad_input, fmt::format("sweep_view: {} is no metric of this sweep; expected {}",
                                                  in_quotes(view.metric), one_of(names)));
  if (!view.metric.empty()) out.criterion = static_cast<std::size_t>(found - names.begin());
  const auto slices = static_cast<int>(out.grid.slices.size());
  if (view.slice < 0 || view.slice >= slices)
    throw Error(ErrorKind::bad_input,
                fmt::format("sweep_view: \"slice\": expected 0 to {}, got {}", slices - 1, view.slice));
  out.slice = static_cast<std::size_t>(view.slice);
  return out;
}

void take_read(OpenedSweep& sweep, std::shared_ptr<const CollectedSweep> read) {
  const std::string loaded = sweep.loaded && sweep.read ? sweep.read->tasks[*sweep.loaded].hash : "";
  sweep.read = std::move(read);
  sweep.loaded.reset();
  sweep.wanted.reset();
  if (!sweep.read) return;
  const std::vector<SweptTask>& tasks = sweep.read->tasks;
  const auto task =
      std::find_if(tasks.begin(), tasks.end(), [&](const SweptTask& t) { return t.hash == loaded; });
  if (task != tasks.end()) sweep.loaded = static_cast<std::size_t>(task - tasks.begin());
  try {
    shown_of(*sweep.read, sweep.view);
  } catch (const Error&) {  // a slice or a metric that is not there any more
    sweep.view = {};
  }
}

command::Load load_of(OpenedSweep& sweep, const command::LoadRun& run) {
  if (!sweep.read) throw Error(ErrorKind::bad_input, "load_run: no sweep is open; open_sweep opens one");
  const std::vector<SweptTask>& tasks = sweep.read->tasks;
  const auto task =
      std::find_if(tasks.begin(), tasks.end(), [&](const SweptTask& t) { return t.index == run.task; });
  if (task == tasks.end())
    throw Error(ErrorKind::bad_input, fmt::format("load_run: this sweep has no task {}", run.task));
  if (sweep.read->scene.empty())
    throw Error(ErrorKind::bad_input, "load_run: the plan of this sweep names no scene");
  const bool end = run.at == "end";
  if (end && task->end.empty())
    throw Error(ErrorKind::bad_input, fmt::format("load_run: task {} has no file end.json", run.task));
  const std::vector<std::string> sets = settings_of(*sweep.read, *task);
  sweep.wanted = {static_cast<std::size_t>(task - tasks.begin()), sets};
  command::Load load{sweep.read->scene, sets, run.force};
  if (end) load.from = task->end.string();
  return load;
}

void note_loaded(OpenedSweep& sweep, const Snapshot& sim) {
  sweep.loaded.reset();
  if (sweep.wanted && sweep.wanted->sets == sim.scene_sets) sweep.loaded = sweep.wanted->task;
}

}  // namespace pabd
