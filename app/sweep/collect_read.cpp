// SPDX-License-Identifier: MIT
// See collect_read.h.
#include "app/sweep/collect_read.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/utf8.h"
#include "sim/scene/document.h"
#include "sim/scene/reader.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostSteps = std::int64_t{1} << 53;
constexpr std::size_t kLongestValue = 1000;  // bytes of a value that is no number
constexpr std::array kStatuses = {Choice{"done", static_cast<int>(SweptStatus::done)},
                                  Choice{"diverged", static_cast<int>(SweptStatus::diverged)},
                                  Choice{"refused", static_cast<int>(SweptStatus::refused)}};

// A file of a task as a JSON object; messages name the file alone, since the task is known.
class TaskFile {
 public:
  TaskFile(const fs::path& folder, const char* name, const CollectLimits& limits)
      : name_(name),
        json_(parse_document(text_of(folder / name, limits), name,
                             {.bytes = limits.bytes, .values = 10000, .depth = 8})) {
    context_.source = name;
    if (!json_.is_object()) root().fail_expected("an object");
  }

  Node root() { return {json_, context_}; }
  bool has(const char* key) const { return json_.contains(key) && !json_[key].is_null(); }
  Node at(const char* key) {
    if (!json_.contains(key)) throw Error(ErrorKind::bad_input, name_, fmt::format("\"{}\" is missing", key));
    return {json_[key], root_, key};
  }

 private:
  std::string text_of(const fs::path& path, const CollectLimits& limits) const {
    check_link(path, limits);
    std::string bytes, problem;
    if (try_read_file(path, limits.bytes, bytes, problem) != ReadOutcome::done)
      throw Error(ErrorKind::file, name_, problem);
    return bytes;
  }

  std::string name_;
  Json json_;
  ReadContext context_;
  Node root_{json_, context_};
};

SweptValue value_of(const Json& json) {
  SweptValue value;
  if (json.is_number()) {
    value.number = json.get<double>();
    value.text = fmt::format("{}", *value.number);  // 1 and 1.0 are one value
    return value;
  }
  // A word without its quotes; one that is empty or would look like another type keeps them.
  const bool word = json.is_string() && !json.get_ref<const std::string&>().empty() &&
                    !Json::accept(json.get_ref<const std::string&>());
  value.text = one_line(word ? json.get<std::string>() : json.dump());
  return value;
}

template <class Take>
void with_member(const Node& object, const char* key, Take&& take) {
  if (!object.value().is_object()) object.fail_expected("an object");
  if (object.value().contains(key) && !object.value()[key].is_null())
    take(Node(object.value()[key], object, key));
}

// An entry of a plan's parameters: {"key", "values"}, {"key", "from", "to", "count"} or {"sample", "count", "keys"}.
void read_entry(const Node& entry, ReadPlan& plan) {
  with_member(entry, "key", [&](const Node& key) { plan.parameters.push_back(key.name()); });
  with_member(entry, "keys", [&](const Node& keys) {
    for (std::size_t i = 0; i < keys.array_size(); ++i) {
      const Node axis = keys.element(i);
      with_member(axis, "key", [&](const Node& key) { plan.parameters.push_back(key.name()); });
    }
  });
  with_member(entry, "values",
              [&](const Node& values) { plan.combinations *= static_cast<double>(values.array_size()); });
  with_member(entry, "count", [&](const Node& count) {
    plan.combinations *= static_cast<double>(count.integer(1, kMostSteps));
  });
}

// The keys are names: 1 to 100 bytes, no control characters.
void check_key(const Node& object, const std::string& key) {
  const Json name = key;
  Node(name, object, key).name();
}

template <class Take>
void each_member(const Node& object, std::size_t most, Take&& take) {
  if (!object.value().is_object()) object.fail_expected("an object");
  if (object.value().size() > most) object.fail(fmt::format("expected at most {} members", most));
  for (const auto& [key, value] : object.value().items()) {
    check_key(object, key);
    take(key, Node(value, object, key));
  }
}

void check_same(TaskFile& file, const SweptTask& task) {
  const std::string hash = file.at("hash").text(100);
  if (hash != task.hash) file.at("hash").fail(fmt::format("expected the name of its folder, {}", task.hash));
  const std::int64_t index = file.at("index").integer(0, kMostSteps);
  if (task.index >= 0 && index != task.index)
    file.at("index").fail(fmt::format("expected {}, as in task.json", task.index));
}

void read_parameters(const fs::path& folder, const CollectLimits& limits, ReadTask& out) {
  TaskFile file(folder, "task.json", limits);
  check_same(file, out.task);
  each_member(file.at("parameters"), limits.columns, [&](const std::string& key, const Node& node) {
    if (node.value().is_null()) node.fail_expected("a value");
    SweptValue value = value_of(node.value());
    if (value.text.size() > kLongestValue) node.fail(fmt::format("expected at most {} bytes", kLongestValue));
    out.parameters.emplace(key, std::move(value));
  });
  if (file.has("program")) out.task.program = one_line(file.at("program").text(100));
  out.task.index = file.at("index").integer(0, kMostSteps);
}

