// SPDX-License-Identifier: MIT
// Plans are read or refused at their place, and always mean the same tasks.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/sweep/tasks.h"
#include "sim/base/error.h"
#include "tests/support/files.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_plan {

namespace {

const std::filesystem::path kAssets = places::assets();

std::filesystem::path shipped(const std::string& name) {
  const auto path = kAssets / "scenes" / (name + ".json");
  if (!std::filesystem::exists(path)) throw Error(ErrorKind::file, name, "there is no such scene");
  return path;
}

SweepPlan plan_of(const std::string& members) {
  return parse_plan(R"({"format": "pabd-sweep", "version": 1, "scene": "two_boxes", )" + members + "}",
                    "plan.json", "/nowhere", shipped);
}

std::vector<SweepTask> tasks(const SweepPlan& plan) { return tasks_of(plan, base_scene(plan)); }
std::vector<SweepTask> tasks(const std::string& members) { return tasks(plan_of(members)); }

std::vector<std::string> texts(const std::vector<SweepTask>& tasks) {
  std::vector<std::string> out;
  for (const SweepTask& task : tasks) out.push_back(task.text());
  return out;
}

const std::string kList = R"("parameters": [{"key": "contact.N", "values": [3]}])";

// Refused as bad input, with all of these words.
void check_refused(const std::string& members, const std::vector<std::string>& words) {
  CAPTURE(members);
  try {
    (void)plan_of(members);
    FAIL("it was taken");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    for (const std::string& word : words) {
      CAPTURE(error.what(), word);
      CHECK(std::string(error.what()).find(word) != std::string::npos);
    }
  }
}

}  // namespace

TEST_CASE("tasks are all combinations, the last entry varies fastest") {
  const auto all = tasks(R"("parameters": [{"key": "contact.N", "values": [1, 2]},
                            {"key": "contact.kappa", "from": 1, "to": 100, "count": 3, "scale": "log"}])");
  CHECK(texts(all) == std::vector<std::string>{"contact.N=1 contact.kappa=1", "contact.N=1 contact.kappa=10",
                                               "contact.N=1 contact.kappa=100", "contact.N=2 contact.kappa=1",
                                               "contact.N=2 contact.kappa=10",
                                               "contact.N=2 contact.kappa=100"});
  std::set<std::string> hashes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].index == i);
    CHECK(all[i].hash.size() == 16);
    CHECK(hashes.insert(all[i].hash).second);
  }
  CHECK(all[3].to_json().dump() == R"({"index":3,"hash":")" + all[3].hash + R"(","program":")" +
                                       sweep_program() +
                                       R"(","parameters":{"contact.N":2,"contact.kappa":1}})");
}

TEST_CASE("the hash of a task tells what it computes, not how the plan was written") {
  const std::string one = tasks(kList).at(0).hash;
  CHECK(tasks(R"("name": "x", "picture": false, "parameters": [{"key": "contact.N", "values": [3.0]}])")
            .at(0)
            .hash == one);
  CHECK(tasks(R"("parameters": [{"key": "contact.N", "from": 3, "to": 5, "count": 3}])").at(0).hash == one);
  CHECK(tasks(R"("accept": {"drift": 0.1}, )" + kList).at(0).hash == one);
  CHECK(tasks(R"("parameters": [{"key": "contact.N", "values": [1, 3]}])").at(1).hash == one);
  for (const char* other :
       {R"("set": {"time_step": 0.01})", R"("stop": {"steps": 3})", R"("metrics": ["drift"])",
        R"("accept": {"overlap": 0.2})", R"("reference": {"time_step": 0.001}, "metrics": ["distance"])"})
    CHECK(tasks(std::string(other) + ", " + kList).at(0).hash != one);
  CHECK(tasks(R"("parameters": [{"key": "contact.N", "values": [4]}])").at(0).hash != one);
  const SweepPlan plan = plan_of(kList);
  CHECK(tasks_of(plan, base_scene(plan), sweep_program()).at(0).hash == one);
  std::set<std::string> hashes = {one};
  for (const char* program : {"", "pabd 0.0.1", "pabd 0.0.2"})
    CHECK(hashes.insert(tasks_of(plan, base_scene(plan), program).at(0).hash).second);
}

