// SPDX-License-Identifier: MIT
// How fast a video shows a run, and what it shows between two steps.
#include <catch2/catch.hpp>

#include "app/frames/frame_source.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace pabd::test_pace {

namespace {

std::shared_ptr<const Scene> turning_ball() {
  return std::make_shared<const Scene>(parse_scene(
      R"({ "format": "pabd-scene", "version": 1, "gravity": [0, 0, 0], "time_step": 0.1, "bodies": [
             { "shape": { "type": "sphere", "radius": 0.1 }, "position": [0, 1, 0], "velocity": [2, 0, 0],
               "angular_velocity": [0, 180, 0] } ] })",
      "test", {}));
}

}  // namespace

TEST_CASE("a pace goes from the time of a video to that of the run, and back") {
  const Pace pace("1,0.1:0.8-1.2,4:2-4");
  CHECK(pace.simulated(0.5) == Approx(0.5));
  CHECK(pace.simulated(0.8 + 2) == Approx(1.0));
  CHECK(pace.simulated(0.8 + 4) == Approx(1.2));
  CHECK(pace.simulated(0.8 + 4 + 0.8 + 0.25) == Approx(3));
  CHECK(pace.shown(5) == Approx(0.8 + 4 + 0.8 + 0.5 + 1));
  for (double t = 0; t < 8; t += 0.0625) CHECK(pace.shown(pace.simulated(t)) == Approx(t).margin(1e-12));
  CHECK(Pace("0.1").simulated(3) == Approx(0.3));
  CHECK(Pace().is_real_time());
  CHECK(Pace("1").is_real_time());
  CHECK_FALSE(pace.is_real_time());
  for (const char* wrong :
       {"", "x", "0", "-1", "1,2", "0.1:1", "0.1:2-1", "0.1:1-2,0.2:1.5-3", "1e-9", "0.1:1-2x"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(Pace(wrong), Error);
  }
}

TEST_CASE("in slow motion bodies are on their way from step to step, in real time where a step ended") {
  for (const double speed : {1.0, 0.25, 0.1, 0.03}) {
    LiveSource source(runs_of(Run(turning_ball(), 1, kNoPast)), {0, 40, 60, Pace(std::to_string(speed))});
    const auto never = [] { return false; };
    for (int frame = 0; frame < 40; ++frame) {
      const auto shown = source.next(never);
      REQUIRE(shown);
      const State& state = *shown->a().state;
      const double time = speed * frame / 60;
      CAPTURE(speed, frame);
      const double seen = speed == 1 ? 0.1 * std::floor(10 * time + 1e-9) : time;
      CHECK(state.time == Approx(seen).margin(1e-9));
      CHECK(state.c[0].x() == Approx(2 * seen).margin(1e-9));
      CHECK(state.R[0](0, 0) == Approx(std::cos(kPi * seen)).margin(1e-3));
    }
  }
}

}  // namespace pabd::test_pace
