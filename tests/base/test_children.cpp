// SPDX-License-Identifier: MIT
// Programs that are started: when they end, or are ended, so does all that they started.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "sim/base/child_process.h"
#include "tests/support/running.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_children {

namespace {

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

}  // namespace

TEST_CASE("what a program says comes line by line, and how it ended") {
  std::vector<std::string> lines;
  const auto keep = [&](std::string_view line) { lines.emplace_back(line); };
  ChildOutcome outcome =
      run_child(shell("echo one; echo two; echo hurt >&2; printf three; exit 4"), 60, keep);
  CHECK(outcome.found);
  CHECK(outcome.status == 4);
  CHECK(outcome.errors == "hurt\n");
  CHECK(lines == std::vector<std::string>{"one", "two", "three"});

  lines.clear();
  outcome = run_child(shell("seq 100000; yes complaint | head -c 300000 >&2"), 60, keep);
  CHECK(outcome.status == 0);
  CHECK(lines.size() == 100000);
  CHECK(outcome.errors.size() <= 4096);

  CHECK_FALSE(run_child({"/nonexistent/program"}, 60, keep).found);
  CHECK(run_child(shell("kill -9 $$"), 60, keep).status == -1);
  CHECK(run_child(shell("read line; echo \"got $line\""), 60, keep).status == 0);  // its input is empty
  CHECK(lines.back() == "got ");
}

TEST_CASE("a program that says nothing is ended, with its children") {
  const TempFolder folder;
  const std::string pids = (folder / "pids").string();
  const ChildOutcome outcome =
      run_child(shell("sleep 1000 & echo $! > '" + pids + "'; echo $$ >> '" + pids + "'; sleep 1000"), 0.5,
                [](std::string_view) {});
  CHECK(outcome.too_slow);
  CHECK(all_ended(read_bytes(pids), 2));
}

TEST_CASE("a program that never stops talking is ended after a while") {
  std::size_t lines = 0;
  const ChildOutcome outcome = run_child(
      {"yes"}, 1000, [&](std::string_view) { ++lines; }, 0.2);
  CHECK(outcome.too_slow);
  CHECK(lines > 0);
}

TEST_CASE("a child of the child that holds the output open is not waited for") {
  const TempFolder folder;
  const std::string pids = (folder / "pids").string();
  std::string said;
  const ChildOutcome outcome = run_child(shell("sleep 1000 & echo $! > '" + pids + "'; echo done"), 1000,
                                         [&](std::string_view line) { said += line; });
  CHECK_FALSE(outcome.too_slow);
  CHECK(outcome.status == 0);
  CHECK(said == "done");
  CHECK(all_ended(read_bytes(pids), 1));
}

TEST_CASE("what still runs is among the leftovers") {
  const TempFolder folder;
  const std::string pids = (folder / "pids").string();
  ChildProcess child;
  REQUIRE(child.start(shell("sleep 1000 & echo $! > '" + pids + ".new'; echo $$ >> '" + pids + ".new'; mv '" +
                            pids + ".new' '" + pids + "'; wait")) == 0);
  while (!std::filesystem::exists(pids)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK_FALSE(child.has_ended());
  remove_leftovers();
  CHECK(all_ended(read_bytes(pids), 2));
  while (!child.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK(child.ending() == "signal 9");
  CHECK(child.exit_status() == -1);
}

}  // namespace pabd::test_children
