// SPDX-License-Identifier: MIT
// See collect_sweep.h.
#include "app/sweep/collect_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "app/plots/axis_ticks.h"
#include "app/sweep/collect_read.h"
#include "app/sweep/metrics.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamed = 12;  // tasks that a note names
constexpr std::string_view kProgram = "pabd " PABD_VERSION;

SweptQuantity parameter_named(const std::string& key) {
  const ParameterRow* row = find_parameter(key);
  if (!row) return {key, key, key, ""};
  return {key, row->label, symbol_of(*row), row->unit};
}

// A renamed metric keeps its unit.
SweptQuantity metric_named(const std::string& key, const ReadPlan& plan) {
  const auto planned =
      std::find_if(plan.metrics.begin(), plan.metrics.end(), [&](const auto& m) { return m.name == key; });
  const std::string& is = planned == plan.metrics.end() ? key : planned->known;
  const SweepMetric* known = find_metric(is);
  if (!known) return {key, key, key, ""};
  const std::string words = is == key ? known->words : key;
  return {key, words, words, known->unit};
}

bool is_hash(std::string_view name) {
  return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

struct Folders {
  std::vector<fs::path> tasks, begun, strange;
};

Folders list_tasks(const fs::path& folder, const CollectLimits& limits) {
  Folders found;
  check_link(folder, limits);
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) {
    throw Error(ErrorKind::file, folder.string(),
                fmt::format("cannot be read: {}; expected the tasks of a sweep", error.message()));
  }
  for (std::size_t seen = 0; entries != fs::directory_iterator(); entries.increment(error)) {
    if (++seen > limits.tasks) {
      throw Error(ErrorKind::bad_input, folder.string(),
                  fmt::format("holds more than {} entries, the most that are collected", limits.tasks));
    }
    const std::string name = entries->path().filename().string();
    if (is_hash(name) && (limits.links || !entries->is_symlink(error))) {
      found.tasks.push_back(entries->path());
    } else if (!name.starts_with('.')) {
      found.strange.push_back(entries->path());
    } else if (std::error_code ignored; entries->is_directory(ignored)) {
      found.begun.push_back(entries->path());
    }
  }
  if (error) throw Error(ErrorKind::file, folder.string(), "cannot be read: " + error.message());
  for (auto* list : {&found.tasks, &found.begun, &found.strange}) std::sort(list->begin(), list->end());
  return found;
}

std::vector<std::string> names_of(const std::vector<fs::path>& paths) {
  std::vector<std::string> names;
  for (const fs::path& path : paths) names.push_back(one_line(path.filename().string()));
  return names;
}

// One column for each key of any task: those of the plan in its order, then others by name.
template <class Value, class Name>
std::vector<SweptQuantity> columns_of(const std::vector<ReadTask>& tasks,
                                      std::map<std::string, Value> ReadTask::*members,
                                      const std::vector<std::string>& planned, Name&& name, const char* what,
                                      const CollectLimits& limits) {
  std::set<std::string> keys;
  for (const ReadTask& task : tasks) {
    for (const auto& member : task.*members) keys.insert(member.first);
  }
  if (keys.size() > limits.columns) {
    throw Error(ErrorKind::bad_input,
                fmt::format("the tasks have {} {}; expected at most {}", keys.size(), what, limits.columns));
  }
  std::vector<SweptQuantity> columns;
  for (const std::string& key : planned) {
    if (keys.erase(key) > 0) columns.push_back(name(key));
  }
  for (const std::string& key : keys) columns.push_back(name(key));
  return columns;
}

void note_gaps(CollectedSweep& sweep) {
  std::vector<std::string> missing, twice;
  std::int64_t next = 0, previous = -1, gaps = 0;
  for (const SweptTask& task : sweep.tasks) {
    if (task.index < 0) continue;
    if (task.index == previous) twice.push_back(std::to_string(task.index));
    if (task.index > next) {
      gaps += task.index - next;
      missing.push_back(task.index == next + 1 ? std::to_string(next)
                                               : fmt::format("{} … {}", next, task.index - 1));
    }
    previous = task.index;
    next = task.index + 1;
  }
  if (gaps > 0)
    sweep.notes.push_back(fmt::format("{} missing: {}", counted(gaps, "task"), named(missing, kNamed)));
  if (!twice.empty()) {
    sweep.notes.push_back(
        fmt::format("indices that several tasks have, perhaps of an earlier plan: {}", named(twice, kNamed)));
  }
}

