// SPDX-License-Identifier: MIT
// What scenes say that were saved in mid-run: joints away from their zero, and what contacts remember.
#include "sim/joint/expand.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_mid_run {

using namespace test;

namespace {

std::string scene_with(const std::string& members) {
  return scene_text(R"("bodies": [
    { "name": "a", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 1, 0] },
    { "name": "b", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [2, 1, 0] },
    { "name": "c", "shape": { "type": "plane" } } ], )" +
                    members);
}

std::string with_joint(const std::string& joint) { return scene_with("\"joints\": [ { " + joint + " } ]"); }

// Frames about z, that of b turned on by 60 degrees and 0.1 m away.
const std::string kPlace =
    R"("bodies": ["a", "b"], "anchors": [[1, 1, 0], [1, 1.1, 0]],
       "frames": [[0.70710678118654757, 0, -0.70710678118654757, 0],
                  [0.61237243569579458, 0.35355339059327379, -0.61237243569579458, 0.35355339059327379]])";

PlacedFrame stands(const Scene& scene, Index body, const JointFrame& frame) {
  const auto i = static_cast<std::size_t>(body);
  return place(frame, {scene.initial.c[i], scene.initial.R[i]});
}

}  // namespace

TEST_CASE("anchors and frames of a joint stand where the file says, away from zero", "[scene]") {
  const Scene scene = parse(with_joint(R"("type": "hinge", )" + kPlace + R"(, "limits": [10, 90])"));
  const Joint& joint = scene.model.joints.at(0);
  const PlacedFrame on_a = stands(scene, 0, joint.on_i), on_b = stands(scene, 1, joint.on_j);
  CHECK((on_a.y - Vec3(1, 1, 0)).norm() < 1e-15);
  CHECK((on_b.y - Vec3(1, 1.1, 0)).norm() < 1e-15);
  CHECK((on_a.F.col(0) - on_b.F.col(0)).norm() < 1e-15);
  CHECK((on_a.F.col(0) - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(joint_angle(on_a, on_b) == Approx(kPi / 3).epsilon(1e-14));
  REQUIRE(joint.limits);  // 0 need not lie between
  CHECK(joint.limits->lo == Approx(10 * kPi / 180));
  CHECK(parse(with_joint(R"("type": "hinge", )" + kPlace)).hash !=
        parse(with_joint(R"("type": "hinge", )" + kPlace), {"joints.0.anchors.1.2=0.5"}).hash);
  CHECK(parse(with_joint(R"("type": "hinge", )" + kPlace)).hash !=
        parse(with_joint(R"("type": "hinge", )" + kPlace), {"joints.0.frames.0=[1,0,0,0]"}).hash);
  for (const char* type : {"spherical", "slider", "fixed"})
    CHECK(parse(with_joint(R"("type": ")" + std::string(type) + "\", " + kPlace)).model.joints.size() == 1);
}

TEST_CASE("what friction remembers arrives in the state and counts in the hash", "[scene]") {
  const std::string text = scene_with(R"("friction_anchors": [
    { "bodies": [0, 1], "feature": 7, "stretch": [0.001, 0, 0] },
    { "bodies": [1, 2], "feature": 4294967295, "stretch": [0, 0, 0.002], "sliding": true } ])");
  const Scene scene = parse(text);
  REQUIRE(scene.initial.contacts.size() == 2);
  CHECK(scene.initial.contacts[0].pair == 1);
  CHECK(scene.initial.contacts[0].feature == 7);
  CHECK(scene.initial.contacts[0].stretch == Vec3(0.001, 0, 0));
  CHECK_FALSE(scene.initial.contacts[0].sliding);
  CHECK(scene.initial.contacts[1].pair == ((std::uint64_t{1} << 32) | 2));
  CHECK(scene.initial.contacts[1].feature == 0xffffffffu);
  CHECK(scene.initial.contacts[1].sliding);
  for (const char* change : {"friction_anchors.0.feature=8", "friction_anchors.0.stretch.1=1",
                             "friction_anchors.0.sliding=true", "friction_anchors.0.bodies.1=2"})
    CHECK(parse(text, {change}).hash != scene.hash);
}

TEST_CASE("joint forces arrive in the state and counts in the hash", "[scene]") {
  const std::string text = scene_with(R"("joint_forces": [[1, 2, 3]],
    "joints": [ { "type": "spherical", "bodies": ["a", "b"], "anchor": [1, 1, 0] } ])");
  const Scene scene = parse(text);
  REQUIRE(scene.initial.joint_force.size() == 1);
  CHECK(scene.initial.joint_force[0] == Vec3(1, 2, 3));
  CHECK(parse(text, {"joint_forces.0.2=4"}).hash != scene.hash);
  check_refused(text, {"/joint_forces", "each of 1 joints, got 2"}, {"joint_forces=[[0,0,0],[0,0,0]]"});
}

TEST_CASE("half a place and anchors of nothing are refused", "[scene]") {
  const std::string hinge = R"("type": "hinge", )";
  check_refused(with_joint(hinge + kPlace + R"(, "anchor": [0, 0, 0])"), {"/joints/0/anchor", "remove"});
  check_refused(with_joint(hinge + kPlace + R"(, "axis": [0, 0, 1])"), {"/joints/0/axis", "remove"});
  check_refused(with_joint(hinge + R"("bodies": ["a", "b"], "anchors": [[0, 0, 0], [0, 0, 0]])"),
                {"/joints/0/frames", "two unit quaternions"});
  check_refused(with_joint(hinge + R"("bodies": ["a", "b"], "frames": [[1, 0, 0, 0], [1, 0, 0, 0]])"),
                {"/joints/0/anchors", "two points"});
  check_refused(with_joint(hinge + kPlace), {"/joints/0/frames/1", "length"},
                {"joints.0.frames.1=[1,1,0,0]"});
  check_refused(with_joint(hinge + kPlace), {"/joints/0/frames", "two"}, {"joints.0.frames=[[1,0,0,0]]"});
  check_refused(with_joint(hinge + kPlace), {"/joints/0/anchors/0"}, {"joints.0.anchors.0=[1,2]"});

  const auto anchors = [](const std::string& list) {
    return scene_with("\"friction_anchors\": [ " + list + " ]");
  };
  check_refused(anchors(R"({ "bodies": [0, 3], "feature": 1, "stretch": [0, 0, 0] })"),
                {"/friction_anchors/0/bodies/1"});
  check_refused(anchors(R"({ "bodies": [1, 0], "feature": 1, "stretch": [0, 0, 0] })"), {"rising order"});
  check_refused(anchors(R"({ "bodies": [0, 1], "feature": 1 })"), {"/friction_anchors/0/stretch"});
  check_refused(anchors(R"({ "bodies": [0, 1], "feature": 1, "stretch": [0, 0, 0] },
                           { "bodies": [0, 1], "feature": 1, "stretch": [0, 0, 0] })"),
                {"/friction_anchors/1", "each once"});
}

}  // namespace pabd::test_mid_run
