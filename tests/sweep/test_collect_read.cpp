// SPDX-License-Identifier: MIT
// What a sweep left is read whole: nothing is dropped, nothing damaged is taken.
#include <catch2/catch.hpp>

#include "app/sweep/collect_sweep.h"
#include "tests/support/errors.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_collect_read {

using namespace test;

namespace {

bool notes_say(const CollectedSweep& sweep, const std::string& part) {
  for (const std::string& note : sweep.notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

void spoil(const SweptFolder& folder, int index, const std::string& file, const std::string& text) {
  write_bytes(folder.task_folder(index) / file, text);
}

}  // namespace

TEST_CASE("tasks come by their index, with the columns in the plan's order") {
  const SweptFolder folder(
      R"({"scene": "/a/pyramid.json", "set": {"solver.max_iterations": 20},
          "parameters": [{"key": "contact.kappa", "values": [1, 2]}, {"key": "contact.d_hat", "values": [0.1]}],
          "metrics": ["step_time", "penetration", {"name": "worst", "metric": "drift", "take": "mean"}]})");
  folder.add({.index = 1,
              .parameters = {{"contact.d_hat", "0.1"}, {"contact.kappa", "2"}},
              .metrics = {{"penetration", "2e-4"}, {"worst", "null"}, {"beyond", "3"}}});
  folder.add({.index = 0,
              .parameters = {{"contact.d_hat", "0.1"}, {"contact.kappa", "1.0"}},
              .metrics = {{"penetration", "1e-4"}, {"worst", "5"}},
              .step_time = 0.5});
  const CollectedSweep sweep = collect_sweep(folder.path());
  CHECK(sweep.notes.empty());
  CHECK(sweep.scene == "/a/pyramid.json");
  REQUIRE(sweep.set.size() == 1);
  CHECK(sweep.set.at("solver.max_iterations").text == "20");
  REQUIRE(sweep.parameters.size() == 2);
  CHECK(sweep.parameters[0].key == "contact.kappa");
  CHECK(sweep.parameters[1].label() == "thickness d\u0302 [m]");
  REQUIRE(sweep.metrics.size() == 3);
  CHECK(sweep.metrics[0].label() == "penetration [m]");
  CHECK(sweep.metrics[1].label() == "worst [m]");  // a drift by another name
  CHECK(sweep.metrics[2].key == "beyond");
  REQUIRE(sweep.tasks.size() == 2);
  CHECK(sweep.tasks[0].index == 0);
  CHECK(sweep.tasks[0].parameters[0].text == "1");  // 1.0 and 1 are one value
  CHECK(*sweep.tasks[0].metrics[1] == 5);
  CHECK_FALSE(sweep.tasks[0].metrics[2].has_value());
  CHECK_FALSE(sweep.tasks[1].metrics[1].has_value());
  REQUIRE(sweep.tasks[0].timing);
  CHECK(*sweep.tasks[0].timing->step_time == 0.5);
  CHECK_FALSE(sweep.tasks[1].timing);
  CHECK(varied_parameters(sweep) == std::vector<std::size_t>{0});
  CHECK(counts_words(sweep) == "2 tasks: 2 done");
}

TEST_CASE("what is missing, begun or strange is counted and named") {
  const SweptFolder folder(
      R"({"parameters": [{"key": "contact.N", "values": [1, 2, 3, 4, 5, 6, 7, 8, 9]}]})");
  for (const int index : {1, 4, 5})
    folder.add({.index = index, .parameters = {{"contact.N", std::to_string(index)}}});
  std::filesystem::create_directory(folder.path() / "tasks/.0123456789abcdef.partial");
  write_bytes(folder.path() / "tasks/.0123456789abcdef.lock", "");
  write_bytes(folder.path() / "tasks/notes.txt", "");
  std::filesystem::remove(folder.task_folder(5) / "result.json");
  const CollectedSweep sweep = collect_sweep(folder.path());
  CHECK(notes_say(sweep, "the plan asks for 9 combinations, 3 are here"));
  CHECK(notes_say(sweep, "3 tasks missing: 0 and 2 … 3"));
  CHECK(notes_say(sweep, "1 task begun and not finished: .0123456789abcdef.partial"));
  CHECK(notes_say(sweep, "task 5 (" + SweptFolder::hash_of(5) + ") is unfinished: it has no result.json"));
  CHECK(notes_say(sweep, "passed over: notes.txt"));
  CHECK(sweep.notes.size() == 5);
  CHECK(counts_words(sweep) == "3 tasks: 2 done and 1 unfinished");
}

TEST_CASE("a damaged task stays in the table, and one line says what is wrong with it") {
  struct Case {
    const char *file, *text, *says;
  };
  const std::string head = "{\"index\":0,\"hash\":\"" + SweptFolder::hash_of(0) + "\",";
  const std::string deep = std::string(2000, '[') + std::string(2000, ']');
  const std::string twice = head + "\"status\":\"done\",\"status\":\"done\"}";
  const std::string huge = head + "\"status\":\"done\",\"metrics\":{\"penetration\":1e999}}";
  const std::string text = head + "\"status\":\"done\",\"metrics\":{\"penetration\":\"1\"}}";
  const std::string word = head + "\"status\":\"fine\"}";
  const std::string late = head + "\"status\":\"done\",\"step\":-1}";
  const std::string other = "{\"index\":1,\"hash\":\"" + SweptFolder::hash_of(0) + "\",\"status\":\"done\"}";
  const std::string foreign = "{\"index\":0,\"hash\":\"00\",\"status\":\"done\"}";
  const std::string none = head + "\"metrics\":{}}";
  const std::string key = head + "\"status\":\"done\",\"metrics\":{\"a\\nb\":1}}";
  const std::string negative = "{\"seconds\":-1}";
  const std::vector<Case> cases = {{"result.json", "", "line 1"},
                                   {"result.json", "{\"index\":0,", "line 1"},
                                   {"result.json", "[1]", "an object"},
                                   {"result.json", deep.c_str(), "deep"},
                                   {"result.json", twice.c_str(), "twice"},
                                   {"result.json", huge.c_str(), "1e999"},
                                   {"result.json", text.c_str(), "/metrics/penetration"},
                                   {"result.json", word.c_str(), "\"done\", \"diverged\" or \"refused\""},
                                   {"result.json", late.c_str(), "/step"},
                                   {"result.json", other.c_str(), "as in task.json"},
                                   {"result.json", foreign.c_str(), "the name of its folder"},
                                   {"result.json", none.c_str(), "\"status\" is missing"},
                                   {"result.json", key.c_str(), "without control characters"},
                                   {"task.json", "{}", "\"hash\" is missing"},
                                   {"task.json", "\xff\xfe", ""},
                                   {"timing.json", negative.c_str(), "/seconds"}};
  for (const Case& one : cases) {
    CAPTURE(one.file, one.text);
    const SweptFolder folder;
    folder.add({.index = 0, .parameters = {{"contact.N", "2"}}, .metrics = {{"penetration", "1"}}});
    folder.add({.index = 1, .parameters = {{"contact.N", "3"}}, .metrics = {{"penetration", "1"}}});
    spoil(folder, 0, one.file, one.text);
    const CollectedSweep sweep = collect_sweep(folder.path());
    REQUIRE(sweep.tasks.size() == 2);
    CHECK(sweep.count(SweptStatus::done) == 1);
    CHECK(sweep.count(SweptStatus::damaged) == 1);
    const SweptTask& damaged = sweep.tasks[sweep.tasks[0].status == SweptStatus::damaged ? 0 : 1];
    CHECK(damaged.hash == SweptFolder::hash_of(0));
    CHECK(damaged.why.starts_with(one.file));
    CHECK(damaged.why.find(one.says) != std::string::npos);
    CHECK(damaged.why.find('\n') == std::string::npos);
    CHECK(damaged.why.size() < 300);
    CHECK_FALSE(damaged.metrics[0].has_value());
    CHECK(notes_say(sweep, "is damaged: " + damaged.why));
  }
}

TEST_CASE("where links are not taken nothing is read through one") {
  CollectLimits limits;
  limits.links = false;
  const SweptFolder outside;
  outside.add({.index = 0, .parameters = {{"contact.N", "2"}}, .picture = fake_picture(0)});
  const SweptFolder folder;
  for (const int index : {0, 1, 2})
    folder.add({.index = index, .parameters = {{"contact.N", "2"}}, .picture = fake_picture(0)});
  const auto put = [&](const std::filesystem::path& from, const std::filesystem::path& to) {
    std::filesystem::remove_all(to);
    std::filesystem::create_symlink(from, to);
  };
  put(outside.task_folder(0) / "result.json", folder.task_folder(0) / "result.json");
  put(outside.task_folder(0) / "end.png", folder.task_folder(1) / "end.png");
  put(outside.task_folder(0), folder.task_folder(2));
  CHECK(collect_sweep(folder.path()).tasks.size() == 3);
  const CollectedSweep sweep = collect_sweep(folder.path(), limits);
  REQUIRE(sweep.tasks.size() == 2);
  CHECK(sweep.tasks[0].status == SweptStatus::damaged);
  CHECK(sweep.tasks[0].why.find("is a link") != std::string::npos);
  CHECK(sweep.tasks[1].status == SweptStatus::done);
  CHECK(sweep.tasks[1].picture.empty());
  put(outside.path() / "plan.json", folder.path() / "plan.json");
  CHECK(caught([&] { collect_sweep(folder.path(), limits); }).says("is a link"));
}

TEST_CASE("no sweep, a hostile plan or too much of everything is refused in one line") {
  const TempFolder empty;
  const Caught nothing = caught([&] { collect_sweep(empty.path()); });
  CHECK(nothing.kind == ErrorKind::file);
  CHECK(nothing.says("plan.json"));
  for (const char* plan :
       {"", "[]", "{\"scene\": 1}", "{\"parameters\": 1}", "{\"parameters\": [{\"key\": \"\"}]}",
        "{\"metrics\": [{\"name\": 7}]}", "{\"a\": 1, \"a\": 2}"}) {
    CAPTURE(plan);
    const SweptFolder folder(plan);
    const Caught refused = caught([&] { collect_sweep(folder.path()); });
    CHECK(refused.kind == ErrorKind::bad_input);
    CHECK(refused.text.find('\n') == std::string::npos);
    CHECK(refused.says("plan.json"));
  }
  const SweptFolder folder;
  for (int i = 0; i < 3; ++i) folder.add({.index = i, .parameters = {{"k" + std::to_string(i), "1"}}});
  CHECK(caught([&] { collect_sweep(folder.path(), {.tasks = 2}); }).says("more than 2 entries"));
  CHECK(
      caught([&] { collect_sweep(folder.path(), {.columns = 2}); }).says("3 parameters; expected at most 2"));
  CHECK(collect_sweep(folder.path(), {.bytes = 20}).count(SweptStatus::damaged) == 3);
}

}  // namespace pabd::test_collect_read
