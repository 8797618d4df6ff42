// SPDX-License-Identifier: MIT
// Matter that is not spread evenly, corners in the scene itself, and pairs that never touch.
#include <fmt/format.h>

#include "sim/body/mass_properties.h"
#include "sim/scene/write_scene.h"
#include "sim/solver/time_step.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_inertia {

using namespace test;

namespace {

const std::string kBox = R"("shape": { "type": "box", "size": [1, 1, 1] })";
const std::string kCorners = "[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]";

State after(const Scene& scene, double time) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  while (state.time < time) step(scene.model, scene.params, {}, state, workspace, report);
  return state;
}

}  // namespace

TEST_CASE("a body has the inertia that it is given", "[scene]") {
  const Scene s = parse(only_body("{ " + kBox + R"(, "mass": 2, "inertia": [3, 4, 5, 0.1, 0.2, 0.3] })"));
  Mat3 I;
  I << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
  CHECK(s.model.mass[0] == 2);
  CHECK((inertia_tensor(s.model.J[0]) - I).norm() < 1e-14);
  // It is written, and read back.
  const std::string text = scene_to_json(s.model, s.initial, s.params, s.joint_law, s.name, {}, {});
  CHECK((parse(text).model.J[0] - s.model.J[0]).norm() < 1e-14);
}

TEST_CASE("laminas and rods are bodies, also where a file rounds their moments", "[scene]") {
  for (const Vec3& moments :
       {Vec3(1, 1, 2), Vec3(0.333333, 0.666667, 1), Vec3(3, 1, 2), Vec3(0, 1, 1), Vec3(1, 1, 1e-9)}) {
    CAPTURE(moments.transpose());
    const Scene s = parse(only_body(fmt::format(
        R"({{ {}, "mass": 2, "inertia": [{}, {}, {}, 0, 0, 0], "angular_velocity": [20, 90, 40] }})", kBox,
        moments.x(), moments.y(), moments.z())));
    const Vec3 found = inertia_tensor(s.model.J[0]).diagonal();
    CHECK((found - moments).cwiseAbs().maxCoeff() < 3e-6 * moments.sum());
    CHECK(found.minCoeff() > 0);
    const State end = after(s, 3);
    CHECK(end.R[0].allFinite());
    const auto spin = [&](const State& state) -> Vec3 {
      return state.R[0] * inertia_tensor(s.model.J[0]) * state.R[0].transpose() * state.omega[0];
    };
    CHECK((spin(end) - spin(s.initial)).norm() < 1e-9 * spin(s.initial).norm());
  }
}

// Gauss, Huygens: T = 2π √(2 L/3 g) for small swings.
TEST_CASE("a rod without thickness swings as one of length 2 L/3", "[scene]") {
  const Scene s = parse(scene_text(
      R"("time_step": 0.002, "bodies": [{ "name": "rod", "mass": 3, "inertia": [0.25, 0, 0.25, 0, 0, 0],
    "shape": { "type": "box", "size": [0.02, 1, 0.02] }, "position": [0.005, -0.5, 0] }],
    "joints": [{ "type": "hinge", "bodies": [null, "rod"], "anchor": [0, 0, 0], "axis": [0, 0, 1] }])"));
  const double quarter = 0.5 * kPi * std::sqrt(2.0 / 3 / 9.81);
  CHECK(after(s, 0.95 * quarter).c[0].x() > 0);
  CHECK(after(s, 1.05 * quarter).c[0].x() < 0);
}

TEST_CASE("moments that no body has are refused", "[scene]") {
  const auto body = [](const std::string& rest) { return only_body("{ " + kBox + ", " + rest + " }"); };
  check_refused(body(R"("inertia": [1, 1, 1, 0, 0, 0])"), {"/bodies/0/inertia", "\"mass\""});
  check_refused(body(R"("mass": 1, "inertia": [1, 1, 3, 0, 0, 0])"), {"no body has these moments"});
  check_refused(body(R"("mass": 1, "inertia": [1, 1, 1, 5, 0, 0])"), {"no body has these moments"});
  check_refused(body(R"("mass": 1, "inertia": [-1, -1, -1, 0, 0, 0])"), {"no body has these moments"});
  check_refused(body(R"("mass": 1, "inertia": [1, 1, 1])"), {"/bodies/0/inertia"});
}

TEST_CASE("parts are corners about the centre of mass, or wherever", "[scene]") {
  const auto with = [](const std::string& rest) {
    return parse(only_body(R"({ "shape": { "type": "mesh", "parts": [)" + kCorners + "] }" + rest + " }"));
  };
  // Even matter: the centre of mass of a tetrahedron is the mean of its corners, and the body's place.
  const Scene even = with("");
  CHECK((bounds(even.model.shape[0], Vec3::Zero(), Mat3::Identity()).lo - Vec3::Constant(-0.25)).norm() <
        1e-12);
  CHECK(even.model.mass[0] == Approx(1000.0 / 6).epsilon(1e-12));
  // Told otherwise the numbers stand as they are.
  const Scene told = with(R"(, "mass": 1, "inertia": [1, 1, 1, 0, 0, 0])");
  CHECK(bounds(told.model.shape[0], Vec3::Zero(), Mat3::Identity()).lo.norm() < 1e-12);
  check_refused(only_body(R"({ "shape": { "type": "mesh", "parts": [] } })"), {"/bodies/0/shape/parts"});
  check_refused(only_body(R"({ "shape": { "type": "mesh", "parts": [[[0,0,0]]] } })"),
                {"/bodies/0/shape/parts/0"});
  check_refused(only_body(R"({ "shape": { "type": "mesh", "file": "a.obj", "parts": [)" + kCorners + "] } }"),
                {"/bodies/0/shape/file"});
}

TEST_CASE("pairs that never touch fall through each other, and stay so when saved", "[scene]") {
  const std::string bodies =
      R"("bodies": [ { "name": "a", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 1.2, 0] },
                     { "name": "b", "shape": { "type": "box", "size": [2, 1, 2] }, "fixed": true } ])";
  const Scene meet = parse(scene_text(bodies));
  const Scene apart = parse(scene_text(bodies + R"(, "no_collide": [["b", "a"]])"));
  CHECK(after(meet, 1).c[0].y() > 0.99);
  const State fallen = after(apart, 1);
  CHECK(fallen.c[0].y() < -3);
  CHECK(meet.hash != apart.hash);
  const std::string text =
      scene_to_json(apart.model, fallen, apart.params, apart.joint_law, apart.name, {}, {});
  CHECK(parse(text).model.no_collide == apart.model.no_collide);
  check_refused(scene_text(bodies + R"(, "no_collide": [["a", "c"]])"), {"/no_collide/0/1", "no body \"c\""});
  check_refused(scene_text(bodies + R"(, "no_collide": [["a", "a"]])"), {"/no_collide/0"});
  check_refused(scene_text(bodies + R"(, "no_collide": [["a", null]])"), {"/no_collide/0/1"});
}

}  // namespace pabd::test_inertia
