// SPDX-License-Identifier: MIT
// pabd sweep as a user starts it: the same bytes by whatever way, killed, stopped and gone on with.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/sweep/tasks.h"
#include "tests/cli/plan_folder.h"
#include "tests/support/places.h"

namespace pabd::test_cli_sweep {

namespace fs = std::filesystem;
using namespace test;
using Json = nlohmann::json;

TEST_CASE("a sweep makes the same bytes however it is done") {
  const PlanFolder folder;
  REQUIRE(sweep(folder, "one", {"--jobs", "1"}).exit_code == 0);
  const auto expected = results_in(folder / "one");
  // Six tasks: of four task.json, result.json and end.json, of the two refused ones no end.
  CHECK(expected.size() == 4 * 3 + 2 * 2);
  check_whole(folder / "one");

  CHECK(sweep(folder, "again", {"--jobs", "1"}).exit_code == 0);
  CHECK(sweep(folder, "two", {"--jobs", "2"}).exit_code == 0);
  CHECK(sweep(folder, "threads", {"--jobs", "1", "--threads", "3"}).exit_code == 0);
  for (int i = 5; i >= 0; --i) CHECK(sweep(folder, "tasks", {"--task", std::to_string(i)}).exit_code == 0);
  for (int i = 0; i < 2; ++i)
    CHECK(sweep(folder, "chunks", {"--chunk", "4", "--task", std::to_string(i)}).exit_code == 0);
  for (int i = 0; i < 6; ++i) {
    CHECK(sweep(folder, "slurm", {}, {{{"SLURM_ARRAY_TASK_ID", std::to_string(i)}}, {}, {}}).exit_code == 0);
    CHECK(sweep(folder, "parallel", {}, {{{"PARALLEL_SEQ", std::to_string(i + 1)}}, {}, {}}).exit_code == 0);
  }
  for (const char* rank : {"0", "1"})
    CHECK(sweep(folder, "mpi", {}, {{{"OMPI_COMM_WORLD_RANK", rank}, {"OMPI_COMM_WORLD_SIZE", "2"}}, {}, {}})
              .exit_code == 0);
  for (const char* other : {"again", "two", "threads", "tasks", "chunks", "slurm", "parallel", "mpi"}) {
    CAPTURE(other);
    CHECK(results_in(folder / other) == expected);
    check_whole(folder / other);
    CHECK(read_text(folder / (other + std::string("/plan.json"))) == read_text(folder / "one/plan.json"));
  }
}

TEST_CASE("the list says what each task is, and its folder holds it") {
  const PlanFolder folder;
  const Outcome text = run_pabd({"sweep", folder / "plan.json", "--list"});
  CHECK(text.exit_code == 0);
  CHECK(lines_of(text.out).at(4) == "4\tcontact.N=3 contact.d_hat=0.02");
  const Outcome list = run_pabd({"sweep", folder / "plan.json", "--list", "--json"});
  REQUIRE(sweep(folder, "out").exit_code == 0);
  const auto lines = lines_of(list.out);
  REQUIRE(lines.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const Json task = Json::parse(lines[i]);
    CHECK(task["index"] == i);
    const fs::path place = fs::path(folder / "out") / "tasks" / task["hash"].get<std::string>();
    CHECK(Json::parse(read_text(place / "task.json")) == task);
    const Json result = Json::parse(read_text(place / "result.json"));
    const Json timing = Json::parse(read_text(place / "timing.json"));
    const bool refused = task["parameters"]["contact.d_hat"] == -1;
    CHECK(result["index"] == i);
    CHECK(result["status"] == (refused ? "refused" : "done"));
    CHECK(result.contains("why") == refused);
    CHECK(result["step"] == (refused ? 0 : 20));
    CHECK(result["metrics"].contains("penetration") != refused);
    CHECK_FALSE(result["metrics"].contains("step_time"));
    CHECK(timing["threads"] == 1);
    CHECK(fs::exists(place / "end.json") != refused);
  }
}

TEST_CASE("the end of a task is what pabd run comes to") {
  const PlanFolder folder;
  REQUIRE(sweep(folder, "out", {"--task", "1"}).exit_code == 0);
  const Outcome run = run_pabd({"run", "two_boxes", "--steps", "20", "--set", "contact.N=2", "--set",
                                "contact.d_hat=0.02", "--quiet", "--state", folder / "end.json"});
  REQUIRE(run.exit_code == 0);
  for (const auto& entry : fs::directory_iterator(folder / "out/tasks"))
    CHECK(read_text(entry.path() / "end.json") == read_text(folder / "end.json"));
}

TEST_CASE("what is done is skipped, and stays when the plan grows") {
  const PlanFolder folder;
  REQUIRE(sweep(folder, "out").exit_code == 0);
  const auto before = results_in(folder / "out");
  const auto made = fs::last_write_time(fs::path(folder / "out") / "tasks" / before.begin()->first);
  CHECK(sweep(folder, "out").exit_code == 0);
  CHECK(fs::last_write_time(fs::path(folder / "out") / "tasks" / before.begin()->first) == made);

  std::string grown = plan_text();
  grown.replace(grown.find("[2, 3]"), 6, "[1, 2, 3]");
  write_text(folder / "plan.json", grown);
  const Outcome refused = sweep(folder, "out");
  CHECK(refused.exit_code == 2);
  CHECK(is_error_line(refused.err, {"another plan", "--force"}));
  CHECK(results_in(folder / "out") == before);
  REQUIRE(sweep(folder, "out", {"--force"}).exit_code == 0);
  REQUIRE(sweep(folder, "new").exit_code == 0);
  CHECK(done_in(folder / "out") == 9);
  // Their numbers are those of the new plan. Refused ones tell the same, whatever they were before.
  CHECK(results_in(folder / "out") == results_in(folder / "new"));
}

TEST_CASE("what another version of the program did is made again, and a note says so") {
  const PlanFolder folder;
  REQUIRE(sweep(folder, "out").exit_code == 0);
  const auto own = results_in(folder / "out");
  const SweepPlan plan = read_plan(folder / "out/plan.json", [](const std::string& name) {
    return fs::path(places::scenes()) / (name + ".json");
  });
  const auto theirs = tasks_of(plan, base_scene(plan), "pabd 0.0.1");
  const auto tasks = tasks_of(plan, base_scene(plan));
  const auto place = [&](const SweepTask& task) { return fs::path(folder / "out") / "tasks" / task.hash; };
  for (const SweepTask& task : theirs) {
    fs::rename(place(tasks[task.index]), place(task));
    write_text(place(task) / "task.json", task.to_json().dump());
    Json result = Json::parse(read_text(place(task) / "result.json"));
    result["hash"] = task.hash;
    write_text(place(task) / "result.json", result.dump());
  }
  const auto make = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"sweep", folder / "plan.json", "-o", folder / "out"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code == 0);
    return outcome.err;
  };
  CHECK_THAT(make({"--task", "1"}),
             Catch::Contains("note: 1 task was done by pabd 0.0.1, and is made again by " + sweep_program()));
  CHECK_THAT(make({}), Catch::Contains("note: 5 tasks were done by pabd 0.0.1, and are made again"));
  CHECK_THAT(make({}), Catch::Contains("6 done before") && !Catch::Contains("note:"));
  for (const auto& [path, bytes] : own) CHECK(results_in(folder / "out").at(path) == bytes);
  CHECK(done_in(folder / "out") == 12);

  // Each task is in the table once.
  const Outcome collected = run_pabd({"sweep", "collect", folder / "out"});
  CHECK_THAT(collected.err, Catch::Contains("6 results of other versions, which " + sweep_program() +
                                            " made again, left out"));
  const auto rows = lines_of(read_text(folder / "out/collected/table.csv"));
  CHECK(rows.size() == 7);
  for (const SweepTask& task : tasks)
    CHECK_THAT(rows.at(1 + task.index), Catch::StartsWith(std::to_string(task.index) + "," + task.hash));

  fs::remove_all(place(tasks[2]));
  const Outcome mixed = run_pabd({"sweep", "collect", folder / "out", "-o", folder / "mixed"});
  CHECK_THAT(mixed.err, Catch::Contains("1 task not made by " + sweep_program() + ", as the others are"));
}

