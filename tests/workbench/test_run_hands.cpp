// SPDX-License-Identifier: MIT
// Edits and pulls are part of the past: wound back, thinned out and replayed they give the same bits.
#include <catch2/catch.hpp>

#include <filesystem>

#include "app/session/run.h"
#include "app/workbench/workbench.h"
#include "sim/base/error.h"
#include "sim/scene/tuning.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_run_hands {

using test::kPlenty, test::two_boxes;

namespace {

Index movable(const Model& model) {
  Index i = 0;
  while (model.fixed[static_cast<std::size_t>(i)]) ++i;
  return i;
}

AddBody ball(double y) {
  AddBody body;
  body.shape = Sphere{0.2};
  body.position = {0.1, y, 0.3};
  body.orientation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  body.omega = {1, 2, 3};
  return body;
}

// A run with everything in it that a person does by hand.
void handle(Run& run) {
  const Index body = movable(run.model());
  for (int i = 0; i < 150; ++i) REQUIRE(run.advance());
  for (int i = 0; i < 60; ++i) {  // a hand that moves
    const Vec3 c = run.state().c[static_cast<std::size_t>(body)];
    run.set_pulls({{body, {0.1, 0, 0}, c + Vec3(0.3, 0.5, 0.01 * i), 2e5}});
    REQUIRE(run.advance());
  }
  run.set_pulls({});
  run.edit(ball(3));
  for (int i = 0; i < 100; ++i) REQUIRE(run.advance());
  AddJoint joint;
  joint.i = run.model().size() - 1;
  joint.anchor = {0.1, 2, 0.3};
  run.edit(joint);
  for (int i = 0; i < 250; ++i) REQUIRE(run.advance());
}

}  // namespace

TEST_CASE("a run with pulls and edits is what it was, also where states were dropped") {
  const auto scene = two_boxes();
  Run wide(scene, 1, kPlenty);
  handle(wide);
  Run tight(scene, 1, 300 * state_bytes(wide.state()));
  handle(tight);
  const std::size_t n = wide.timeline().size();
  REQUIRE(n == 563);  // 560 steps, two edits, the beginning
  REQUIRE(tight.timeline().size() == n);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) kept += tight.timeline()[i].state ? 1 : 0;
  CHECK(kept < 350);
  for (std::size_t i = 0; i < n; i += 7) {
    INFO("moment " << i);
    CHECK(same_bits(*tight.timeline().state(i), *wide.timeline().state(i)));
  }
  for (const std::size_t i : {200u, 211u, 210u, 562u, 311u, 312u, 313u, 3u}) {
    tight.seek(i);
    CHECK(same_bits(tight.state(), *wide.timeline().state(i)));
    CHECK(tight.shared_model() == tight.timeline()[i].model);
  }
  tight.seek(140);
  while (!tight.at_end()) REQUIRE(tight.advance());  // replays, hand and all
  CHECK(same_bits(tight.state(), wide.state()));
  CHECK(tight.timeline().size() == n);

  // The hand matters, or all of this would show nothing.
  Run alone(scene, 1, kPlenty);
  for (int i = 0; i < 210; ++i) REQUIRE(alone.advance());
  CHECK(largest_distance(alone.state(), *wide.timeline().state(210)) > 0.05);
}

TEST_CASE("reports of bodies come when they are asked for, and cost no bit") {
  Run run(two_boxes(), 1, kPlenty);
  for (int i = 0; i < 30; ++i) REQUIRE(run.advance());
  CHECK(run.report().body_reports.empty());
  const State before = run.state();
  run.observe(false, false, true);
  run.seek(run.cursor());
  CHECK(run.report().body_reports.size() == run.model().shape.size());
  CHECK(same_bits(run.state(), before));
}

TEST_CASE("edits and pulls that cannot be leave everything as it was") {
  Run run(two_boxes(), 1, kPlenty);
  for (int i = 0; i < 10; ++i) REQUIRE(run.advance());
  const auto model = run.shared_model();
  CHECK_THROWS_AS(run.edit(RemoveBody{99}), Error);
  CHECK_THROWS_AS(run.set_pulls({{99, Vec3::Zero(), Vec3::Zero(), 1}}), Error);
  CHECK_THROWS_AS(run.set_pulls({{movable(*model), Vec3::Zero(), Vec3::Zero(), -1}}), Error);
  CHECK_THROWS_AS(run.set_pulls({{movable(*model), Vec3::Zero(), Vec3(NAN, 0, 0), 1}}), Error);
  for (Index i = 0; i < model->size(); ++i) {
    if (model->fixed[static_cast<std::size_t>(i)])
      CHECK_THROWS_AS(run.set_pulls({{i, Vec3::Zero(), Vec3::Zero(), 1}}), Error);
  }
  CHECK(run.shared_model() == model);
  CHECK(run.timeline().size() == 11);
  CHECK_FALSE(run.pulls());
}