TEST_CASE("what comes out twice is one task") {
  const auto all = tasks(R"("parameters": [{"key": "contact.N", "values": [2, 3, 2.0]}])");
  CHECK(texts(all) == std::vector<std::string>{"contact.N=2", "contact.N=3"});
  CHECK(all[1].index == 1);
}

TEST_CASE("samples fill their ranges, and are the same for the same seed") {
  for (const std::string kind : {"sobol", "latin_hypercube"}) {
    const std::string members =
        R"("parameters": [{"sample": ")" + kind + R"(", "count": 16, "seed": 5, "keys": [
      {"key": "contact.d_hat", "from": 0.001, "to": 0.1, "scale": "log"},
      {"key": "contact.N", "from": 1, "to": 4, "whole": true},
      {"key": "solver.method", "values": ["sissm", "descent"]}]}])";
    const SweepPlan plan = plan_of(members);
    const auto all = tasks(plan);
    REQUIRE(all.size() == 16);
    std::map<std::int64_t, int> of_N;
    std::map<std::string, int> of_method;
    for (const SweepTask& task : all) {
      const double d_hat = task.parameters[0].second.get<double>();
      CHECK((d_hat >= 0.001 && d_hat <= 0.1));
      ++of_N[task.parameters[1].second.get<std::int64_t>()];
      ++of_method[task.parameters[2].second.get<std::string>()];
    }
    CHECK(of_N == std::map<std::int64_t, int>{{1, 4}, {2, 4}, {3, 4}, {4, 4}});
    CHECK(of_method == std::map<std::string, int>{{"descent", 8}, {"sissm", 8}});
    CHECK(texts(tasks(members)) == texts(all));
  }
}

TEST_CASE("any place of a scene is a key, generators too") {
  const SweepPlan plan = parse_plan(R"({"format": "pabd-sweep", "version": 1, "scene": "pyramid",
    "parameters": [{"key": "generate.0.base", "values": [2, 3, 4]}]})",
                                    "plan.json", "/nowhere", shipped);
  const auto all = tasks(plan);
  std::vector<Index> bodies;
  for (const SweepTask& task : all) bodies.push_back(scene_of(plan, task).model.size());
  // A pyramid of base n has n(n+1)/2 bricks more than the rest.
  CHECK(bodies[1] - bodies[0] == 3);
  CHECK(bodies[2] - bodies[1] == 4);
}

TEST_CASE("the scene of a plan may be a robot") {
  const TempFolder folder;
  write_bytes(folder / "ball.xml",
              "<mujoco><worldbody><geom type=\"plane\"/><body name=\"ball\" pos=\"0 0 1\"><freejoint/>"
              "<geom size=\"0.1\"/></body></worldbody></mujoco>");
  const SweepPlan plan =
      parse_plan(R"({"format": "pabd-sweep", "version": 1, "scene": "ball.xml", )" + kList + "}", "plan.json",
                 folder.path(), shipped);
  const Scene scene = scene_of(plan, tasks(plan).at(0));
  CHECK(scene.params.contact.N == 3);
  CHECK(std::count(scene.model.name.begin(), scene.model.name.end(), "ball") == 1);
}