TEST_CASE("killed at any time, a sweep goes on to the same bytes") {
  const PlanFolder folder = steps_planned(400);
  REQUIRE(sweep(folder, "whole", {"--jobs", "1"}).exit_code == 0);
  int killed = 0;
  for (int i = 0; i < 12; ++i) {
    RunningPabd program(
        {"sweep", folder / "plan.json", "-o", folder / "out", "--quiet", "--jobs", i % 2 ? "2" : "1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 37 * i % 150));
    program.signal(SIGKILL);
    killed += program.wait().exit_code == 128 + SIGKILL ? 1 : 0;
  }
  CHECK(killed > 0);
  REQUIRE(sweep(folder, "out", {"--jobs", "2"}).exit_code == 0);
  CHECK(results_in(folder / "out") == results_in(folder / "whole"));
  check_whole(folder / "out");
}

TEST_CASE("a process of the pool that is killed is replaced") {
  const PlanFolder folder = steps_planned(40000);
  REQUIRE(sweep(folder, "whole", {"--jobs", "1"}).exit_code == 0);
  // Kills whoever does a task, as soon as there is one, twice: the third time would be too often for one task.
  const Outcome outcome = run_shell(
      "\"" + places::program() + "\" sweep \"" + folder / "plan.json" + "\" -o \"" + folder / "out" +
      "\" --quiet --jobs 2 & pool=$!\nn=0\n"
      "for i in 1 2; do\n"
      "  until worker=$(ps -o pid=,stat= --ppid $pool | awk '$2 !~ /Z/ { print $1; exit }'); "
      "[ -n \"$worker\" ]; do\n"
      "    kill -0 $pool || break; sleep 0.01; done\n"
      "  sleep 0.1; kill -9 $worker && n=$((n + 1))\ndone\n"
      "wait $pool || exit\n[ $n -gt 0 ] || { echo nobody was killed >&2; exit 1; }");
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(results_in(folder / "out") == results_in(folder / "whole"));
  check_whole(folder / "out");
}

TEST_CASE("SIGTERM leaves checkpoints and is exit code 75; the same command goes on to the same bytes") {
  // A task takes a second or more, so that this process may come late to it.
  const PlanFolder folder = steps_planned(80000);
  REQUIRE(sweep(folder, "whole", {"--jobs", "2"}).exit_code == 0);
  for (const char* jobs : {"1", "2"}) {
    CAPTURE(jobs);
    const std::string out = std::string("out_") + jobs;
    RunningPabd program({"sweep", folder / "plan.json", "-o", folder / out, "--jobs", jobs});
    program.wait_until([&](const std::string&) { return done_in(folder / out) > 0; });
    std::this_thread::sleep_for(std::chrono::milliseconds(30));  // into the next one
    program.signal(SIGTERM);
    const Outcome stopped = program.wait();
    CAPTURE(stopped.err);
    CHECK(stopped.exit_code == 75);
    CHECK(stopped.err.find("the same command goes on") != std::string::npos);
    CHECK(done_in(folder / out) < 6);
    std::size_t checkpoints = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(folder / out) / "tasks"))
      checkpoints += fs::exists(entry.path() / "checkpoint.json") ? 1 : 0;
    CHECK(checkpoints > 0);
    REQUIRE(sweep(folder, out, {"--jobs", jobs}).exit_code == 0);
    CHECK(results_in(folder / out) == results_in(folder / "whole"));
    check_whole(folder / out);
  }
}

