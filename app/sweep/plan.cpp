// SPDX-License-Identifier: MIT
// See plan.h.
#include "app/sweep/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "app/sweep/plan_groups.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/scene/reader.h"
#include "sim/scene/text.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

using Key = std::string_view;
constexpr std::array kPlan = {Key("$schema"),     Key("format"), Key("version"),   Key("name"),
                              Key("description"), Key("scene"),  Key("set"),       Key("parameters"),
                              Key("metrics"),     Key("stop"),   Key("reference"), Key("accept"),
                              Key("picture")};
constexpr std::array kMetric = {Key("name"), Key("metric"), Key("at"), Key("take")};
constexpr std::array kStop = {Key("time"), Key("steps"), Key("when")};
constexpr std::array kWhen = {Key("at"), Key("below"), Key("above"), Key("for")};

constexpr std::size_t kMostPlanBytes = std::size_t{4} << 20;
constexpr std::size_t kMostMetrics = 100, kMostSet = 1000;
constexpr double kLongest = 1e6;  // s, as of --time
constexpr std::int64_t kMostPlannedSteps = 1'000'000'000;

KeyValues read_values(const ObjectReader& plan, Key key) {
  KeyValues out;
  const auto node = plan.find(key);
  if (!node) return out;
  if (!node->value().is_object()) node->fail_expected("an object of keys and values, {\"contact.N\": 3}");
  if (node->value().size() > kMostSet) node->fail(fmt::format("it has more than {} keys", kMostSet));
  for (const auto& [name, value] : node->value().items()) {
    check_key(Node(value, *node, Key(name)), name);
    out.emplace_back(name, value);
  }
  return out;
}

const StepNumber& read_pointer(const Node& node) {
  const std::string pointer = node.text(200);
  if (const StepNumber* number = find_step_number(pointer)) return *number;
  std::vector<std::string> names;
  for (const StepNumber& number : step_numbers()) names.push_back(fmt::format("/{}", number.name));
  const std::vector<Key> views(names.begin(), names.end());
  node.fail(
      fmt::format("a step's report has no number {}{}", in_quotes(pointer), did_you_mean(pointer, views)));
}

SweepMetric read_metric(const Node& node) {
  const auto known = [](const Node& name) -> const SweepMetric& {
    const std::string word = name.text(100);
    if (const SweepMetric* metric = find_metric(word)) return *metric;
    std::vector<Key> words;
    for (const SweepMetric& metric : built_in_metrics()) words.push_back(metric.name);
    name.fail_expected(one_of(words) + ", or an object with \"name\" and \"at\"");
  };
  if (node.value().is_string()) return known(node);
  const ObjectReader object(node, kMetric);
  if (object.has("metric") == object.has("at"))
    node.fail(
        "expected either \"metric\", the name of one that is built in, or \"at\", a number of a step's "
        "report");
  SweepMetric metric;
  if (object.has("metric")) {
    metric = known(*object.find("metric"));
  } else {
    metric.number = &read_pointer(*object.find("at"));
    metric.name = std::string(metric.number->name);
  }
  if (object.has("name")) metric.name = object.name("name");
  std::vector<Choice> choices;
  for (const Key word : take_words()) choices.push_back({word, static_cast<int>(choices.size())});
  metric.take = static_cast<Take>(object.choice("take", choices, static_cast<int>(metric.take)));
  return metric;
}

std::vector<SweepMetric> read_metrics(const ObjectReader& plan) {
  std::vector<SweepMetric> out;
  const auto node = plan.find("metrics");
  if (!node) {
    for (const SweepMetric& metric : built_in_metrics())
      if (metric.kind != MetricKind::distance || plan.has("reference")) out.push_back(metric);
    return out;
  }
  const std::size_t count = node->array_size();
  if (count > kMostMetrics) node->fail(fmt::format("more than {} metrics", kMostMetrics));
  std::set<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const Node element = node->element(i);
    out.push_back(read_metric(element));
    if (!names.insert(out.back().name).second)
      element.fail(fmt::format("there is a metric {} before it; give it a \"name\" of its own",
                               in_quotes(out.back().name)));
    if (out.back().kind == MetricKind::distance && !plan.has("reference"))
      element.fail("distance is measured to a run that \"reference\" describes, and this plan has none");
  }
  return out;
}

StopWhen read_when(const Node& node) {
  const ObjectReader object(node, kWhen);
  StopWhen when;
  when.number = &read_pointer(object.require("at", "a number of a step's report, \"/kinetic\""));
  if (object.has("below") == object.has("above"))
    node.fail("expected either \"below\" or \"above\", a number");
  when.below = object.has("below");
  when.bound = object.number(when.below ? "below" : "above", Range{});
  when.hold = object.number("for", {0, kLongest, "s"}, 0);
  return when;
}

StopRule read_stop(const ObjectReader& plan) {
  StopRule stop;
  const auto node = plan.find("stop");
  if (!node) return stop;
  const ObjectReader object(*node, kStop);
  if (object.has("time") && object.has("steps")) node->fail("expected \"time\" or \"steps\", not both");
  if (object.has("time")) stop.time = object.number("time", {0, kLongest, "s"});
  if (object.has("steps")) stop.steps = object.integer("steps", 0, kMostPlannedSteps);
  if (const auto when = object.find("when")) stop.when = read_when(*when);
  return stop;
}

