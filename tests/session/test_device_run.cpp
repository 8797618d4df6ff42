// SPDX-License-Identifier: MIT
// A run whose steps a device makes, and that can be wound back: what is kept of them, and who goes on when.
#include <catch2/catch.hpp>

#include "app/session/recording.h"
#include "tests/support/drift_device.h"
#include "tests/support/errors.h"

namespace pabd::test_device_run {

using test::DriftDevices;
using test::thrown_balls;

namespace {

constexpr std::size_t kPlenty = std::size_t{64} << 20;

struct Made {
  explicit Made(std::size_t memory = kPlenty, SolverDevice device = SolverDevice::gpu)
      : run(thrown_balls(device), 1, memory) {
    run.offer(devices);
  }
  void go(int steps) {
    for (int k = 0; k < steps; ++k) REQUIRE(run.advance());
  }
  void set(SolverDevice device) {
    Params params = run.params();
    params.solver.device = device;
    run.set_params(params);
  }

  std::shared_ptr<DriftDevices> devices = std::make_shared<DriftDevices>();
  Run run;
};

AddJoint joint() {
  AddJoint out;
  out.i = 0;
  out.j = 1;
  out.anchor = Vec3(0, 15, 0);
  return out;
}

}  // namespace

TEST_CASE("a device makes the steps of a run that keeps its past") {
  Made made;
  Run& run = made.run;
  CHECK(run.device().name == "drift");
  CHECK(made.devices->opened == 0);
  std::vector<State> states{run.state()};
  for (int k = 0; k < 50; ++k) {
    made.go(1);
    states.push_back(run.state());
  }
  CHECK(made.devices->newest->steps == 50);
  CHECK(run.state().c[1].y() == 20);  // nothing fell
  CHECK(run.timeline().gone() == 0);
  for (const std::size_t i : {7u, 50u, 0u, 49u, 8u}) {
    run.seek(i);
    CHECK(run.cursor() == i);
    CHECK(run.state().c[0] == states[i].c[0]);
    CHECK(run.report().step == static_cast<std::int64_t>(i));
    // With all that the next step depends on, whoever makes it.
    if (i > 0) {
      REQUIRE(run.state().contacts.size() == 1);
      CHECK(run.state().contacts[0].stretch.x() == static_cast<double>(i));
    }
  }
  CHECK(made.devices->newest->steps == 50);  // the past is not computed again
  made.go(42);                               // it is played
  CHECK(made.devices->newest->steps == 50);
  CHECK(run.at_end());
  made.go(1);
  CHECK(made.devices->newest->steps == 51);
  CHECK(made.devices->opened == 1);
  CHECK((run.state().c[0] - Vec3(3 * 51 * run.params().h, 10, 0)).norm() < 1e-12);
}

TEST_CASE("a small budget keeps some of a device's states, says how many, and goes back to those alone") {
  const std::size_t one = [] {
    Made made;
    made.go(1);
    return state_bytes(*made.run.timeline().back().state);
  }();
  for (const std::size_t room : {3u, 40u, 200u}) {
    CAPTURE(room);
    Made made(room * one);
    Run& run = made.run;
    made.go(1000);
    const Timeline& past = run.timeline();
    CHECK(past.bytes() <= past.budget());
    REQUIRE(past.gone() > 0);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < past.size(); ++i) {
      const bool there = past[i].state != nullptr;
      kept += there ? 1 : 0;
      CHECK((past.kept(i) == i) == there);
    }
    // The present may lie with the device alone until somebody leaves it.
    CHECK(past.size() - past.gone() == kept);
    CHECK(kept >= room / 3);
    const double end = run.state().c[0].x();
    run.seek(past.size() / 2);
    const std::size_t i = run.cursor();
    CHECK(i <= past.size() / 2);
    CHECK(past.size() / 2 - i < 1000 / room + 128);
    CHECK(run.report().step == run.state().step);
    CHECK(run.state().c[0].x() == Approx(3 * run.params().h * static_cast<double>(run.state().step)));
    REQUIRE(run.advance());
    CHECK(run.cursor() == past.next_kept(i));
    CHECK(run.cursor() > i);
    run.seek(past.size() - 1);
    CHECK(run.at_end());
    CHECK(run.state().c[0].x() == end);
    CHECK(past.bytes() <= past.budget() + one);
  }
}