// Removes results of other versions where this one has a result for the same parameters.
void leave_others(std::vector<ReadTask>& tasks, CollectedSweep& sweep) {
  std::set<std::vector<std::pair<std::string, std::string>>> own;
  const auto key = [](const ReadTask& one) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const auto& [name, value] : one.parameters) out.emplace_back(name, value.text);
    return out;
  };
  const auto is_own = [](const ReadTask& one) { return one.task.program == kProgram; };
  for (const ReadTask& one : tasks)
    if (is_own(one) && one.task.status <= SweptStatus::refused) own.insert(key(one));
  const std::size_t replaced =
      std::erase_if(tasks, [&](const ReadTask& one) { return !is_own(one) && own.contains(key(one)); });
  if (replaced > 0)
    sweep.notes.push_back(fmt::format("{} of other versions, which {} made again, left out",
                                      counted(replaced, "result"), kProgram));
  const auto others = static_cast<std::size_t>(
      std::count_if(tasks.begin(), tasks.end(), [&](const ReadTask& one) { return !is_own(one); }));
  if (!own.empty() && others > 0)
    sweep.notes.push_back(
        fmt::format("{} not made by {}, as the others are", counted(others, "task"), kProgram));
}

void note_status(CollectedSweep& sweep, SweptStatus status) {
  std::size_t shown = 0;
  for (const SweptTask& task : sweep.tasks) {
    if (task.status != status || ++shown > kNamed) continue;
    sweep.notes.push_back(fmt::format(
        "task {} is {}: {}", task.index < 0 ? task.hash : fmt::format("{} ({})", task.index, task.hash),
        status_word(status), task.why));
  }
  if (shown > kNamed)
    sweep.notes.push_back(fmt::format("{} more tasks are {}", shown - kNamed, status_word(status)));
}

}  // namespace

bool operator<(const SweptValue& a, const SweptValue& b) {
  const auto order = [](const SweptValue& v) {
    return std::make_tuple(v.absent() ? 2 : v.number ? 0 : 1, v.number.value_or(0));
  };
  return order(a) != order(b) ? order(a) < order(b) : a.text < b.text;
}

std::string_view status_word(SweptStatus status) {
  constexpr std::array<std::string_view, std::size(kSweptStatuses)> kWords = {"done", "diverged", "refused",
                                                                              "unfinished", "damaged"};
  return kWords[static_cast<std::size_t>(status)];
}

std::string SweptQuantity::label() const { return unit.empty() ? words : words + " [" + unit + "]"; }

std::size_t CollectedSweep::count(SweptStatus status) const {
  return static_cast<std::size_t>(
      std::count_if(tasks.begin(), tasks.end(), [&](const SweptTask& t) { return t.status == status; }));
}

CollectedSweep collect_sweep(const fs::path& folder, const CollectLimits& limits) {
  CollectedSweep sweep;
  const ReadPlan plan = read_collected_plan(folder, limits);
  sweep.scene = one_line(plan.scene);
  sweep.set = plan.set;
  sweep.accept = in_words(plan.accept);
  const fs::path whole = fs::absolute(folder).lexically_normal();
  sweep.title = one_line((whole.has_filename() ? whole : whole.parent_path()).filename().string());

  const Folders folders = list_tasks(folder / "tasks", limits);
  std::vector<ReadTask> read;
  for (const fs::path& path : folders.tasks) read.push_back(read_task(path, limits));
  std::stable_sort(read.begin(), read.end(), [](const ReadTask& a, const ReadTask& b) {
    // Tasks without an index come last.
    return std::make_tuple(a.task.index < 0, a.task.index) < std::make_tuple(b.task.index < 0, b.task.index);
  });
  leave_others(read, sweep);
  std::vector<std::string> measured;
  for (const ReadPlan::Metric& metric : plan.metrics) measured.push_back(metric.name);
  sweep.parameters =
      columns_of(read, &ReadTask::parameters, plan.parameters, parameter_named, "parameters", limits);
  sweep.metrics = columns_of(
      read, &ReadTask::metrics, measured, [&](const std::string& key) { return metric_named(key, plan); },
      "metrics", limits);
  for (ReadTask& one : read) {
    for (const SweptQuantity& column : sweep.parameters) {
      const auto value = one.parameters.find(column.key);
      one.task.parameters.push_back(value == one.parameters.end() ? SweptValue{} : value->second);
    }
    for (const SweptQuantity& column : sweep.metrics) {
      const auto value = one.metrics.find(column.key);
      one.task.metrics.push_back(value == one.metrics.end() ? std::nullopt : std::optional(value->second));
    }
    sweep.tasks.push_back(std::move(one.task));
  }

  if (!plan.parameters.empty() && static_cast<double>(sweep.tasks.size()) < plan.combinations) {
    sweep.notes.push_back(
        fmt::format("the plan asks for {} combinations, {} are here", plan.combinations, sweep.tasks.size()));
  }
  if (sweep.tasks.empty()) sweep.notes.push_back("there is no task yet");
  note_gaps(sweep);
  if (!folders.begun.empty()) {
    sweep.notes.push_back(fmt::format("{} begun and not finished: {}", counted(folders.begun.size(), "task"),
                                      named(names_of(folders.begun), kNamed)));
  }
  note_status(sweep, SweptStatus::unfinished);
  note_status(sweep, SweptStatus::damaged);
  if (!folders.strange.empty())
    sweep.notes.push_back("no tasks, passed over: " + named(names_of(folders.strange), kNamed));
  return sweep;
}

