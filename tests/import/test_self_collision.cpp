// SPDX-License-Identifier: MIT
// Links of one robot: those that touch at the start are kept apart and stay at rest, others meet as bodies do.
#include <algorithm>

#include "tests/import/import_helpers.h"

namespace pabd::test_self_collision {

using namespace test;

namespace {

ImportedScene imported(const std::string& text, SelfCollision which = SelfCollision::start) {
  return import_robot_text(text, "robot.xml", {}, {.self_collision = which});
}

// A fixed base; on it b, on b c, which reaches 20 mm into the base.
const std::string kFolded = R"(<mujoco><option gravity="0 0 0"/><worldbody>
  <body name="base"><geom type="box" size=".1 .1 .1"/>
    <body name="b" pos="0 0 .5"><joint axis="0 1 0"/><geom type="box" size=".1 .1 .1"/>
      <body name="c" pos=".18 0 -.5"><joint axis="0 1 0" pos="0 0 .5"/><geom type="box" size=".1 .1 .1"/></body>
    </body>
  </body></worldbody></mujoco>)";

// A slider whose weight falls on the base of its own robot, 0.3 m below.
const std::string kPress = R"(<mujoco><worldbody>
  <body name="base"><geom type="box" size=".1 .1 .1"/>
    <body name="rail" pos="1 0 0"><joint axis="0 0 1" range="-1 1"/><inertial mass="1" diaginertia="1 1 1" pos="0 0 0"/>
      <body name="ram" pos="-1 0 .5"><joint type="slide" axis="0 0 1"/><geom type="box" size=".1 .1 .1"/></body>
    </body>
  </body></worldbody></mujoco>)";

}  // namespace

TEST_CASE("links that overlap at the start are kept apart, counted, and stay where they are", "[import]") {
  const ImportedScene scene = imported(kFolded);
  CHECK_THAT(note_with(scene, "touch at the start").text, Catch::StartsWith("a pair of links"));
  ImportedRun run(scene.text), pushed(imported(kFolded, SelfCollision::all).text);
  const std::size_t base = run.body("world"), c = run.body("c");
  const auto apart = [&](const ImportedRun& of) {
    const auto& pairs = of.scene.model.no_collide;
    return std::find(pairs.begin(), pairs.end(), std::pair<Index, Index>(std::minmax(base, c))) !=
           pairs.end();
  };
  CHECK(apart(run));
  CHECK_FALSE(apart(pushed));
  run.run(0.5);
  pushed.run(0.5);
  CHECK(run.state.v[c].norm() < 1e-9);
  CHECK(pushed.state.v[c].norm() > 0.1);
}

TEST_CASE("links that come together later touch, but with --self-collision none", "[import]") {
  ImportedRun run(imported(kPress).text), none(imported(kPress, SelfCollision::none).text);
  const std::size_t ram = run.body("ram");
  run.run(1);
  none.run(1);
  // It rests at most d̂ above the base.
  CHECK(run.state.c[ram].y() >= 0.2);
  CHECK(run.state.c[ram].y() < 0.2 + run.scene.params.contact.d_hat);
  CHECK(none.state.c[ram].y() == Approx(0.5 - 9.81 / 2).epsilon(5e-3));
}

TEST_CASE("two robots that touch at the start, or one and the world, do collide", "[import]") {
  const ImportedScene scene = imported(R"(<mujoco><worldbody>
    <geom name="table" type="box" size="1 1 .1" pos="0 0 -.1"/>
    <body name="a" pos="0 0 .1"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
    <body name="b" pos="0 0 .3"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>)");
  CHECK(parse_scene(scene.text, "robot", {}).model.no_collide.empty());
  ImportedRun run(scene.text);
  run.run(1);
  CHECK(run.state.c[run.body("a")].y() == Approx(0.1).margin(0.01));
  CHECK(run.state.c[run.body("b")].y() == Approx(0.3).margin(0.02));
}

}  // namespace pabd::test_self_collision
