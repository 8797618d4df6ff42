// SPDX-License-Identifier: MIT
// Joints that start away from 0: bodies stand where kinematics puts them, loops must close.
#include <Eigen/Geometry>
#include <cmath>

#include "sim/joint/expand.h"
#include "sim/scene/write_scene.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_start_pose {

using namespace test;

namespace {

Mat3 about_z(double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitZ()).toRotationMatrix();
}

std::string box(const std::string& name, double x, double y) {
  return "{ \"name\": \"" + name + R"(", "shape": { "type": "box", "size": [1, 0.1, 0.1] }, "position": [)" +
         std::to_string(x) + ", " + std::to_string(y) + ", 0] }";
}
std::string hinge(const std::string& i, const std::string& j, double x, double y, const std::string& more) {
  return R"({ "type": "hinge", "axis": [0, 0, 1], "bodies": [)" + i + ", " + j + R"(], "anchor": [)" +
         std::to_string(x) + ", " + std::to_string(y) + ", 0]" + more + " }";
}

// Two links of 1 m from the origin along x, and a block on a slider at their end.
std::string arm(const std::string& first, const std::string& second, const std::string& third,
                const std::string& base = "null") {
  return scene_text("\"bodies\": [" + box("u", 0.5, 0) + "," + box("f", 1.5, 0) + "," + box("h", 2.5, 0) +
                    "," + box("o", 0, 9) + "], \"joints\": [" + hinge(base, "\"u\"", 0, 0, first) + "," +
                    hinge("\"u\"", "\"f\"", 1, 0, second) +
                    R"(, { "type": "slider", "bodies": ["f", "h"], "anchor": [2, 0, 0], "axis": [1, 0, 0])" +
                    third + " } ]");
}

double measured(const Scene& scene, std::size_t k) {
  const Joint& joint = scene.model.joints[k];
  const auto frame = [&](const JointFrame& on, Index body) {
    if (body == kWorld) return PlacedFrame{on.r, on.F};
    const auto b = static_cast<std::size_t>(body);
    return place(on, {scene.initial.c[b], scene.initial.R[b]});
  };
  return moved_measure(traits_of(joint.type))->value(frame(joint.on_i, joint.i), frame(joint.on_j, joint.j));
}

}  // namespace

TEST_CASE("an arm starts where its angles put it", "[scene]") {
  const Scene s =
      parse(arm(R"(, "start": 30)", R"(, "start": -75, "limits": [-90, -10])", R"(, "start": 0.2)"));
  const Vec3 elbow = about_z(30) * Vec3(1, 0, 0);
  CHECK((s.initial.c[0] - 0.5 * elbow).norm() < 1e-14);
  CHECK((s.initial.R[0] - about_z(30)).norm() < 1e-14);
  CHECK((s.initial.c[1] - (elbow + about_z(-45) * Vec3(0.5, 0, 0))).norm() < 1e-14);
  CHECK((s.initial.c[2] - (elbow + about_z(-45) * Vec3(1.7, 0, 0))).norm() < 1e-14);
  CHECK((s.initial.R[2] - about_z(-45)).norm() < 1e-14);
  CHECK(s.initial.c[3] == Vec3(0, 9, 0));  // hangs on nothing
  CHECK(measured(s, 0) == Approx(30 * kDegree));
  CHECK(measured(s, 1) == Approx(-75 * kDegree));
  CHECK(measured(s, 2) == Approx(0.2));
}

TEST_CASE("what hangs on the world stays there, whichever body of a joint is named first", "[scene]") {
  // The far body is fixed to the world, and is the second of the hinge: its first one moves.
  const Scene s =
      parse(scene_text("\"bodies\": [" + box("u", 0.5, 0) + "," + box("f", 1.5, 0) + "], \"joints\": [" +
                       R"({ "type": "fixed", "bodies": ["f", null], "anchor": [2, 0, 0] }, )" +
                       hinge("\"u\"", "\"f\"", 1, 0, R"(, "start": 90)") + "]"));
  CHECK(s.initial.c[1] == Vec3(1.5, 0, 0));
  CHECK((s.initial.c[0] - Vec3(1, 0.5, 0)).norm() < 1e-14);
  CHECK(measured(s, 1) == Approx(kPi / 2));
  // Nothing is held: the body that is never second stays.
  const Scene floats = parse(arm("", R"(, "start": 90)", "", "\"o\""));
  CHECK(floats.initial.c[0] == Vec3(0.5, 0, 0));
  CHECK((floats.initial.c[1] - Vec3(1, 0.5, 0)).norm() < 1e-14);
}

