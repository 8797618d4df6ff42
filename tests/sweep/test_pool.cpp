// SPDX-License-Identifier: MIT
// Processes side by side: who is asked to end, how often, and what of it is a failure. The processes are shells.
#include <catch2/catch.hpp>
#include <set>

#include "app/sweep/pool.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_pool {

namespace {

PoolOptions shells(const std::string& script, int processes) {
  PoolOptions options;
  options.worker = {"sh", "-c", script};
  options.processes = processes;
  return options;
}

}  // namespace

TEST_CASE("each task is done by one process, and all of them come to an end") {
  std::multiset<std::size_t> done;
  PoolOptions options = shells("while read task; do echo $task done; done", 3);
  options.ended = [&](std::size_t task, TaskEnding ending) {
    CHECK(ending == TaskEnding::done);
    done.insert(task);
  };
  const PoolOutcome outcome = run_pool({0, 1, 2, 3, 4, 5, 6}, options);
  CHECK(done == std::multiset<std::size_t>{0, 1, 2, 3, 4, 5, 6});
  CHECK_FALSE(outcome.stopped);
  CHECK(outcome.failure == 0);
}

TEST_CASE("a process that was asked to end before it could write a checkpoint is no failure") {
  const TempFolder folder;
  // SIGTERM for all: the process has ended by it before this one is asked whether it was stopped.
  PoolOptions options = shells("read task; > '" + (folder / "ended").string() + "'; exit 143", 1);
  options.stopped = {75, 143};
  int later = 0;
  options.stop = [&] { return std::filesystem::exists(folder / "ended") && ++later > 5; };
  const PoolOutcome outcome = run_pool({0, 1}, options);
  CHECK(outcome.stopped);
  CHECK(outcome.failure == 0);
  options.stopped = {75};
  options.stop = {};
  CHECK(run_pool({0, 1}, options).failure == 143);
}

TEST_CASE("when several fail, the others are asked to end once, so that they can write their checkpoints") {
  const TempFolder folder;
  // 0 fails when all have begun, 1 when it is asked to end, and 2 counts how often it is asked in the next second.
  const PoolOptions options =
      shells("cd '" + folder.path().string() + "'\nread task\ncase $task in\n" +
                 "0) until [ -e ready_1 ] && [ -e ready_2 ]; do sleep 0.01; done; echo first >&2; exit 3 ;;\n"
                 "1) trap 'sleep 0.2; echo second >&2; exit 4' TERM ;;\n"
                 "2) trap 'echo asked >> asked; asked=1' TERM ;;\n"
                 "esac\n> ready_$task\n"
                 "while [ -z \"$asked\" ]; do sleep 0.02; done\n"
                 "for i in 1 2 3 4 5 6 7 8 9 10; do sleep 0.1; done\nexit 75\n",
             3);
  const PoolOutcome outcome = run_pool({0, 1, 2}, options);
  CHECK(outcome.failure == 3);
  CHECK(outcome.message == "first\n");
  CHECK_FALSE(outcome.stopped);
  CHECK(read_bytes(folder / "asked") == "asked\n");
}

}  // namespace pabd::test_pool
