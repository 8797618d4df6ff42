// SPDX-License-Identifier: MIT
// Joints that follow others in scene files and in scenes built in C++; what is kept of them by files and by edits.
#include <cmath>

#include "app/session/recording.h"
#include "app/session/session.h"
#include "app/session/timeline.h"
#include "sim/scene/builder.h"
#include "sim/scene/write_scene.h"
#include "sim/trace/trace.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_read_couplings {

using namespace test;

namespace {

const std::string kBodies = R"("bodies": [
  { "name": "a", "shape": { "type": "box", "size": [1, 0.2, 0.2] }, "mass": 2, "torque": [0, 0, 1] },
  { "name": "b", "shape": { "type": "box", "size": [1, 0.2, 0.2] }, "mass": 3, "position": [2, 0, 0] },
  { "name": "c", "shape": { "type": "box", "size": [1, 0.2, 0.2] }, "mass": 3, "position": [4, 0, 0] } ])";
const std::string kA =
    R"("name": "A", "type": "hinge", "bodies": [null, "a"], "anchor": [0, 0, 0], "axis": [0, 0, 1])";
const std::string kB =
    R"("name": "B", "type": "hinge", "bodies": [null, "b"], "anchor": [2, 0, 0], "axis": [0, 0, 1])";
const std::string kC =
    R"("name": "C", "type": "slider", "bodies": [null, "c"], "anchor": [4, 0, 0], "axis": [1, 0, 0])";
const std::string kD =
    R"("name": "D", "type": "cylindrical", "bodies": [null, "c"], "anchor": [4, 0, 0], "axis": [1, 0, 0])";

std::string joints(const std::string& list) {
  // bdf2 remembers a step, which saved scenes do not.
  return scene_text("\"gravity\": [0, 0, 0], \"solver\": { \"integrator\": \"euler\" }, " + kBodies +
                    ", \"joints\": [" + list + "]");
}
std::string two(const std::string& first, const std::string& second) {
  return joints("{" + first + "}, {" + second + "}");
}

std::string saved(const Session& session) {
  const Scene& scene = session.scene();
  return scene_to_json(session.model(), session.state(), session.params(), scene.joint_law, scene.name, {},
                       {});
}

// Three turns and a half of the first, whose followers do not come round with it.
const std::string kTurning =
    joints("{" + kB + R"(, "follows": { "joint": "A", "ratio": -0.618, "offset": 0 } }, {)" + kA + "}, {" +
           kC + R"(, "follows": { "joint": "A", "ratio": 0.1 } })");

}  // namespace

TEST_CASE("a joint follows another by its name, wherever that stands", "[scene]") {
  const Scene s = parse(kTurning);
  const auto& joint = s.model.joints;
  REQUIRE(joint.size() == 3);
  REQUIRE(joint[0].follows);
  CHECK(joint[0].follows->leader == 1);
  CHECK(joint[0].follows->ratio == -0.618);
  CHECK_FALSE(joint[1].follows);
  CHECK(joint[2].follows->leader == 1);
  CHECK(joint[2].follows->offset == 0);
  const Scene screw = parse(joints("{" + kD + R"(, "lead": 0.2 })"));
  CHECK(screw.model.joints[0].follows->leader == 0);
  CHECK(screw.model.joints[0].follows->ratio == Approx(0.2 / (2 * kPi)));
  CHECK(parse(joints("{" + kA + "}")).hash != parse(two(kA, kB)).hash);
  CHECK(parse(two(kA, kB + R"(, "follows": { "joint": "A", "ratio": 2 })")).hash !=
        parse(two(kA, kB + R"(, "follows": { "joint": "A", "ratio": 3 })")).hash);
}

TEST_CASE("the offset of a joint that follows is that of the start, or must be", "[scene]") {
  const auto with = [](const std::string& rest) { return two(kA + R"(, "start": 30)", kB + rest); };
  CHECK(parse(with(R"(, "start": 10, "follows": { "joint": "A", "ratio": 2 })"))
            .model.joints[1]
            .follows->offset == Approx(-50 * kPi / 180));
  CHECK(parse(with(R"(, "start": 10, "follows": { "joint": "A", "ratio": 2, "offset": -50 })"))
            .model.joints[1]
            .follows);
  check_refused(with(R"(, "start": 10, "follows": { "joint": "A", "ratio": 2, "offset": -49 })"),
                {"/joints/1/follows/offset", "-50"});
  check_refused(two(kA, kC + R"(, "follows": { "joint": "A", "ratio": 2, "offset": 0.1 })"),
                {"/joints/1/follows/offset", "it is 0;"});
}