TEST_CASE("the job of Slurm has itself queued again, however soon its program ends") {
  for (const char* late : {"", "[ \"$1\" = -0 ] && sleep 1; "}) {
    CAPTURE(late);
    const PlanFolder folder = steps_planned(80000);
    REQUIRE(sweep(folder, "out", {"--emit", "slurm"}).exit_code == 0);
    // A program of Slurm's, a word when the job waits, and a shell that is late to ask whether there still is something
    // to wait for.
    write_text(folder / "env.sh", std::string("scontrol() { echo \"$@\" >> asked; }\n"
                                              "wait() { > waiting; builtin wait \"$@\"; }\nkill() { ") +
                                      late + "builtin kill \"$@\"; }\n");
    const Outcome job = run_shell(
        "BASH_ENV=env.sh SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=0 bash out/sweep.sbatch & job=$!\n"
        "until [ -e waiting ] && [ -e out/tasks/.*.lock ]; do sleep 0.01; done\n"
        "kill -TERM $job\nwait $job",
        {{}, folder.path(), {}});
    CAPTURE(job.err);
    CHECK(job.exit_code == 75);
    CHECK(read_text(folder / "asked") == "requeue 7_0\n");
  }
}

TEST_CASE("two commands on one folder share out the work") {
  const PlanFolder folder = steps_planned(400);
  RunningPabd other({"sweep", folder / "plan.json", "-o", folder / "out", "--quiet", "--jobs", "2"});
  CHECK(sweep(folder, "out", {"--jobs", "1"}).exit_code == 0);
  CHECK(other.wait().exit_code == 0);
  REQUIRE(sweep(folder, "whole", {"--jobs", "1"}).exit_code == 0);
  CHECK(results_in(folder / "out") == results_in(folder / "whole"));
  check_whole(folder / "out");
}

