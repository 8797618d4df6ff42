// SPDX-License-Identifier: MIT
// A device beside the processor on the desk: what is refused, what is told, and that everything else goes on.
#include <catch2/catch.hpp>

#include "app/workbench/runner.h"
#include "tests/support/drift_device.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_devices {

using namespace test;

namespace {

const std::string kTwoBoxes = places::scenes() + "/two_boxes.json",
                  kBridge = places::scenes() + "/bridge.json";

Workbench with_device(const std::shared_ptr<DriftDevices>& devices, const std::vector<std::string>& sets) {
  WorkbenchOptions options;
  options.devices = devices;
  return Workbench(options, command::Load{kTwoBoxes, sets, false});
}

}  // namespace

TEST_CASE("a scene that the device does not take is refused, and the one before stays") {
  const auto devices = std::make_shared<DriftDevices>();
  Workbench bench = with_device(devices, {"solver.device=gpu"});
  CHECK(bench.snapshot().a.device.name == "drift");
  const std::string why = refusal(bench, command::Load{kBridge, {"solver.device=gpu"}, true});
  CHECK(why.find("bridge.json: drift knows no joints") != std::string::npos);
  CHECK(bench.snapshot().scene_path == kTwoBoxes);
  CHECK(refusal(bench, command::Load{kBridge, {"solver.device=auto"}, true}).empty());
  CHECK(bench.snapshot().a.device == DeviceStatus{"", "drift knows no joints"});
  // Where nothing is offered nobody asks.
  CHECK_NOTHROW(Workbench({}, command::Load{kBridge, {"solver.device=gpu"}, false}));
}

TEST_CASE("a device that cannot be is refused as a value, and nothing has changed") {
  const auto devices = std::make_shared<DriftDevices>();
  WorkbenchOptions options;
  options.devices = devices;
  Workbench bench(options, command::Load{kBridge, {}, false});
  CHECK(refusal(bench, command::Set{"solver.device", "gpu"}).find("solver.device: drift knows no joints") ==
        0);
  CHECK(bench.run().params().solver.device == SolverDevice::cpu);
  CHECK_FALSE(bench.snapshot().can_undo);
  CHECK(refusal(bench, command::Compare{{"solver.device=gpu"}}).find("knows no joints") != std::string::npos);
  CHECK_FALSE(bench.comparing());
}

TEST_CASE("an edit that the device does not take is told, once, and undone it is the device's again") {
  const auto devices = std::make_shared<DriftDevices>();
  Workbench bench = with_device(devices, {"solver.device=gpu"});
  for (int k = 0; k < 5; ++k) REQUIRE(bench.advance());
  CHECK(bench.snapshot().messages.empty());
  bench.apply(
      command::Edit{R"({"do": "add_joint", "type": "spherical", "bodies": [1, null], "anchor": [0, 1, 0]})"});
  for (int k = 0; k < 5; ++k) REQUIRE(bench.advance());
  Snapshot s = bench.snapshot();
  REQUIRE(s.messages.size() == 1);
  CHECK(s.messages[0].severity == Severity::warning);
  CHECK(s.messages[0].text == "the processor makes the steps: drift knows no joints");
  CHECK(s.a.device.name.empty());
  bench.apply(command::Undo{});
  CHECK(bench.run().state().step == 5);
  REQUIRE(bench.advance());
  s = bench.snapshot();
  CHECK(s.a.device.name == "drift");
  CHECK(devices->newest->steps == 1);
}

TEST_CASE("each of two simulations goes by its own parameters") {
  const auto devices = std::make_shared<DriftDevices>();
  Workbench bench = with_device(devices, {"solver.device=gpu"});
  REQUIRE(bench.advance());
  bench.apply(command::Compare{{"solver.device=cpu"}});
  for (int k = 0; k < 4; ++k) REQUIRE(bench.advance());
  CHECK(devices->newest->steps == 5);
  Snapshot s = bench.snapshot();
  CHECK(s.a.device.name == "drift");
  CHECK(s.b->device == DeviceStatus{});
  CHECK(s.a.state->step == s.b->state->step);
  CHECK(s.a.state->c[1] != s.b->state->c[1]);
  bench.apply(command::Set{"solver.device", "gpu", Side::b});
  REQUIRE(bench.advance());
  CHECK(devices->opened == 2);
  const std::weak_ptr<DriftEngine> of_b = devices->newest;
  devices->newest.reset();
  bench.apply(command::EndCompare{});
  CHECK(of_b.expired());  // nobody needs it
  bench.apply(command::Undo{});
  REQUIRE(bench.advance());
  CHECK(bench.snapshot().b->device.name == "drift");
}

TEST_CASE("a change in the past leaves the device where it is wanted, undone as well") {
  const auto devices = std::make_shared<DriftDevices>();
  Workbench bench = with_device(devices, {"solver.device=gpu"});
  for (int k = 0; k < 10; ++k) REQUIRE(bench.advance());
  bench.apply(command::Step{-6});
  CHECK(bench.run().state().step == 4);
  bench.apply(command::Set{"contact.N", "7"});
  for (int k = 0; k < 3; ++k) REQUIRE(bench.advance());
  CHECK(bench.run().state().step == 7);
  CHECK(devices->opened == 1);
  bench.apply(command::Undo{});
  for (int k = 0; k < 3; ++k) REQUIRE(bench.advance());
  CHECK(devices->opened == 1);
  CHECK(bench.run().params().contact.N != 7);
}