TEST_CASE("joints that cannot follow are refused", "[scene]") {
  const auto with = [](const std::string& rest) { return two(kA, kB + rest); };
  const std::string at = "/joints/1/follows";
  check_refused(with(R"(, "follows": "A")"), {at});
  check_refused(with(R"(, "follows": { "ratio": 2 })"), {at + "/joint", "missing"});
  check_refused(with(R"(, "follows": { "joint": "A" })"), {at + "/ratio", "missing"});
  check_refused(with(R"(, "follows": { "joint": "A", "ratio": 0 })"), {at + "/ratio", "is 0"});
  check_refused(with(R"(, "follows": { "joint": "Q", "ratio": 1 })"), {at + "/joint", "no joint is named"});
  check_refused(with(R"(, "follows": { "joint": "B", "ratio": 1 })"),
                {at + "/joint", "cannot follow itself"});
  check_refused(with(R"(, "drive": { "value": 3 }, "follows": { "joint": "A", "ratio": 1 })"),
                {at, "driven"});
  check_refused(with(R"(, "lead": 1)"), {"/joints/1/lead", "unknown key"});
  check_refused(two(R"("name": "ball", "type": "spherical", "bodies": [null, "a"], "anchor": [0, 0, 0])",
                    kB + R"(, "follows": { "joint": "ball", "ratio": 1 })"),
                {at + "/joint", "spherical", "hinge"});
  check_refused(two(kA, kD + R"(, "twist": "locked", "lead": 1)"), {"/joints/1/lead", "locked"});
  check_refused(two(kA, kD + R"(, "lead": 1, "follows": { "joint": "A", "ratio": 1 })"), {"/joints/1/lead"});
}

TEST_CASE("a scene built in C++ has joints that follow", "[scene]") {
  SceneBuilder builder("scene");
  builder.add(spec::Body{.name = "a"});
  builder.add(spec::Body{.name = "b", .position = Vec3(2, 0, 0)});
  builder.add(spec::Joint{
      .type = JointType::hinge, .j = "a", .name = "A", .anchor = Vec3(0, 0, 0), .axis = Vec3::UnitZ()});
  builder.add(spec::Joint{.type = JointType::cylindrical,
                          .j = "b",
                          .anchor = Vec3(2, 0, 0),
                          .axis = Vec3::UnitX(),
                          .follows = spec::Follows{"A", 0.5}});
  const Scene s = builder.build();
  CHECK(s.model.joints[1].follows->leader == 0);
  CHECK(s.model.joints[1].follows->ratio == 0.5);
}

TEST_CASE("turns are counted on by saved scenes, state files and recordings", "[scene]") {
  const double h = 1.0 / 60;
  Session run(parse(kTurning));
  while (run.state().time < 4 - h / 2) run.step();
  CHECK(run.state().coupling.size() == 2);
  const double turned = 0.5 * 1.0 / (2 * (1 + 0.04) / 12) * 16;  // about, were it alone
  REQUIRE(run.state().c[2].x() - 4 > 0.2 * kPi);                 // more than a turn of A
  CHECK(run.state().c[2].x() - 4 < 0.1 * turned);

  const State read = state_from_json(run.model(), state_to_json(run.model(), run.state()), "state.json");
  CHECK(same_bits(read, run.state()));
  CHECK(state_hash(read) == state_hash(run.state()));
  State other = run.state();
  other.coupling[1] += 1e-12;
  CHECK(state_hash(other) != state_hash(run.state()));
  CHECK_FALSE(same_bits(other, run.state()));

  Session again(parse(saved(run)));
  for (int k = 0; k < 60; ++k) {
    run.step();
    again.step();
  }
  CHECK((run.state().c[2] - again.state().c[2]).norm() < 1e-6);
  CHECK((run.state().R[1] - again.state().R[1]).norm() < 1e-6);
}

TEST_CASE("what followed a joint that is removed moves freely; the others go on", "[scene]") {
  Session run(parse(joints("{" + kA + "}, {" + kB + R"(, "follows": { "joint": "A", "ratio": 2 } }, {)" + kC +
                           R"(, "follows": { "joint": "B", "ratio": 0.5 } })")));
  for (int k = 0; k < 30; ++k) run.step();
  const double kept = run.state().coupling[1];
  run.edit(RemoveJoint{0});
  REQUIRE(run.model().joints.size() == 2);
  CHECK_FALSE(run.model().joints[0].follows);
  REQUIRE(run.model().joints[1].follows);
  CHECK(run.model().joints[1].follows->leader == 0);
  REQUIRE(run.state().coupling.size() == 1);
  CHECK(run.state().coupling[0] == kept);
  for (int k = 0; k < 30; ++k) run.step();
  CHECK(run.report().max_joint_error < 1e-6);
}

}  // namespace pabd::test_read_couplings