TEST_CASE("the plan that is kept means the same when it is read again, however long it is") {
  const auto kept = [](const std::string& values) {
    return plan_of(R"("parameters": [{"key": "gravity", "values": [)" + values + "]}]");
  };
  const auto again = [](const SweepPlan& plan) { return parse_plan(plan.text, "kept.json", "/", shipped); };
  const SweepPlan small = kept("[0, -9.81, 0], [0, -1.62, 0]");
  CHECK(std::count(small.text.begin(), small.text.end(), '\n') > 10);  // for people
  CHECK(again(small).text == small.text);
  // A line a number would be more than a plan may have.
  std::string values = "[0,1,0]";
  for (int i = 0; i < 79999; ++i) values += ",[0,1,0]";
  const SweepPlan large = kept(values);
  const SweepPlan read = again(large);
  CHECK(read.text == large.text);
  REQUIRE(read.groups.size() == 1);
  CHECK(read.groups[0].points.size() == 80000);
  // Numbers that are longer in the text that is kept.
  values = "[1e9,1e9,1e9,1e9,1e9,1e9,1e9,1e9,1e9]";
  const std::string one = "," + values;
  for (int i = 0; i < 89999; ++i) values += one;
  try {
    (void)kept(values);
    FAIL("it was taken");
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::Contains("plan.json") && Catch::Contains("4 MiB"));
  }
}

TEST_CASE("a plan that does not fit is refused at its place") {
  const auto parameters = [](const std::string& entry) { return R"("parameters": [)" + entry + "]"; };
  check_refused(R"("sede": 1, )" + kList, {"plan.json", "sede"});
  check_refused("\"name\": \"x\"", {"/parameters"});
  check_refused(R"("parameters": [])", {"/parameters", "1 to 100"});
  check_refused(parameters("3"), {"/parameters/0", "\"key\""});
  check_refused(parameters(R"({"key": "contact.N"})"), {"/parameters/0", "from"});
  check_refused(parameters(R"({"key": "contact.N", "values": []})"), {"/parameters/0/values"});
  check_refused(parameters(R"({"key": "", "values": [1]})"), {"/parameters/0/key"});
  check_refused(parameters(R"({"key": "a=b", "values": [1]})"), {"/parameters/0/key"});
  check_refused(parameters(R"({"key": "contact.N", "from": 0, "to": 3, "count": 3, "scale": "log"})"),
                {"/parameters/0/from"});
  check_refused(parameters(R"({"key": "contact.N", "from": 1, "to": 3, "count": 0})"),
                {"/parameters/0/count"});
  check_refused(parameters(R"({"key": "contact.N", "from": 1, "to": 2.5, "count": 3, "whole": true})"),
                {"whole"});
  check_refused(parameters(R"({"key": "contact.N", "from": 1, "to": 2, "count": 3, "scale": "cubic"})"),
                {"/parameters/0/scale"});
  check_refused(parameters(R"({"sample": "halton", "count": 4, "keys": []})"),
                {"/parameters/0/sample", "sobol"});
  check_refused(parameters(R"({"sample": "sobol", "count": 4, "keys": []})"), {"/parameters/0/keys"});
  check_refused(
      parameters(
          R"({"sample": "sobol", "count": 4, "seed": -1, "keys": [{"key": "contact.N", "values": [1]}]})"),
      {"/parameters/0/seed"});
  check_refused(parameters(R"({"key": "contact.N", "from": 1, "to": 2, "count": 400},
                              {"key": "contact.kappa", "from": 1, "to": 2, "count": 400})"),
                {"100000"});
  check_refused(R"("set": {"contact.N": 2}, )" + kList, {"contact.N", "twice"});
  check_refused(R"("set": [1], )" + kList, {"/set"});
  check_refused(R"("metrics": ["penetratoin"], )" + kList, {"/metrics/0", "penetration"});
  check_refused(R"("metrics": ["drift", "drift"], )" + kList, {"/metrics/1", "drift"});
  check_refused(R"("metrics": ["distance"], )" + kList, {"/metrics/0", "reference"});
  check_refused(R"("metrics": [{"at": "/contact"}], )" + kList, {"/metrics/0/at", "/contacts"});
  check_refused(R"("metrics": [{"at": "/contacts", "take": "median"}], )" + kList, {"/metrics/0/take"});
  check_refused(R"("metrics": [{"name": "x"}], )" + kList, {"/metrics/0", "\"at\""});
  check_refused(R"("stop": {"time": 1, "steps": 2}, )" + kList, {"/stop"});
  check_refused(R"("stop": {"time": -1}, )" + kList, {"/stop/time"});
  check_refused(R"("stop": {"when": {"at": "/kinetic"}}, )" + kList, {"/stop/when", "below"});
  check_refused(R"("accept": {"unsolved": 1.5}, )" + kList, {"/accept/unsolved", "from 0 to 1"});
  check_refused(R"("accept": {"overlaps": 1}, )" + kList, {"/accept/overlaps", "\"overlap\""});
  CHECK_THROWS_AS(parse_plan(R"({"format": "pabd-sweep", "version": 2})", "p", "/", shipped), Error);
  CHECK_THROWS_AS(parse_plan("[1, 2", "p", "/", shipped), Error);
  CHECK_THROWS_AS(parse_plan(R"({"format": "pabd-sweep", "version": 1, "scene": "none", )" + kList + "}", "p",
                             "/", shipped),
                  Error);
}