TEST_CASE("a state and a recording that are saved are whole") {
  const TempFolder folder;
  const auto devices = std::make_shared<DriftDevices>();
  WorkbenchOptions options;
  options.devices = devices;
  options.memory = 3000;
  Workbench bench(options, command::Load{kTwoBoxes, {"solver.device=gpu"}, false});
  for (int k = 0; k < 101; ++k) REQUIRE(bench.advance());
  CHECK(bench.snapshot().a.gone > 0);
  bench.apply(command::SaveRecording{(folder / "r.rec").string(), false});
  CHECK(bench.run().state().contacts.size() == 1);
  const State end = bench.run().state();
  REQUIRE(bench.advance());
  bench.apply(command::LoadRecording{(folder / "r.rec").string(), true});
  CHECK(same_bits(bench.run().state(), end));
  CHECK(bench.snapshot().messages.back().severity == Severity::note);
  REQUIRE(bench.advance());
  CHECK(bench.run().device().name == "drift");
}

TEST_CASE("the simulation's thread makes the steps on the device, and copies are whole") {
  const auto devices = std::make_shared<DriftDevices>();
  WorkbenchOptions options;
  options.devices = devices;
  Runner runner(std::make_unique<Workbench>(options, command::Load{kTwoBoxes, {"solver.device=gpu"}, false}));
  runner.send(command::Step{7});
  RunCopies copies = runner.copy_runs().get();
  CHECK(copies.a.state().step == 7);
  CHECK(copies.a.state().contacts.size() == 1);
  copies.a.seek(3);
  CHECK(copies.a.state().step == 3);
  CHECK(runner.settle()->a.state->step == 7);
}

TEST_CASE("while it plays bodies stay on a device where nobody asks for states; at rest they are there") {
  const auto devices = std::make_shared<DriftDevices>();
  devices->draws = true;
  WorkbenchOptions options;
  options.devices = devices;
  options.memory = 3000;
  Workbench bench(options, command::Load{kTwoBoxes, {"solver.device=gpu"}, false});
  const auto stays = [&] {
    bool all = true;
    for (int k = 0; k < 9; ++k) {
      REQUIRE(bench.advance());
      const Snapshot s = bench.snapshot();
      all = all && s.a.poses != nullptr;
      CHECK((s.a.poses != nullptr) == (s.a.state->size() == 0));
      CHECK(s.a.report.step == s.a.state->step);
    }
    return all;
  };
  bench.apply(command::Play{});
  CHECK_FALSE(stays());
  bench.apply(command::Observe{.iterations = false, .contacts = false, .states = false});
  CHECK(stays());
  while (!bench.run().bodies_stayed()) REQUIRE(bench.advance());
  bench.apply(command::Set{"contact.N", "7"});
  bench.apply(command::Speed{0});
  CHECK(bench.run().bodies_stayed());
  CHECK(bench.snapshot().a.poses != nullptr);
  bench.apply(command::Pause{});
  CHECK(bench.snapshot().a.state->size() == 3);
  bench.apply(command::Step{5});
  CHECK_FALSE(bench.run().bodies_stayed());
  bench.apply(command::Play{});
  CHECK(stays());
  while (!bench.run().bodies_stayed()) REQUIRE(bench.advance());
  bench.apply(command::Observe{.iterations = false, .contacts = false, .states = true});
  CHECK(bench.snapshot().a.state->size() == 3);
  bench.apply(command::Observe{.iterations = false, .contacts = false, .states = false});
  // A comparison takes the states of both.
  bench.apply(command::Compare{{"contact.N=9"}});
  CHECK_FALSE(stays());
}

TEST_CASE("the message of a step that leaves the numbers says which moment is left of bodies that stayed") {
  const auto devices = std::make_shared<DriftDevices>();
  devices->draws = true;
  WorkbenchOptions options;
  options.devices = devices;
  options.memory = 3000;
  Workbench bench(options, command::Load{kTwoBoxes, {"solver.device=gpu"}, false});
  bench.apply(command::Play{});
  bench.apply(command::Observe{.iterations = false, .contacts = false, .states = false});
  for (int k = 0; k < 20; ++k) REQUIRE(bench.advance());
  while (!bench.run().bodies_stayed()) REQUIRE(bench.advance());
  const std::int64_t step = bench.run().state().step;
  devices->newest->diverges_at = devices->newest->steps + 1;
  CHECK_FALSE(bench.advance());
  const Snapshot s = bench.snapshot();
  CHECK(s.diverged);
  CHECK(s.a.state->size() == 3);
  const std::string& text = s.messages.back().text;
  CHECK(text.find("diverged at step " + std::to_string(step + 1)) == 0);
  CHECK(text.find("the last state that was kept") != std::string::npos);
}

}  // namespace pabd::test_devices