TEST_CASE("divergence is a result") {
  // The log barrier has no force for boxes that start inside each other.
  const CommandFolder folder;
  write_text(folder / "plan.json",
             R"({"format": "pabd-sweep", "version": 1, "scene": "two_boxes", "picture": false,
    "stop": {"steps": 30}, "metrics": ["penetration"],
    "parameters": [{"key": "contact.barrier", "values": ["polynomial", "log"]}]})");
  const Outcome outcome = sweep(folder, "out");
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  std::map<std::string, int> statuses;
  for (const auto& [path, text] : results_in(folder / "out")) {
    if (path.find("result.json") == std::string::npos) continue;
    const Json result = Json::parse(text);
    ++statuses[result["status"]];
    if (result["status"] == "diverged")
      CHECK(result["why"].get<std::string>().find("all bounds") != std::string::npos);
  }
  CHECK(statuses["diverged"] == 1);
  CHECK(statuses["done"] == 1);
}

TEST_CASE("each end has its picture") {
  const PlanFolder folder = with_pictures();
  REQUIRE(sweep(folder, "one", {"--jobs", "1"}).exit_code == 0);
  REQUIRE(sweep(folder, "two", {"--jobs", "2"}).exit_code == 0);
  std::size_t pictures = 0;
  for (const auto& [path, bytes] : results_in(folder / "one")) {
    if (path.find("end.png") == std::string::npos) continue;
    ++pictures;
    // The size in a PNG's header: 320×180.
    CHECK(bytes.substr(16, 8) == std::string("\0\0\1\x40\0\0\0\xb4", 8));
  }
  CHECK(pictures == 4);
  CHECK(results_in(folder / "one") == results_in(folder / "two"));
}

