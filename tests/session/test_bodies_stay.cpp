// SPDX-License-Identifier: MIT
// A run whose bodies may stay on the device that makes its steps: when they come back, and what is left when they do not.
#include <catch2/catch.hpp>

#include "app/session/run.h"
#include "tests/support/drift_device.h"

namespace pabd::test_bodies_stay {

using test::DriftDevices;
using test::thrown_balls;

namespace {

// With room for few states.
struct Staying {
  Staying()
      : run(thrown_balls(SolverDevice::gpu), 1, 4 * state_bytes(thrown_balls(SolverDevice::gpu)->initial)) {
    run.offer(devices);
    devices->draws = true;
    run.let_bodies_stay(true);
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

double drawn_x(const Run& run) {
  const auto poses = std::dynamic_pointer_cast<const test::DriftPoses>(run.view().poses);
  REQUIRE(poses);
  return poses->state.c[0].x();
}

}  // namespace

TEST_CASE("bodies that may stay on a device come back where a state is kept, and where one is asked for") {
  Staying made;
  Run& run = made.run;
  const double h = run.params().h;
  int away = 0;
  for (int k = 1; k <= 200; ++k) {
    made.go(1);
    CAPTURE(k);
    CHECK(run.state().step == k);
    CHECK(run.view().state->step == k);
    CHECK(run.report().step == k);
    away += run.bodies_stayed() ? 1 : 0;
    if (!run.bodies_stayed()) CHECK(run.state().c[0].x() == Approx(3 * h * k));
    CHECK(drawn_x(run) == Approx(3 * h * k));
    CHECK(run.view().state->size() == 0);
  }
  CHECK(away > 150);
  CHECK(run.timeline().size() == 201);
  CHECK(run.timeline().bytes() <= run.timeline().budget());
  run.complete();
  CHECK_FALSE(run.bodies_stayed());
  CHECK(run.state().c[0].x() == Approx(3 * h * 200));
  CHECK(run.state().contacts.size() == 1);
  CHECK(run.timeline().back().state != nullptr);
  CHECK(run.view().poses != nullptr);  // pictures are drawn from there still
  run.let_bodies_stay(false);
  CHECK(run.view().poses == nullptr);
  CHECK(run.view().state->size() == 2);
  run.let_bodies_stay(true);
  made.go(1);
  // What looks at the past or changes it has them first.
  const std::size_t middle = run.timeline().kept(100);
  run.seek(middle);
  CHECK(run.state().c[0].x() == Approx(3 * h * static_cast<double>(middle)));
  CHECK(run.view().poses == nullptr);
  run.seek(201);
  CHECK(run.state().c[0].x() == Approx(3 * h * 201));
  made.go(3);
  CHECK(run.fork().state().c[0].x() == Approx(3 * h * 204));
  made.set(SolverDevice::cpu);
  made.go(1);
  CHECK(run.state().c[0].x() == Approx(3 * h * 205));
  made.set(SolverDevice::gpu);
  made.go(7);
  run.let_bodies_stay(false);
  made.go(1);
  CHECK_FALSE(run.bodies_stayed());
  CHECK(run.state().c[0].x() == Approx(3 * h * 213));
}

TEST_CASE(
    "states that are asked for take the room of the oldest moments, and the run is at its end all the same") {
  Staying made;
  Run& run = made.run;
  for (int k = 1; k <= 3000; ++k) {
    made.go(1);
    if (k % 7 != 0) continue;
    run.complete();
    REQUIRE(run.at_end());
    REQUIRE(run.state().step == k);
    REQUIRE(run.timeline()[run.cursor()].report.step == k);
    if (k % 70 == 0) REQUIRE(run.fork().state().step == k);
  }
  CHECK(run.timeline().forgotten() > 0);
  made.go(1);
  while (!run.bodies_stayed()) made.go(1);
  // A moment that is gone to is the one that was meant, whatever had to be forgotten on the way.
  const std::size_t i = run.timeline().kept(run.timeline().size() - 100);
  const std::int64_t step = run.timeline()[i].report.step;
  run.seek(i);
  CHECK(run.state().step == step);
}

TEST_CASE("a device without pictures brings every state back") {
  Staying made;
  made.devices->draws = false;
  for (int k = 0; k < 50; ++k) {
    made.go(1);
    CHECK_FALSE(made.run.bodies_stayed());
  }
}

TEST_CASE("bodies that are lost with their device are where they were kept last, and the processor goes on") {
  Staying made;
  Run& run = made.run;
  made.go(5);
  while (!run.bodies_stayed()) made.go(1);
  const std::int64_t lost_at = run.state().step;
  made.devices->newest->lost_after = made.devices->newest->steps;
  const bool asked = GENERATE(false, true);  // by a step, or by who looks
  std::int64_t kept = 0;
  for (std::size_t i = 0; i < run.timeline().size(); ++i)
    if (run.timeline()[i].state) kept = run.timeline()[i].report.step;
  REQUIRE(kept < lost_at);
  if (asked) {
    run.complete();
    CHECK(run.state().step == kept);
  } else {
    made.go(1);
    CHECK(run.state().step == kept + 1);
    CHECK(run.state().v[1].y() < 0);  // the processor knows of gravity
  }
  CHECK_FALSE(run.bodies_stayed());
  CHECK(run.timeline().back().report.step == run.state().step);
  CHECK(run.state().c[0].x() == Approx(3 * run.params().h * static_cast<double>(run.state().step)));
  CHECK(run.device().name.empty());
  CHECK(run.device().why.find("drift: lost; back at t = ") == 0);
  made.go(2);
  CHECK(run.state().step == kept + (asked ? 2 : 3));
}

TEST_CASE("a step that leaves the numbers takes bodies that stayed along: the run is where they were kept") {
  Staying made;
  Run& run = made.run;
  made.go(5);
  while (!run.bodies_stayed()) made.go(1);
  const std::int64_t step = run.state().step;
  made.devices->newest->diverges_at = made.devices->newest->steps + 1;
  CHECK_FALSE(run.advance());
  CHECK(run.report().status == StepStatus::non_finite);
  CHECK(run.report().step == step + 1);
  CHECK(run.state().step < step + 1);
  CHECK(run.state().size() == 2);
  CHECK_FALSE(run.bodies_stayed());
  CHECK(run.timeline().back().report.step == run.state().step);
  CHECK(run.device().name == "drift");  // it is not its fault
  made.go(3);
}

}  // namespace pabd::test_bodies_stay