TEST_CASE("the parameters switch the device while it runs, and each goes on where the other was") {
  Made made(kPlenty, SolverDevice::cpu);
  Run& run = made.run;
  made.go(3);
  CHECK(made.devices->opened == 0);
  CHECK(run.device() == DeviceStatus{});
  const double fallen = run.state().c[1].y();
  CHECK(fallen < 20);
  made.set(SolverDevice::gpu);
  CHECK(run.device().name == "drift");
  made.go(4);
  CHECK(made.devices->newest->steps == 4);
  const State handed = run.state();
  made.set(SolverDevice::cpu);
  made.go(3);
  CHECK(made.devices->newest->steps == 4);
  const State end = run.state();
  CHECK(end.c[1].y() < handed.c[1].y());
  // The processor's steps come out to the bit, those after the device's as well.
  for (const std::size_t i : {9u, 2u, 10u, 7u, 8u}) {
    run.seek(i);
    CHECK(run.cursor() == i);
    if (i == 10) CHECK(same_bits(run.state(), end));
  }
  // Few bodies: who may choose takes the processor, and says why.
  run.seek(10);
  made.set(SolverDevice::automatic);
  CHECK(run.device() == DeviceStatus{"", "too few"});
  AddBody ball;
  ball.position = Vec3(5, 5, 5);
  run.edit(ball);
  CHECK(run.device().name == "drift");
  made.go(1);
  CHECK(made.devices->newest->steps == 1);
}

TEST_CASE("hands are the processor's, and the device goes on where it let go") {
  Made made;
  Run& run = made.run;
  made.go(5);
  run.set_pulls({Pull{0, Vec3::Zero(), Vec3(0, 12, 0), 100}});
  CHECK(run.device().name.empty());
  CHECK(run.device().why.find("hands") != std::string::npos);
  made.go(2);
  CHECK(made.devices->newest->steps == 5);
  run.set_pulls({});
  made.go(2);
  CHECK(made.devices->newest->steps == 7);
  CHECK(made.devices->opened == 1);
  const State end = run.state();
  run.seek(6);
  run.seek(9);
  CHECK(same_bits(run.state(), end));
  // A model that changes meanwhile is told of as well.
  run.set_pulls({Pull{0, Vec3::Zero(), Vec3(0, 12, 0), 100}});
  made.go(2);
  CHECK(made.devices->newest->forgotten == 0);
  run.edit(RemoveBody{1});
  CHECK(made.devices->newest->forgotten == 1);
  made.go(1);
  CHECK(made.devices->newest->steps == 8);
}

TEST_CASE("what a device does not take leaves the steps to the processor, until that is undone") {
  Made made;
  Run& run = made.run;
  made.go(4);
  const auto edit = run.edit(joint());
  CHECK(made.devices->newest->forgotten > 0);
  CHECK(run.device().why == "drift knows no joints");
  made.go(3);
  CHECK(made.devices->newest->steps == 4);
  CHECK(run.undo_edit(*edit));
  CHECK(run.state().step == 4);
  CHECK(run.device().name == "drift");
  made.go(1);
  CHECK(made.devices->newest->steps == 1);  // of another one: the first was given back
  CHECK(made.devices->opened == 2);
}

TEST_CASE("the moment before an edit is kept, however small the budget") {
  Made made(20000);
  Run& run = made.run;
  made.go(333);
  const double x = run.state().c[0].x();
  AddBody ball;
  ball.position = Vec3(5, 5, 5);
  const auto edit = run.edit(ball);
  made.go(200);
  REQUIRE(run.timeline().forgotten() == 0);
  REQUIRE(run.timeline().gone() > 300);
  CHECK(run.undo_edit(*edit));
  CHECK(run.state().step == 333);
  CHECK(run.state().c[0].x() == x);
  CHECK(run.timeline().bytes() <= 20000);
}