TEST_CASE("a plan none of whose tasks the scene takes is wrong itself") {
  const SweepPlan typo = plan_of(R"("parameters": [{"key": "contact.d_hatt", "values": [1, 2]}])");
  CHECK_THROWS_WITH(check_plan(typo, tasks(typo)),
                    Catch::Contains("none of its tasks") && Catch::Contains("d_hatt"));
  // One that it takes is enough: the others are results.
  const SweepPlan some = plan_of(R"("parameters": [{"key": "contact.d_hat", "values": [-1, 0.01]}])");
  CHECK_NOTHROW(check_plan(some, tasks(some)));
}

// The list of pointers in the text of the schema is written by the program.
std::string with_pointers(std::string schema) {
  std::string list, line;
  for (const StepNumber& number : step_numbers()) {
    const std::string word = fmt::format("\"/{}\"", number.name);
    if (line.size() + word.size() > 100) list += std::exchange(line, "") + ",\n        ";
    line += (line.empty() ? "" : ", ") + word;
  }
  list += line;
  const std::string before = "\"at\": {\n      \"enum\": [";
  const std::size_t from = schema.find(before) + before.size();
  return schema.replace(from, schema.find(']', from) - from, list);
}

TEST_CASE("the schema has the keys that the reader knows, and describes each") {
  std::string text = read_bytes(kAssets / "pabd-sweep.schema.json");
  if (std::getenv("PABD_UPDATE_GOLDEN")) {
    text = with_pointers(text);
    write_bytes(kAssets / "pabd-sweep.schema.json", text);
  }
  INFO("PABD_UPDATE_GOLDEN=1 writes the list of pointers anew");
  CHECK(text == with_pointers(text));
  const auto schema = nlohmann::json::parse(text);
  for (const auto& [object, known] : plan_keys()) {
    CAPTURE(object);
    const auto& properties =
        object == "plan" ? schema.at("properties") : schema.at("$defs").at(object).at("properties");
    std::set<std::string> named, expected(known.begin(), known.end());
    for (const auto& [key, value] : properties.items()) {
      CAPTURE(key);
      named.insert(key);
      const bool refers = value.contains("$ref");
      const auto& described = refers && !value.contains("description")
                                  ? schema.at("$defs").at(value["$ref"].get<std::string>().substr(8))
                                  : value;
      CHECK(described.contains("description"));
    }
    CHECK(named == expected);
  }
  std::set<std::string> metrics;
  for (const SweepMetric& metric : built_in_metrics()) metrics.insert(metric.name);
  CHECK(schema["$defs"]["metric_name"]["enum"].get<std::set<std::string>>() == metrics);
}

}  // namespace pabd::test_plan