TEST_CASE("without OpenGL there are no pictures, and a note") {
  const PlanFolder folder = with_pictures();
  const Setting broken{{{"GALLIUM_DRIVER", "none"},
                        {"MESA_LOADER_DRIVER_OVERRIDE", "none"},
                        {"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"},
                        {"LD_PRELOAD", ""},
                        {"MESA_GL_VERSION_OVERRIDE", "2.1"}},
                       {},
                       {}};
  const Outcome outcome =
      run_pabd({"sweep", folder / "plan.json", "-o", folder / "out", "--jobs", "2"}, broken);
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.find("note: no pictures of the ends") != std::string::npos);
  CHECK(done_in(folder / "out") == 6);
  for (const auto& [path, bytes] : results_in(folder / "out"))
    CHECK(path.find("end.png") == std::string::npos);
}

TEST_CASE("the window opens the folder of a sweep, and its runs are those of the sweep") {
  const PlanFolder folder;
  REQUIRE(sweep(folder, "out").exit_code == 0);
  write_text(folder / "look.json", R"([{"do": "expect", "at": "/sweep/done", "is": 4},
    {"do": "expect", "at": "/sweep/refused", "is": 2}, {"do": "expect", "at": "/scene/name", "is": "two boxes"},
    {"do": "load_run", "task": 4}, {"do": "step", "steps": 20}, {"do": "print", "at": "/a/hash"},
    {"do": "load_run", "task": 4, "at": "end"}, {"do": "print", "at": "/a/hash"},
    {"do": "load_run", "task": 5, "may_fail": true}, {"do": "expect", "at": "/message", "contains": "d_hat"}])");
  const Outcome view = run_pabd({"view", folder / "out", "--script", folder / "look.json", "--headless"});
  CAPTURE(view.err);
  REQUIRE(view.exit_code == 0);
  const Outcome run = run_pabd({"run", "two_boxes", "--steps", "20", "--set", "contact.N=3", "--set",
                                "contact.d_hat=0.02", "--quiet", "--json"});
  const std::string line = "/a/hash \"" + Json::parse(run.out)["state"].get<std::string>() + "\"";
  CHECK(lines_of(view.out) == std::vector<std::string>{line, line});

  // A scene that is not on this machine leaves the sweep to be looked at.
  Json plan = Json::parse(read_text(folder / "out/plan.json"));
  plan["scene"] = "/nowhere/scene.json";
  write_text(folder / "out/plan.json", plan.dump());
  write_text(folder / "look.json", R"([{"do": "expect", "at": "/sweep/done", "is": 4},
    {"do": "load_run", "task": 4, "may_fail": true}, {"do": "expect", "at": "/message", "contains": "/nowhere"}])");
  CHECK(run_pabd({"view", folder / "out", "--script", folder / "look.json", "--headless"}).exit_code == 0);
}

TEST_CASE("what is wrong with the command or the plan is exit code 2 and leaves nothing") {
  const PlanFolder folder;
  write_text(folder / "typo.json", R"({"format": "pabd-sweep", "version": 1, "scene": "two_boxes",
    "parameters": [{"key": "contact.d_hatt", "values": [1, 2]}]})");
  const auto check = [&](const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
    std::vector<std::string> command = {"sweep"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_pabd(command);
    CAPTURE(arguments, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(is_error_line(outcome.err, words));
  };
  const std::string plan = folder / "plan.json", out = folder / "out";
  check({plan}, {"-o DIR", "--list"});
  check({plan, "-o", out, "--task", "6"}, {"--task 6", "6 tasks"});
  check({plan, "-o", out, "--task", "x"}, {"--task x"});
  check({plan, "-o", out, "--chunk", "4", "--task", "2"}, {"2 chunks of 4"});
  check({plan, "-o", out, "--emit", "lsf"}, {"--emit", "slurm"});
  check({folder / "typo.json", "-o", out}, {"typo.json", "none of its tasks", "d_hatt"});
  check({folder / "typo.json", "--list"}, {"d_hatt"});
  CHECK(folder.names() == std::vector<std::string>{"plan.json", "typo.json"});
  CHECK(run_pabd({"sweep", folder / "none.json", "--list"}).exit_code == 3);
}

}  // namespace pabd::test_cli_sweep