TEST_CASE("what was deleted comes back with undo, in both simulations") {
  Workbench bench({}, command::Load{places::scenes() + "/two_boxes.json", {}, false});
  bench.apply(command::Step{20});
  bench.apply(command::Compare{{"contact.N=6"}});
  bench.apply(command::Step{5});
  const State before = bench.run().state(), before_b = bench.run(Side::b).state();
  const auto bodies = bench.run().model().size();
  bench.apply(command::Edit{R"({"do": "remove_body", "body": 1})"});
  CHECK(bench.run().model().size() == bodies - 1);
  CHECK(bench.run(Side::b).model().size() == bodies - 1);
  CHECK(bench.snapshot().unsaved);
  CHECK(bench.snapshot().can_undo);
  bench.apply(command::Step{10});
  bench.apply(command::Step{-11});  // to before it, B too
  CHECK(bench.run().model().size() == bodies);
  CHECK(bench.run(Side::b).model().size() == bodies);
  bench.apply(command::Seek{1e9});
  bench.apply(command::Undo{});
  CHECK(same_bits(bench.run().state(), before));
  CHECK(same_bits(bench.run(Side::b).state(), before_b));
  CHECK(bench.run().at_end());
  bench.apply(command::Redo{});
  CHECK(bench.run().model().size() == bodies - 1);
  CHECK(bench.run(Side::b).model().size() == bodies - 1);
  CHECK_THROWS_AS(bench.apply(command::Edit{R"({"do": "remove_body", "body": 77})"}), Error);
  CHECK_THROWS_AS(bench.apply(command::Edit{"nonsense"}), Error);
  bench.apply(command::Restart{});
  CHECK(bench.run().model().size() == bodies);
  bench.apply(command::Undo{});  // a restart does not lose it for good
  CHECK(bench.run().model().size() == bodies - 1);
}

TEST_CASE("a pull moves a body towards the hand and ends with it; a ball flies where it is shot") {
  Workbench bench({}, command::Load{places::scenes() + "/two_boxes.json", {}, false});
  const auto i = static_cast<std::size_t>(movable(bench.run().model()));
  const Vec3 c = bench.run().state().c[i];
  bench.apply(command::Pull{static_cast<int>(i), {0, 0, 0}, {c.x() + 2, c.y() + 1, c.z()}});
  const std::vector<Pull> pulls = bench.snapshot().a.pulls;
  REQUIRE(pulls.size() == 1);
  // m (2π 2 Hz)²
  CHECK(pulls[0].kappa == Approx(bench.run().model().mass[i] * 157.91367).epsilon(1e-6));
  bench.apply(command::Step{10});
  CHECK(bench.run().state().c[i].x() > c.x() + 0.5);
  bench.apply(command::Release{});
  CHECK(bench.snapshot().a.pulls.empty());

  const auto bodies = bench.run().model().size();
  bench.apply(command::Shoot{{5, 3, 0}, {0, 0, 2}, 12, 0.25, 500});
  REQUIRE(bench.run().model().size() == bodies + 1);
  CHECK(bench.run().state().v.back().z() == Approx(12));
  CHECK(bench.run().model().mass.back() == Approx(500 * 4.0 / 3 * 3.14159265 * 0.25 * 0.25 * 0.25));
  CHECK_THROWS_AS(bench.apply(command::Shoot{{0, -5, 0}, {0, 1, 0}}), Error);  // in the ground
  CHECK_THROWS_AS(bench.apply(command::Shoot{{5, 3, 0}, {0, 0, 0}}), Error);
  CHECK_THROWS_AS(bench.apply(command::Shoot{{5, 3, 0}, {0, 0, 1}, 1, -1}), Error);
  CHECK(bench.run().model().size() == bodies + 1);
}

TEST_CASE("recordings and states are saved and come back, and what does not fit changes nothing") {
  const TempFolder folder;
  const std::string file = (folder / "run.pabdrec").string(), state = (folder / "state.json").string();
  const command::Load scene{places::scenes() + "/two_boxes.json", {}, false};
  Workbench bench({}, scene);
  bench.apply(command::Step{30});
  bench.apply(command::Pull{2, {0, 0, 0}, {1, 3, 0}});
  bench.apply(command::Step{10});
  bench.apply(command::Release{});
  bench.apply(command::Shoot{{5, 2, 0}, {-1, 0, 0}});
  bench.apply(command::Step{40});
  CHECK(bench.snapshot().unsaved);
  bench.apply(command::SaveRecording{file});
  CHECK_FALSE(bench.snapshot().unsaved);
  CHECK_THROWS_AS(bench.apply(command::SaveRecording{file}), Error);  // exists
  bench.apply(command::SaveRecording{file, true});

  Workbench other({}, scene);
  other.apply(command::Set{"contact.kappa", "77"});
  CHECK_THROWS_AS(other.apply(command::LoadRecording{file}), Error);  // not saved
  other.apply(command::LoadRecording{file, true});
  CHECK(same_bits(other.run().state(), bench.run().state()));
  CHECK(other.run().timeline().size() == bench.run().timeline().size());
  CHECK(other.snapshot().messages.back().severity == Severity::note);
  other.apply(command::Seek{0.6});
  bench.apply(command::Seek{0.6});
  CHECK(same_bits(other.run().state(), bench.run().state()));
  CHECK(other.snapshot().a.pulls.size() == 1);  // the hand is seen again

  Workbench pyramid({}, command::Load{places::scenes() + "/pyramid.json", {}, false});
  CHECK_THROWS_WITH(pyramid.apply(command::LoadRecording{file}), Catch::Contains("open that scene first"));
  write_bytes(file, "pabd-rec");
  CHECK_THROWS_WITH(other.apply(command::LoadRecording{file}), Catch::Contains("run.pabdrec"));
  CHECK(other.run().timeline().size() == 82);

  bench.apply(command::Seek{1e9});
  bench.apply(command::SaveScene{state, true});
  Workbench third({}, command::Load{state, {}, false});
  CHECK(third.run().model().size() == 4);
  CHECK(largest_distance(third.run().state(), bench.run().state()) < 1e-12);
}

}  // namespace pabd::test_run_hands