TEST_CASE("a loop must close where its joints start", "[scene]") {
  // A parallelogram of links of 1 m on the world, 1 m apart.
  const auto four_bar = [](const std::string& crank, const std::string& coupler, const std::string& rocker) {
    return scene_text("\"bodies\": [" + box("u", 0.5, 0) + "," + box("c", 1.5, 0) + "," +
                      box("r", 1.5, 0.001) + "], \"joints\": [" + hinge("null", "\"u\"", 0, 0, crank) + "," +
                      hinge("\"u\"", "\"c\"", 1, 0, coupler) + "," + hinge("null", "\"r\"", 1, 0, rocker) +
                      "," + hinge("\"c\"", "\"r\"", 2, 0, "") + "]");
  };
  const Scene s = parse(four_bar(R"(, "start": 60)", R"(, "start": -60)", R"(, "start": 60)"));
  CHECK((s.initial.c[1] - (about_z(60) * Vec3(1, 0, 0) + Vec3(0.5, 0, 0))).norm() < 1e-14);
  CHECK(measured(s, 3) == Approx(60 * kDegree));
  check_refused(four_bar(R"(, "start": 60)", "", ""), {"/joints/3", "closes a loop", "open by 2 m"});
  check_refused(four_bar(R"(, "start": 60)", R"(, "start": -60)", R"(, "start": 50)"), {"/joints/3", "loop"});
}

TEST_CASE("starts that cannot be are refused, others are not asked for anything", "[scene]") {
  check_refused(arm(R"(, "start": 200)", "", ""), {"/joints/0/start", "degrees"});
  check_refused(arm(R"(, "start": 50, "limits": [-10, 40])", "", ""),
                {"/joints/0/limits", "at 50", "include 50"});
  check_refused(arm("", "", R"(, "start": 2e6)"), {"/joints/2/start", "(m)"});
  check_refused(arm("", "", R"(, "start": 999999.5)"), {"/joints", "a start moves a body"});
  check_refused(scene_text("\"bodies\": [" + box("u", 0.5, 0) +
                           R"(], "joints": [ { "type": "hinge", "bodies": [null, "u"],
      "anchors": [[0, 0, 0], [0, 0, 0]], "frames": [[1, 0, 0, 0], [1, 0, 0, 0]], "start": 5 } ])"),
                {"/joints/0/start", "\"frames\""});
  check_refused(
      scene_text(
          "\"bodies\": [" + box("u", 0.5, 0) +
          R"(], "joints": [ { "type": "spherical", "bodies": [null, "u"], "anchor": [0, 0, 0], "start": 5 } ])"),
      {"/joints/0/start", "unknown key"});
  CHECK(parse(arm(R"(, "start": 0)", "", "")).initial.c[1] == Vec3(1.5, 0, 0));
}

TEST_CASE("a scene that starts in a pose is saved in it", "[scene]") {
  const Scene s = parse(arm(R"(, "start": 30)", R"(, "start": -75, "limits": [-90, -10])", ""));
  const Scene again =
      parse(scene_to_json(s.model, s.initial, s.params, s.joint_law, "saved", {}, {}, parameter_table(), {}));
  for (std::size_t i = 0; i < s.initial.c.size(); ++i)
    CHECK((s.initial.c[i] - again.initial.c[i]).norm() < 1e-14);
  CHECK(measured(again, 1) == Approx(-75 * kDegree));
}

}  // namespace pabd::test_start_pose