TEST_CASE("a device that is lost leaves the run to the processor, and says so") {
  Made made;
  Run& run = made.run;
  made.go(3);
  made.devices->newest->lost_after = 3;
  const double x = run.state().c[0].x();
  made.go(1);
  CHECK(run.device() == DeviceStatus{"", "drift: lost"});
  CHECK(run.state().step == 4);
  CHECK(run.state().c[0].x() > x);
  CHECK(run.state().c[1].y() < 20);
  made.go(2);
  CHECK(made.devices->opened == 1);
  // Asked for again, it is looked for again.
  made.set(SolverDevice::cpu);
  made.set(SolverDevice::gpu);
  made.go(1);
  CHECK(made.devices->opened == 2);
  CHECK(run.device().name == "drift");
  made.set(SolverDevice::cpu);
  made.devices->refuses = true;
  made.set(SolverDevice::gpu);
  made.go(1);
  CHECK(run.device() == DeviceStatus{"", "drift: not there"});
}

TEST_CASE("a device is asked for contacts alone, and tells of them again in the past") {
  Made made;
  Run& run = made.run;
  run.observe(true, true, true);
  made.go(6);
  CHECK(made.devices->newest->steps == 6);
  CHECK(run.report().contact_reports.size() == 1);
  const State fifth = run.state();
  made.go(1);
  run.seek(6);
  CHECK(run.report().contact_reports.size() == 1);
  CHECK(run.state().c[0] == fifth.c[0]);
  // On the processor everything is told.
  made.set(SolverDevice::cpu);
  made.go(1);
  CHECK(run.report().body_reports.size() == 2);
}

TEST_CASE("a copy of a run on a device stands where it stood, with a device of its own") {
  Made made(2000);
  made.go(200);
  Run copy = made.run.fork();
  CHECK(same_bits(copy.state(), [&] {
    made.run.complete();
    return made.run.state();
  }()));
  CHECK(copy.at_end());
  CHECK(made.devices->opened == 1);
  REQUIRE(copy.advance());
  CHECK(made.devices->opened == 2);
  Params cpu = copy.params();
  cpu.solver.device = SolverDevice::cpu;
  copy.set_params(cpu);
  REQUIRE(copy.advance());
  CHECK(copy.state().c[1].y() < 20);
  CHECK(made.run.state().c[1].y() == 20);
  // Where the copy went the run may go as well, with the device that it has.
  made.run.go_to(copy.head());
  CHECK(same_bits(made.run.state(), copy.state()));
  Params gpu = copy.params();
  gpu.solver.device = SolverDevice::gpu;
  made.run.set_params(gpu);
  REQUIRE(made.run.advance());
  CHECK(made.run.device().name == "drift");
}

TEST_CASE("a recording has the states that were kept of a device's steps") {
  const auto scene = thrown_balls(SolverDevice::gpu);
  Made made(20000);
  made.go(40);
  made.set(SolverDevice::cpu);
  made.go(40);
  made.set(SolverDevice::gpu);
  made.go(300);
  REQUIRE(made.run.timeline().gone() > 0);
  made.run.complete();
  const std::string bytes = encode_recording(made.run);
  const Timeline past = decode_recording(bytes, "r.rec", scene, kPlenty);
  const Timeline& wanted = made.run.timeline();
  REQUIRE(past.size() == wanted.size());
  CHECK(past.gone() == wanted.gone());
  for (std::size_t i = 0; i < past.size(); ++i) {
    CAPTURE(i);
    CHECK(past.kept(i) == wanted.kept(i));
    CHECK(past[i].device == wanted[i].device);
    if (past.kept(i) == i) CHECK(same_bits(*past.state(i), *wanted.state(i)));
  }
  CHECK_FALSE(first_difference(past, 1));
  const auto devices = std::make_shared<DriftDevices>();
  Run again(scene, 1, past);
  again.offer(devices);
  CHECK(again.at_end());
  CHECK(same_bits(again.state(), made.run.state()));
  REQUIRE(again.advance());
  CHECK(devices->newest->steps == 1);
}

}  // namespace pabd::test_device_run
