// SPDX-License-Identifier: MIT
// How the root of a URDF stands, and where the ground under it is.
#include "tests/import/import_helpers.h"

namespace pabd::test_base {

using namespace test;

namespace {

std::string mass(const std::string& value) {
  return "<inertial><mass value='" + value + "'/><inertia ixx='1' iyy='1' izz='1'/></inertial>";
}

std::string ball(const std::string& radius, const std::string& kind = "collision",
                 const std::string& at = "0 0 0") {
  return "<" + kind + "><origin xyz='" + at + "'/><geometry><sphere radius='" + radius + "'/></geometry></" +
         kind + ">";
}

std::string joint(const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& at) {
  return "<joint name='" + child + " joint' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin xyz='" + at + "'/></joint>";
}

// A root without mass, what stands on it, and a part that turns.
std::string cart(const std::string& part, const std::string& more = "") {
  return "<robot name='r'><link name='base_link'/><link name='hull'>" + mass("5") + ball("0.2") +
         "</link><link name='" + part + "'>" + mass("1") + ball("0.1", "collision", "0 0 -0.05") + "</link>" +
         joint("fixed", "base_link", "hull", "0 0 0") + joint("continuous", "hull", part, "0.5 0 -0.3") +
         more + "</robot>";
}

ImportedScene imported(const std::string& text, RobotBase base = RobotBase::automatic) {
  return import_robot_text(text, "r.urdf", {}, {.base = base});
}

}  // namespace

TEST_CASE("a root without mass floats where the robot has wheels or feet, else it is fixed", "[import]") {
  const auto base = [](const std::string& part, RobotBase told = RobotBase::automatic) {
    return note_with(imported(cart(part), told), "the root ").text;
  };
  CHECK_THAT(base("left_wheel"),
             Catch::StartsWith("the root floats: it has no mass, but the robot has \"left_wheel\""));
  CHECK_THAT(base("RF_FOOT"), Catch::StartsWith("the root floats"));
  CHECK_THAT(base("arm"), Catch::StartsWith("the root is fixed to the world: it has no mass"));
  CHECK(base("arm", RobotBase::floating) == "the root floats: as --base says");
  CHECK(base("left_wheel", RobotBase::fixed) == "the root is fixed to the world: as --base says");
}

TEST_CASE("a robot that floats stands on its lowest shape that touches, and not on what has none",
          "[import]") {
  // A mark without shape whose inertia is that of a box of 11 m, and one that is only seen.
  const std::string marks = "<link name='mark'>" + mass("0.05") + "</link><link name='seen'>" + mass("0.1") +
                            ball("2", "visual") + "</link>" + joint("continuous", "hull", "mark", "0.3 0 0") +
                            joint("continuous", "hull", "seen", "0.3 0 0");
  ImportedRun run(imported(cart("wheel", marks)).text);
  const Plane* ground = std::get_if<Plane>(&run.scene.model.shape[0]);
  REQUIRE(ground);
  CHECK(ground->offset == Approx(-0.45 - run.scene.params.contact.d_hat));
  const std::size_t mark = run.body("mark");
  CHECK(run.scene.looks.at("mark").opacity == 0);
  CHECK(bounding_radius(run.scene.model.shape[mark]) <= 0.05);
  CHECK(run.scene.model.mass[mark] == Approx(0.05));
}

TEST_CASE("what stands still and is only seen is drawn, and touches nothing", "[import]") {
  const std::string text = "<robot name='r'><link name='world'>" + ball("0.2", "visual", "0 0 0.3") +
                           "</link><link name='a'>" + mass("1") + ball("0.2") + "</link>" +
                           joint("floating", "world", "a", "0 0 1") + "</robot>";
  ImportedRun run(import_robot_text(text, "r.urdf", {}, {.ground = false}).text);
  const std::size_t world = run.body("world"), a = run.body("a");
  CHECK(run.scene.model.fixed[world]);
  CHECK((run.state.c[world] - Vec3(0, 0.3, 0)).norm() < 1e-12);
  run.run(1);
  CHECK(run.state.c[a].y() == Approx(1 - 9.81 / 2).epsilon(5e-3));
}

TEST_CASE("a floating joint to a fixed root makes a link that floats", "[import]") {
  const std::string text = "<robot name='r'><link name='world'/><link name='a'>" + mass("1") + ball("0.1") +
                           "</link>" + joint("floating", "world", "a", "0 0 1") + "</robot>";
  ImportedRun run(imported(text).text, {"time_step=0.001", "solver.integrator=euler"});
  CHECK(run.scene.model.size() == 2);
  CHECK(run.scene.model.joints.empty());
  const std::size_t a = run.body("a");
  CHECK(run.state.c[a].y() == Approx(1));
}

}  // namespace pabd::test_base