std::string scene_of_sweep(const fs::path& folder, const CollectLimits& limits) {
  return one_line(read_collected_plan(folder, limits).scene);
}

std::vector<std::string> settings_of(const CollectedSweep& sweep, const SweptTask& task) {
  std::vector<std::string> out;
  const auto set = [&](const std::string& key, const SweptValue& value) {
    if (!value.absent()) out.push_back(key + "=" + value.text);
  };
  for (const auto& [key, value] : sweep.set) set(key, value);
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) set(sweep.parameters[p].key, task.parameters[p]);
  return out;
}

std::string named(const std::vector<std::string>& names, std::size_t most) {
  std::string out;
  const std::size_t shown = std::min(names.size(), most);
  for (std::size_t i = 0; i < shown; ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  if (shown < names.size()) out += fmt::format(" and {} more", names.size() - shown);
  return out;
}

std::string counts_words(const CollectedSweep& sweep) {
  std::vector<std::string> parts;
  for (const SweptStatus status : kSweptStatuses) {
    const std::size_t n = sweep.count(status);
    if (n == 0) continue;
    const auto faulty = std::count_if(sweep.tasks.begin(), sweep.tasks.end(), [&](const SweptTask& task) {
      return task.status == status && !task.faults.empty();
    });
    parts.push_back(fmt::format("{} {}{}", n, status_word(status),
                                faulty > 0 ? fmt::format(" ({} not acceptable)", faulty) : ""));
  }
  return counted(sweep.tasks.size(), "task") + (parts.empty() ? "" : ": " + named(parts, parts.size()));
}

std::string in_words(double value, const std::string& unit) {
  return unit.empty() ? format_value(value, 3) : format_value(value, 3) + " " + unit;
}

std::string in_words(const CollectedSweep& sweep, const SweptTask& task,
                     const std::vector<std::size_t>& which) {
  std::string out;
  for (const std::size_t p : which) {
    const SweptValue& value = task.parameters[p];
    if (value.absent()) continue;
    const SweptQuantity& column = sweep.parameters[p];
    out += (out.empty() ? "" : ", ") + column.symbol + " = " +
           (value.number ? in_words(*value.number, column.unit) : value.text);
  }
  return out;
}

std::vector<SweptValue> values_of(const CollectedSweep& sweep, std::size_t parameter) {
  std::set<SweptValue> values;
  for (const SweptTask& task : sweep.tasks) {
    if (!task.parameters[parameter].absent()) values.insert(task.parameters[parameter]);
  }
  return {values.begin(), values.end()};
}

std::vector<std::size_t> varied_parameters(const CollectedSweep& sweep) {
  std::vector<std::size_t> varied;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p) {
    const auto first = std::find_if(sweep.tasks.begin(), sweep.tasks.end(),
                                    [&](const SweptTask& t) { return !t.parameters[p].absent(); });
    if (std::any_of(first, sweep.tasks.end(), [&](const SweptTask& t) {
          return !t.parameters[p].absent() && !(t.parameters[p] == first->parameters[p]);
        }))
      varied.push_back(p);
  }
  return varied;
}

std::vector<std::size_t> most_varied(const CollectedSweep& sweep, std::vector<std::size_t> parameters,
                                     std::size_t count) {
  std::stable_sort(parameters.begin(), parameters.end(), [&](std::size_t a, std::size_t b) {
    return values_of(sweep, a).size() > values_of(sweep, b).size();
  });
  parameters.resize(std::min(parameters.size(), count));
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

}  // namespace pabd