void read_result(const fs::path& folder, const CollectLimits& limits, ReadTask& out) {
  TaskFile file(folder, "result.json", limits);
  check_same(file, out.task);
  SweptTask& task = out.task;
  std::map<std::string, double> metrics;
  if (file.has("metrics")) {
    each_member(file.at("metrics"), limits.columns, [&](const std::string& key, const Node& node) {
      if (!node.value().is_null()) metrics.emplace(key, node.number({}));
    });
  }
  if (file.has("step")) task.step = file.at("step").integer(0, kMostSteps);
  if (file.has("time")) task.time = file.at("time").number({});
  if (file.has("why")) task.why = one_line(file.at("why").text(limits.bytes));
  if (file.has("faults")) task.faults = one_line(file.at("faults").text(limits.bytes));
  task.status = static_cast<SweptStatus>(file.at("status").choice(kStatuses));
  out.metrics = std::move(metrics);
}

void read_timing(const fs::path& folder, const CollectLimits& limits, SweptTask& task) {
  TaskFile file(folder, "timing.json", limits);
  SweptTiming timing;
  const Range positive{0, 1e12};
  timing.seconds = file.at("seconds").number(positive);
  if (file.has("threads")) timing.threads = file.at("threads").integer(0, 1 << 20);
  if (file.has("step_time")) timing.step_time = file.at("step_time").number(positive);
  if (file.has("step_time_noise")) timing.noise = file.at("step_time_noise").number(positive);
  task.timing = timing;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_refused_link(const fs::path& path, const CollectLimits& limits) {
  std::error_code ignored;
  return !limits.links && fs::is_symlink(fs::symlink_status(path, ignored));
}

// A file that is read later; empty: there is none.
fs::path other_file(const fs::path& path, const CollectLimits& limits) {
  return is_file(path) && !is_refused_link(path, limits) ? path : fs::path();
}

}  // namespace

void check_link(const fs::path& path, const CollectLimits& limits) {
  if (is_refused_link(path, limits))
    throw Error(ErrorKind::file, path.filename().string(), "is a link; expected what it names");
}

ReadTask read_task(const fs::path& folder, const CollectLimits& limits) {
  ReadTask out;
  out.task.hash = folder.filename().string();
  try {
    read_parameters(folder, limits, out);
    if (!is_file(folder / "result.json")) {
      out.task.why = "it has no result.json";
      return out;
    }
    read_result(folder, limits, out);
    if (is_file(folder / "timing.json")) read_timing(folder, limits, out.task);
  } catch (const Error& error) {
    // Keeps what was read before: the parameters identify the task.
    out.metrics.clear();
    out.task.status = SweptStatus::damaged;
    out.task.why = error.what();
    out.task.faults.clear();
    out.task.step.reset();
    out.task.time.reset();
  }
  out.task.picture = other_file(folder / "end.png", limits);
  out.task.end = other_file(folder / "end.json", limits);
  return out;
}

ReadPlan read_collected_plan(const fs::path& folder, const CollectLimits& limits) {
  const fs::path path = folder / "plan.json";
  check_link(path, limits);
  const std::string text = read_file(path, limits.plan_bytes,
                                     "the folder of a sweep, with plan.json and tasks", "a plan of a sweep");
  const Json json = parse_document(text, path.string(), {.bytes = limits.plan_bytes, .values = 1 << 20});
  ReadContext context;
  context.source = path.string();
  const Node root(json, context);
  if (!json.is_object()) root.fail_expected("an object: the plan of a sweep");
  ReadPlan plan;
  with_member(root, "scene", [&](const Node& node) { plan.scene = node.text(4096); });
  with_member(root, "set", [&](const Node& node) {
    each_member(node, 1000, [&](const std::string& key, const Node& value) {
      plan.set.emplace(key, value_of(value.value()));
    });
  });
  with_member(root, "accept", [&](const Node& node) { plan.accept = read_limits(node); });
  with_member(root, "parameters", [&](const Node& node) {
    for (std::size_t i = 0; i < node.array_size(); ++i) read_entry(node.element(i), plan);
  });
  with_member(root, "metrics", [&](const Node& node) {
    for (std::size_t i = 0; i < node.array_size(); ++i) {
      const Node metric = node.element(i);
      if (metric.value().is_string()) {
        plan.metrics.push_back({metric.name(), metric.name()});
        continue;
      }
      ReadPlan::Metric one;
      with_member(metric, "metric", [&](const Node& known) { one.known = known.name(); });
      with_member(metric, "name", [&](const Node& name) { one.name = name.name(); });
      plan.metrics.push_back(std::move(one));
    }
  });
  return plan;
}

}  // namespace pabd
