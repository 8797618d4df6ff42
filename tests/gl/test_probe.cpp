// SPDX-License-Identifier: MIT
// Drivers that crash, leave or say no when they are asked for a context: found out in another process.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "render/context/probe.h"
#include "sim/base/child_process.h"
#include "tests/support/places.h"

namespace pabd::test_probe {

namespace {

using List = std::vector<std::string>;

// "name: failure" of each attempt.
List probed(List families) {
  families.insert(families.begin(), places::fake_drivers());
  families.push_back("--");
  List out;
  for (const ContextAttempt& attempt : probe_contexts(families))
    out.push_back(attempt.name + ": " + attempt.failure);
  return out;
}

}  // namespace

TEST_CASE("candidates are tried in order, past those that crash, to the first that works") {
  CHECK(probed({"x:works,segv"}) == List{"works: "});
  CHECK(probed({"x:no,segv,nay,abrt", "y:leaves,works,bus"}) ==
        List{"no: not\\ntoday", "segv: the driver crashed (signal 11)", "nay: not\\ntoday",
             "abrt: the driver crashed (signal 6)", "leaves: the driver ended the process", "works: "});
}

TEST_CASE("when none works every one says why, and this process lives") {
  CHECK(probed({"x:segv", "y:no"}) == List{"segv: the driver crashed (signal 11)", "no: not\\ntoday"});
}

TEST_CASE("a library that crashes when it is asked what there is") {
  CHECK(probed({"x:crashes", "y:works"}) == List{"x: the driver crashed (signal 7)", "works: "});
  CHECK(probed({"y:no", "x:crashes"}) == List{"no: not\\ntoday", "x: the driver crashed (signal 7)"});
}

TEST_CASE("where no program tries contexts, or it is another one, nothing is known") {
  CHECK(probe_contexts({}).empty());
  CHECK(probe_contexts({"/nonexistent/program"}).empty());
  CHECK(probe_contexts({"/bin/true"}).empty());
}

TEST_CASE("who tries contexts for somebody that is killed ends with him") {
  ChildProcess shell;
  // The shell says the number of the process that tries a driver that never answers, and waits for it.
  REQUIRE(shell.start({"/bin/sh", "-c", "\"$0\" x:stays & echo $!; wait", places::fake_drivers()}) == 0);
  std::string number(16, '\0');
  const ssize_t n = read_some(shell.output.get(), number.data(), number.size());
  REQUIRE(n > 1);
  const auto pid = static_cast<pid_t>(std::stol(number));
  const std::filesystem::path program = "/proc/" + std::to_string(pid) + "/exe";
  const auto alive = [&] {
    return std::filesystem::exists(program);
  };                                                            // false of what nobody has waited for, too
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // until it is one that tries
  REQUIRE(alive());
  shell.signal(SIGKILL);  // the shell alone
  for (int k = 0; k < 200 && alive(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK_FALSE(alive());
  ::kill(pid, SIGKILL);
}

}  // namespace pabd::test_probe
