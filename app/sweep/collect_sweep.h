// SPDX-License-Identifier: MIT
// The folder of a sweep, read: every task with its parameters, its status and its metrics.
//
//   DIR/plan.json                     the plan: scene, and the order of parameters and metrics
//   DIR/tasks/HASH/task.json          {"index", "hash", "parameters"}
//   DIR/tasks/HASH/result.json        {"index", "hash", "status", "why", "faults", "metrics", "step", "time"}
//   DIR/tasks/HASH/timing.json        {"seconds", "threads", "step_time", "step_time_noise"}; may be absent
//   DIR/tasks/HASH/end.json           the state at the end; may be absent, and is not read here
//   DIR/tasks/HASH/end.png            what it looked like at the end; may be absent
//   DIR/tasks/.HASH.partial/          a task that has begun
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pabd {

// A parameter's value: a number, or anything else as JSON (a word without quotes). Empty text: the task has none.
struct SweptValue {
  std::optional<double> number;
  std::string text;

  bool absent() const { return text.empty(); }
  bool operator==(const SweptValue& other) const { return text == other.text; }
};
// Numbers by size, then texts by their bytes, then absent values.
bool operator<(const SweptValue& a, const SweptValue& b);

// unfinished: without a result; damaged: a file cannot be read or contradicts another.
enum class SweptStatus : std::uint8_t { done, diverged, refused, unfinished, damaged };
inline constexpr SweptStatus kSweptStatuses[] = {SweptStatus::done, SweptStatus::diverged,
                                                 SweptStatus::refused, SweptStatus::unfinished,
                                                 SweptStatus::damaged};
std::string_view status_word(SweptStatus status);

struct SweptTiming {
  double seconds = 0;  // wall clock of the task
  std::int64_t threads = 0;
  std::optional<double> step_time;  // ms
  std::optional<double> noise;      // of it; ms
};

struct SweptTask {
  std::int64_t index = -1;             // −1: unknown
  std::string hash;                    // name of its folder
  std::string program;                 // that made it; empty: unknown
  std::vector<SweptValue> parameters;  // one per CollectedSweep::parameters
  SweptStatus status = SweptStatus::unfinished;
  std::string why;                             // of any other status than done; one line
  std::string faults;                          // of a done task; empty: acceptable
  std::vector<std::optional<double>> metrics;  // one per CollectedSweep::metrics
  std::optional<std::int64_t> step;
  std::optional<double> time;  // simulated, s
  std::optional<SweptTiming> timing;
  std::filesystem::path picture, end;  // of its end; empty: there is no such file
};

// A column and its names.
struct SweptQuantity {
  std::string key;     // "contact.d_hat", "penetration"
  std::string words;   // rich text: "thickness d̂", "penetration"
  std::string symbol;  // short, for lists of values: "d̂"
  std::string unit;    // SI; empty: none

  std::string label() const;  // "thickness d̂ [m]"
};

struct CollectedSweep {
  std::string title;                               // the name of the folder
  std::string scene;                               // as the plan names it; may be empty
  std::map<std::string, SweptValue> set;           // what the plan sets in all runs
  std::string accept;                              // what is acceptable, in words
  std::vector<SweptQuantity> parameters, metrics;  // in the plan's order, then by name
  std::vector<SweptTask> tasks;                    // by index, then hash
  std::vector<std::string> notes;                  // a line each: missing, unexpected or damaged files

  std::size_t count(SweptStatus status) const;
};

// Larger sweeps are refused.
struct CollectLimits {
  std::size_t tasks = 100000;
  std::size_t columns = 64;     // of parameters, and of metrics
  std::size_t bytes = 1 << 20;  // of a file of a task
  std::size_t plan_bytes = 16 << 20;
  bool links = true;  // whether links are followed; if not, they count as damaged
};

// Throws Error(file) if the folder is no sweep or cannot be read, Error(bad_input) if its plan is no JSON object
// or the limits are exceeded. A fault of one task is its status and a note.
CollectedSweep collect_sweep(const std::filesystem::path& folder, const CollectLimits& limits = {});

// The scene that a folder's plan names; may be empty. Throws as collect_sweep does.
std::string scene_of_sweep(const std::filesystem::path& folder, const CollectLimits& limits = {});

// The settings of a task, as for --set: "contact.kappa=50".
std::vector<std::string> settings_of(const CollectedSweep& sweep, const SweptTask& task);

// "a, b, c and 4 more", after `most` names.
std::string named(const std::vector<std::string>& names, std::size_t most);

// "20 tasks: 17 done (3 not acceptable), 2 diverged and 1 refused".
std::string counts_words(const CollectedSweep& sweep);

// A number with its unit, for people: "1.2·10⁻⁵ m".
std::string in_words(double value, const std::string& unit);
// "d̂ = 0.01 m, κ = 50 J": the parameters `which` of the task.
std::string in_words(const CollectedSweep& sweep, const SweptTask& task,
                     const std::vector<std::size_t>& which);

// The values of a parameter that occur, ascending.
std::vector<SweptValue> values_of(const CollectedSweep& sweep, std::size_t parameter);
// The parameters with several values.
std::vector<std::size_t> varied_parameters(const CollectedSweep& sweep);
// Of `parameters` the `count` with the most values, in the plan's order.
std::vector<std::size_t> most_varied(const CollectedSweep& sweep, std::vector<std::size_t> parameters,
                                     std::size_t count);

}  // namespace pabd
