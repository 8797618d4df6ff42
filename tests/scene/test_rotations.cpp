// SPDX-License-Identifier: MIT
// Orientations as quaternions, as an axis with its angle, and as Euler angles.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <set>

#include "sim/scene/builder.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_rotations {

using namespace test;

namespace {

std::string body(const std::string& orientation) {
  return only_body(R"({ "shape": { "type": "box", "size": [1, 2, 3] }, "orientation": )" + orientation +
                   " }");
}

Mat3 read(const std::string& orientation) { return parse(body(orientation)).initial.R[0]; }

Mat3 about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, Vec3::Unit(axis)).toRotationMatrix();
}

}  // namespace

TEST_CASE("an axis and an angle turn by the right-hand rule", "[scene]") {
  const Mat3 R = read(R"({ "axis": [1, 2, -2], "angle": 50 })");
  const Vec3 axis = Vec3(1, 2, -2) / 3;
  CHECK((R - Eigen::AngleAxisd(50 * kDegree, axis).toRotationMatrix()).norm() < 1e-15);
  CHECK((read(R"({ "axis": [0, 0, 9], "angle": 30 })") * Vec3::UnitX() - Vec3(std::cos(30 * kDegree), 0.5, 0))
            .norm() < 1e-15);
  // The same as a quaternion.
  const double c = std::cos(25 * kDegree), s = std::sin(25 * kDegree) / 3;
  CHECK((R - Quat(c, s, 2 * s, -2 * s).toRotationMatrix()).norm() < 1e-15);
}

TEST_CASE("quarter turns are exact", "[scene]") {
  Mat3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Mat3 half = quarter * quarter, three = half * quarter;
  for (const auto& [angle, expected] :
       {std::pair{"90", quarter}, std::pair{"180", half}, std::pair{"-180", half}, std::pair{"270", three},
        std::pair{"-90", three}, std::pair{"360", Mat3(Mat3::Identity())}, std::pair{"-270", quarter}}) {
    INFO(angle);
    CHECK(read(R"({ "axis": [0, 0, 2], "angle": )" + std::string(angle) + " }") == expected);
    CHECK(read(R"({ "euler": [0, 0, )" + std::string(angle) + "] }") == expected);
  }
}

TEST_CASE("Euler angles turn about the body's own axes, in any of twelve orders", "[scene]") {
  const double a = 20, b = -35, c = 110;
  for (const std::string order :
       {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"}) {
    INFO(order);
    const Mat3 expected = about(order[0] - 'x', a) * about(order[1] - 'x', b) * about(order[2] - 'x', c);
    const Mat3 R = read(R"({ "euler": [20, -35, 110], "order": ")" + order + "\" }");
    CHECK((R - expected).norm() < 1e-15);
    CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-15);
    if (order == "xyz") CHECK(read(R"({ "euler": [20, -35, 110] })") == R);
  }
  // Roll, pitch and yaw about axes that stay are those of the body in the opposite order.
  CHECK((read(R"({ "euler": [110, -35, 20], "order": "zyx" })") - about(2, c) * about(1, b) * about(0, a))
            .norm() < 1e-15);
}

TEST_CASE("what is no orientation is refused", "[scene]") {
  const std::string at = "/bodies/0/orientation";
  check_refused(body(R"({ "axis": [0, 0, 0], "angle": 3 })"), {at + "/axis", "not zero"});
  check_refused(body(R"({ "axis": [0, 1, 0] })"), {at + "/angle", "missing"});
  check_refused(body(R"({ "angle": 30 })"), {at + "/axis", "missing"});
  check_refused(body(R"({ "axis": [0, 1, 0], "angle": 361 })"), {at + "/angle", "-360 to 360 (degrees)"});
  check_refused(body(R"({ "axis": [0, 1, 0], "angle": 3, "euler": [1, 2, 3] })"), {at, "not both"});
  check_refused(body(R"({ "euler": [1, 2] })"), {at + "/euler", "an array of 3 numbers"});
  check_refused(body(R"({ "euler": [1, 2, 3], "order": "xyy" })"), {at + "/order", "\"xyz\""});
  check_refused(body(R"({ "order": "xyz" })"), {at + "/euler", "missing"});
  check_refused(body(R"({ "euler": [1, 2, 3], "ordre": "xyz" })"), {at + "/ordre", "did you mean \"order\""});
  check_refused(body("30"), {at, "quaternion", "\"axis\"", "\"euler\""});
  for (const char* neither : {"{}", R"({ "euler_degrees": [0, 30, 0] })"})
    check_refused(body(neither), {at, "quaternion", "\"axis\"", "\"euler\""});
  check_refused(only_body(R"({ "shape": { "type": "plane" }, "orientation": { "euler": [0, 0, 9] } })"),
                {at});
}

TEST_CASE("every number and word of an orientation enters the hash", "[scene]") {
  std::set<std::string> seen;
  for (const char* text :
       {"[1, 0, 0, 0]", R"({ "axis": [0, 1, 0], "angle": 0 })", R"({ "axis": [0, 1, 0], "angle": 1 })",
        R"({ "axis": [1, 0, 0], "angle": 1 })", R"({ "euler": [0, 0, 0] })", R"({ "euler": [0, 1, 0] })",
        R"({ "euler": [0, 1, 0], "order": "zyx" })"})
    CHECK(seen.insert(parse(body(text)).hash).second);
  CHECK(parse(body(R"({ "euler": [0, 1, 0], "order": "xyz" })")).hash ==
        parse(body(R"({ "euler": [0, 1, 0] })")).hash);
}

TEST_CASE("a builder has the three ways of a file", "[scene]") {
  const auto built = [](const spec::Orientation& orientation) {
    SceneBuilder builder("test");
    builder.add(spec::Body{.shape = Box{{0.5, 1, 1.5}}, .orientation = orientation});
    return builder.build();
  };
  const auto check = [](const Scene& a, const std::string& text) {
    const Scene b = parse(body(text), {"name=test"});
    CHECK(a.hash == b.hash);
    CHECK(a.initial.R[0] == b.initial.R[0]);
  };
  check(built(spec::Orientation(0.6, 0, 0.8, 0)), "[0.6, 0, 0.8, 0]");
  check(built(spec::AxisAngle{Vec3(1, 1, 0), 40}), R"({ "axis": [1, 1, 0], "angle": 40 })");
  check(built(spec::Euler{Vec3(10, 20, 30), "zxz"}), R"({ "euler": [10, 20, 30], "order": "zxz" })");
}

TEST_CASE("frames of joints stand in any of the ways", "[scene]") {
  const auto joint = [](const std::string& frame) {
    return parse(with_body(R"("joints": [{ "type": "hinge", "bodies": [null, "ball"],
      "anchors": [[0, 1, 0], [0, 1, 0]], "frames": [)" +
                           frame + ", " + frame + "] }]"));
  };
  const Scene angle = joint(R"({ "axis": [0, 0, 1], "angle": 90 })");
  const double half = std::sqrt(0.5);
  const Scene quaternion = joint(fmt::format("[{}, 0, 0, {}]", half, half));
  CHECK((angle.model.joints[0].on_i.F - quaternion.model.joints[0].on_i.F).norm() < 1e-15);
  CHECK(angle.model.joints[0].on_i.F.col(0) == Vec3(0, 1, 0));
}

}  // namespace pabd::test_rotations
