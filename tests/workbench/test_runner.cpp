// SPDX-License-Identifier: MIT
// The simulation's thread: scenes that change on disk, and copies of its runs.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "app/workbench/runner.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_runner {

namespace fs = std::filesystem;

namespace {

const std::string kRunnerScene = places::scenes() + "/two_boxes.json";

// The first snapshot for which it holds; gives up after five minutes.
template <class Holds>
std::shared_ptr<const Snapshot> wait_for(Runner& runner, Holds holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  auto snapshot = runner.latest();
  while (!holds(*snapshot) && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    snapshot = runner.latest();
  }
  return snapshot;
}

// At a time of its own, however coarse the clock of the file system is.
void write(const fs::path& path, const std::string& text) {
  static int times = 0;
  write_bytes(path, text);
  fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(10 * ++times));
}

}  // namespace

TEST_CASE(
    "a scene that changes on disk is told of, and loaded when somebody says so; nothing is lost before") {
  const TempFolder folder;
  const fs::path path = folder / "scene.json";
  const std::string good = read_scene_text(kRunnerScene);
  write(path, good);
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{path.string(), {}, false}));
  runner.send(command::Set{"contact.N", "7"});
  runner.send(command::Step{5});
  const std::uint64_t first = runner.settle()->scene_serial;

  write(path, "{ \"format\": \"pabd-scene\", ");
  auto s = wait_for(runner, [](const Snapshot& x) { return x.file_changed; });
  REQUIRE(s->file_changed);
  CHECK(s->scene_serial == first);
  CHECK(s->a.state->step == 5);
  CHECK(s->messages.empty());
  runner.send(command::Reload{true});
  s = runner.settle();
  REQUIRE_FALSE(s->messages.empty());
  CHECK(s->messages.back().severity == Severity::error);
  CHECK(s->messages.back().about == "reload");
  CHECK_THAT(s->messages.back().text, Catch::Contains(path.string()));
  CHECK(s->a.state->step == 5);

  std::string renamed = good;
  const std::size_t at = renamed.find("two boxes");
  REQUIRE(at != std::string::npos);
  renamed.replace(at, 9, "new boxes");
  write(path, renamed);
  runner.send(command::Reload{true});
  s = runner.settle();
  CHECK(s->scene_serial > first);
  CHECK(s->scene->name == "new boxes");
  CHECK(s->a.params.contact.N == 7);  // what was tuned stays
  CHECK(s->messages.back().severity == Severity::note);
  CHECK_FALSE(s->file_changed);
}

TEST_CASE("commands are carried out, and shown, while it plays") {
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{kRunnerScene, {}, false}));
  runner.send(command::Play{});
  CHECK(runner.settle()->playing);
  runner.send(command::Set{"contact.N", "6"});
  CHECK(runner.settle()->a.params.contact.N == 6);
  runner.send(command::Pause{});
  CHECK_FALSE(runner.settle()->playing);
}

TEST_CASE("copies of the runs are where the runs were, and go on by themselves") {
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{kRunnerScene, {}, false}));
  runner.send(command::Step{10});
  RunCopies alone = runner.copy_runs().get();
  CHECK_FALSE(alone.b);
  CHECK(alone.a.state().step == 10);
  runner.send(command::Compare{{"contact.kappa=50"}});
  runner.send(command::Step{5});
  auto future = runner.copy_runs();
  runner.send(command::Step{-15});
  RunCopies both = future.get();
  CHECK(runner.settle()->a.state->step == 0);
  CHECK(both.a.state().step == 15);
  REQUIRE(both.b);
  CHECK(both.b->state().step == 15);
  CHECK(both.b->params().contact.kappa == 50);
  REQUIRE(both.a.advance());
  CHECK(both.a.state().step == 16);

  std::future<RunCopies> broken;
  {
    Runner short_lived(
        std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{kRunnerScene, {}, false}));
    broken = short_lived.copy_runs();
  }
  try {  // either in time, or never
    const std::int64_t step = broken.get().a.state().step;
    CHECK(step == 0);
  } catch (const std::future_error& error) {
    CHECK(error.code() == std::future_errc::broken_promise);
  }
}

}  // namespace pabd::test_runner