// A file beside the plan, or a shipped scene.
fs::path scene_file(const std::string& name, const fs::path& folder, const FindScene& find_scene) {
  std::error_code ignored;
  const fs::path beside = folder / name;
  if (fs::is_regular_file(beside, ignored)) return fs::absolute(beside).lexically_normal();
  return find_scene(name);
}

// Independent of how the plan is written.
std::string measures_of(const SweepPlan& plan) {
  Json json = {{"metrics", Json::array()}, {"reference", nullptr}, {"stop", Json::object()}};
  for (const SweepMetric& metric : plan.metrics) {
    json["metrics"].push_back({{"name", metric.name},
                               {"kind", static_cast<int>(metric.kind)},
                               {"at", metric.number ? Json(metric.number->name) : Json()},
                               {"take", take_words()[static_cast<std::size_t>(metric.take)]}});
  }
  if (plan.reference) {
    json["reference"] = Json::object();
    for (const auto& [key, value] : *plan.reference) json["reference"][key] = canonical(value);
  }
  if (plan.stop.time) json["stop"]["time"] = canonical(*plan.stop.time);
  if (plan.stop.steps) json["stop"]["steps"] = *plan.stop.steps;
  if (const auto& when = plan.stop.when)
    json["stop"]["when"] = {{"at", when->number->name},
                            {"below", when->below},
                            {"bound", canonical(when->bound)},
                            {"for", canonical(when->hold)}};
  if (plan.accept != AcceptanceLimits{}) json["accept"] = to_json(plan.accept);
  return json.dump();
}

// Indented, unless that exceeds the size that is read: lists have one number per line then.
std::string kept_text(const nlohmann::ordered_json& plan, const std::string& source) {
  for (const int indent : {2, -1}) {
    std::string text = plan.dump(indent) + "\n";
    if (text.size() <= kMostPlanBytes) return text;
  }
  throw Error(ErrorKind::bad_input, source,
              fmt::format("is longer than {} MiB with its numbers written out; take fewer or shorter values",
                          kMostPlanBytes >> 20));
}

void check_keys_apart(const SweepPlan& plan, const ObjectReader& reader) {
  std::set<std::string> seen;
  for (const auto& [key, value] : plan.set) seen.insert(key);
  for (const SweepGroup& group : plan.groups) {
    for (const std::string& key : group.keys) {
      if (!seen.insert(key).second)
        reader.fail_key("parameters", fmt::format("{} is set twice; a key may be in \"set\" or once in "
                                                  "\"parameters\"",
                                                  in_quotes(key)));
    }
  }
}

}  // namespace

SweepPlan parse_plan(const std::string& text, const std::string& source, const fs::path& folder,
                     const FindScene& find_scene) {
  ReadContext context{source, {}, {}};
  const Json json = parse_document(text, source, {kMostPlanBytes, std::size_t{1} << 20, 16});
  const ObjectReader reader(Node(json, context), kPlan);
  static constexpr std::array<Choice, 1> kFormat = {{{"pabd-sweep", 0}}};
  reader.choice("format", kFormat);
  reader.integer("version", 1, 1);
  (void)reader.text("$schema", 1000);
  (void)reader.name("name");
  (void)reader.text("description", 1000);

  SweepPlan plan;
  plan.source = source;
  plan.scene_name = reader.require("scene", "a scene file, or the name of a shipped scene").text(4000);
  if (plan.scene_name.empty())
    reader.fail_key("scene", "expected a scene file, or the name of a shipped scene");
  plan.scene = scene_file(plan.scene_name, folder, find_scene);
  plan.set = read_values(reader, "set");
  plan.groups = read_groups(reader);
  check_keys_apart(plan, reader);
  if (reader.has("reference")) plan.reference = read_values(reader, "reference");
  plan.metrics = read_metrics(reader);
  plan.stop = read_stop(reader);
  if (const auto accept = reader.find("accept")) plan.accept = read_limits(*accept);
  plan.picture = reader.boolean("picture", true);
  plan.measures = measures_of(plan);

  nlohmann::ordered_json kept = nlohmann::ordered_json::parse(text);
  kept["scene"] = fs::is_regular_file(folder / plan.scene_name) ? plan.scene.string() : plan.scene_name;
  plan.text = kept_text(kept, source);
  return plan;
}

SweepPlan read_plan(const fs::path& file, const FindScene& find_scene) {
  const std::string text = read_file(file, kMostPlanBytes, "the plan of a sweep");
  return parse_plan(text, file.string(), file.parent_path(), find_scene);
}

std::vector<std::string> overrides_of(const KeyValues& values) {
  std::vector<std::string> out;
  for (const auto& [key, value] : values) out.push_back(key + "=" + value.dump());
  return out;
}

std::vector<PlanObjectKeys> plan_keys() {
  auto out = group_keys();
  out.insert(
      out.end(),
      {{"plan", kPlan}, {"metric", kMetric}, {"stop", kStop}, {"when", kWhen}, {"accept", limit_keys()}});
  return out;
}

}  // namespace pabd
