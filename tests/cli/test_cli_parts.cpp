// SPDX-License-Identifier: MIT
// Parts of the command line that can be tested without running it: schedule, camera, queue, progress; and the
// session.
#include <catch2/catch.hpp>
#include <cmath>
#include <thread>

#include "app/cli/common.h"
#include "app/cli/progress.h"
#include "app/frames/bounded_queue.h"
#include "app/frames/camera_option.h"
#include "app/session/session.h"
#include "app/session/step_at_time.h"
#include "sim/base/error.h"
#include "sim/trace/trace.h"
#include "tests/support/places.h"

namespace pabd::test_cli_parts {

using namespace cli;

TEST_CASE("a frame shows the last step that is not after it") {
  const double h = 0.0166666666666667;
  for (const std::int64_t frame : {0, 1, 2, 59, 60, 3599, 1000000})
    CHECK(step_of_frame(frame, 60, h) == frame);
  CHECK(step_of_frame(1, 30, h) == 2);
  for (const std::int64_t frame : {1, 60, 3600}) {
    // A step that is written down with few digits is a little too long.
    CHECK(step_of_frame(frame, 60, 0.0166667) == frame);
    CHECK(step_of_frame(frame, 60, 0.004166667) == 4 * frame);
  }
  CHECK(step_of_frame(1, 120, h) == 0);  // steps longer than frames: a state is shown twice
  CHECK(step_of_frame(2, 120, h) == 1);
  CHECK(step_of_frame(3, 60, 0.02) == 2);  // t = 0.05 s: step 2 is at 0.04 s, step 3 only at 0.06 s
  CHECK(steps_until(5, 1.0 / 60) == 300);
  CHECK(steps_until(0.0999, 0.01) == 9);
}

TEST_CASE("named cameras look at the same target from the same distance") {
  Camera base;
  base.eye = {3, 5, 4};
  base.target = {1, 1, 2};
  for (const char* name : {"front", "side", "top", "iso", "orbit:45"}) {
    CAPTURE(name);
    const Camera camera = apply_camera(parse_camera(name), base, 1.0);
    CHECK(camera.target == base.target);
    CHECK((camera.eye - camera.target).norm() == Approx((base.eye - base.target).norm()).epsilon(1e-6));
  }
  CHECK(apply_camera(parse_camera("front"), base, 0).eye.z() > base.target.z());
  // 90 degrees a second: a full turn in four.
  const CameraOption orbit = parse_camera("orbit:90");
  CHECK((apply_camera(orbit, base, 4).eye - base.eye).norm() < 1e-5f);
  CHECK((apply_camera(orbit, base, 0).eye - base.eye).norm() == 0);
  CHECK(apply_camera(orbit, base, 1).eye.y() == Approx(base.eye.y()));

  const Camera placed = apply_camera(parse_camera("fov=30,eye=1,2.5,-3e0"), base, 0);
  CHECK(placed.eye == Vec3f(1, 2.5f, -3));
  CHECK(placed.target == base.target);
  CHECK(placed.fov == 30);
  for (const char* wrong : {"eye", "eye=", "eye=1,2,3,4", "eye=1,2,x", "eye=1,2,3,eye=1,2,3", "fov=0",
                            "zoom=2", "orbit:", "eye=1,2,nan"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_camera(wrong), Error);
  }
}

TEST_CASE("sizes and ranges are checked") {
  CHECK(parse_size("640x360").width == 640);
  CHECK(parse_size("16x16384").height == 16384);
  for (const char* wrong :
       {"", "x", "640", "640x", "x360", "640X360", "640x360 ", "-640x360", "15x15", "16385x100", "1e3x100"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_size(wrong), Error);
  }
  CHECK_NOTHROW(check_range("--x", 1, 1, 2));
  CHECK_THROWS_AS(check_range("--x", std::nan(""), 1, 2), Error);
  CHECK_THROWS_AS(check_range("--x", 2.1, 1, 2), Error);
}

TEST_CASE("the queue holds the producer back, keeps the order and ends") {
  BoundedQueue<int> queue(2);
  std::atomic<int> pushed{0};
  std::thread producer([&] {
    for (int i = 0; i < 100; ++i) {
      if (queue.push(i)) ++pushed;
    }
    queue.close();
  });
  for (int i = 0; i < 100; ++i) {
    CHECK(pushed <= i + 3);  // at most two wait, one is about to be counted
    CHECK(queue.pop() == i);
  }
  CHECK_FALSE(queue.pop().has_value());
  producer.join();
  CHECK_FALSE(queue.push(1));
  CHECK_FALSE(queue.try_pop().has_value());
}

TEST_CASE("closing the queue frees a producer that waits") {
  BoundedQueue<int> queue(1);
  REQUIRE(queue.push(1));
  bool accepted = true;
  std::thread producer([&] { accepted = queue.push(2); });
  queue.close();
  producer.join();
  CHECK_FALSE(accepted);
  CHECK(queue.pop() == 1);  // what was in may still be taken
  CHECK_FALSE(queue.pop().has_value());
}

TEST_CASE("progress says how far, how long and how well") {
  StepReport report;
  report.iterations = 7;
  report.residual = 3.14e-7;
  CHECK(progress_line("frame", 12, 300, 31.4, report, false) ==
        "12 of 300 frames  4 %  ETA 31 s  iterations 7  residual 3.1e-07");
  CHECK(progress_line("step", 1, 2, 125, report, true) ==
        "[############............] 1 of 2 steps  50 %  ETA 2:05 min  iterations 7  residual 3.1e-07");
  CHECK(progress_line("step of pile", 1, 4, 0, std::string(), false) ==
        "1 of 4 steps of pile  25 %  ETA 0 s");
  CHECK(progress_line("task", 1, 1, 0, std::string(), false) == "1 of 1 task  100 %  ETA 0 s");
  CHECK(progress_line("step", 1, 2, 7321, report, false).find("ETA 2:02 h") != std::string::npos);
}

TEST_CASE("a list of reports is bounded; a view of it stays what it was") {
  ReportList list;
  StepSummary step;
  Reports early;
  for (int i = 1; i <= 1000; ++i) {
    step.step = i;
    add_report(list, step, 10);
    CHECK(list.size() <= 20);
    if (i == 15) early = list.view();
  }
  CHECK(list.size() >= 10);
  CHECK(list.back().step == 1000);
  CHECK(list[0].step == 1001 - static_cast<std::int64_t>(list.size()));
  REQUIRE(early.size() == 15);
  for (int i = 0; i < 15; ++i) CHECK(early[static_cast<std::size_t>(i)].step == i + 1);
}

TEST_CASE("a step that failed reports nothing of where it ended") {
  // The log barrier has no force for boxes that start inside each other.
  Session session(load_scene(places::scenes() + "/two_boxes.json", {"contact.barrier=log"}));
  const double kinetic = session.report().kinetic;
  CHECK(kinetic == 0);
  REQUIRE(session.step().status == StepStatus::non_finite);
  const StepReport& r = session.report();
  for (const double x :
       {r.kinetic, r.potential, r.elastic, r.max_penetration, r.min_gap, r.max_joint_error, r.residual})
    CHECK(std::isnan(x));
}

TEST_CASE("a session steps, is reset, tuned and set to a state") {
  Session session(load_scene(places::scenes() + "/stack.json"));
  const std::string start = state_hash(session.state());
  CHECK(session.report().step == 0);
  CHECK(session.report().potential > 0);
  CHECK(session.report().kinetic == 0);
  CHECK(session.kappa() > 0);
  for (int i = 0; i < 5; ++i) session.step();
  CHECK(session.state().step == 5);
  const State kept = session.state();
  const std::string fifth = state_hash(kept);
  session.step();
  const std::string sixth = state_hash(session.state());

  session.set_state(kept);
  session.step();
  CHECK(state_hash(session.state()) == sixth);

  Params params = session.params();
  params.contact.N = 8;
  session.set_params(params);
  CHECK(session.params().contact.N == 8);
  params.contact.N = 0;
  CHECK_THROWS_AS(session.set_params(params), Error);
  CHECK(session.params().contact.N == 8);

  session.reset();
  CHECK(state_hash(session.state()) == start);
  CHECK(session.params().contact.N == session.scene().params.contact.N);
  for (int i = 0; i < 5; ++i) session.step();
  CHECK(state_hash(session.state()) == fifth);
  CHECK_THROWS_AS(session.set_state(State{}), Error);
}

TEST_CASE("two sessions do not see each other") {
  Session a(load_scene(places::scenes() + "/stack.json"));
  Session b(load_scene(places::scenes() + "/stack.json"));
  Session alone(load_scene(places::scenes() + "/stack.json"));
  Params soft = b.params();
  soft.contact.kappa = 10;
  b.set_params(soft);
  for (int i = 0; i < 4; ++i) {
    a.step();
    b.step();
    alone.step();
  }
  CHECK(state_hash(a.state()) == state_hash(alone.state()));
  CHECK(state_hash(a.state()) != state_hash(b.state()));
}

}  // namespace pabd::test_cli_parts
