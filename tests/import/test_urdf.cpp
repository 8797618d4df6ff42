// SPDX-License-Identifier: MIT
// URDF: a pendulum against its period, a block on a rail against gravity, what stands on what.
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/joint/expand.h"
#include "tests/import/import_helpers.h"
#include "tests/support/places.h"

namespace pabd::test_urdf {

using namespace test;

namespace {

const std::filesystem::path kModels = places::tests() + "/import/models", kAssets = places::assets();

ImportedScene slider() {
  return import_robot_text(read_scene_text(kModels / "slider.urdf"), "slider.urdf", kAssets);
}

}  // namespace

TEST_CASE("a URDF pendulum with a turned inertial frame has the period of theory", "[import]") {
  const ImportedScene imported = import_robot(kModels / "pendulum.urdf");
  ImportedRun run(imported.text, {"time_step=0.001"});
  REQUIRE(run.scene.model.size() == 1);
  // The frame's x is the link's y.
  const Mat3 I = inertia_tensor(run.scene.model.J[0]);
  CHECK(I(0, 0) == Approx(0.17).epsilon(1e-12));
  CHECK(I(1, 1) == Approx(0.05).epsilon(1e-12));
  CHECK(I(2, 2) == Approx(0.17).epsilon(1e-12));
  // Crossings of the lowest place; the robot's y is the scene's -z.
  std::vector<double> crossings;
  double before = run.state.c[0].z();
  while (run.state.time < 5) {
    run.run(run.state.time + 0.001);
    const double now = run.state.c[0].z();
    if (before * now < 0) crossings.push_back(run.state.time - 0.001 * now / (now - before));
    before = now;
  }
  REQUIRE(crossings.size() >= 4);
  const double halves = static_cast<double>(crossings.size() - 1);
  const double period = 2 * (crossings.back() - crossings.front()) / halves;
  // T = 2π √(I/(m g d)) (1 + θ²/16), I about the hinge. Implicit steps lose a little amplitude, which is in θ².
  const double small = 2 * kPi * std::sqrt((0.17 + 2 * 0.25) / (2 * 9.81 * 0.5));
  CHECK(period == Approx(small * (1 + 0.2 * 0.2 / 16)).epsilon(2e-3));
}

TEST_CASE("a URDF block slides as gravity says, and stops at its limit", "[import]") {
  const ImportedScene imported = slider();
  ImportedRun run(imported.text, {"time_step=0.001", "solver.integrator=euler"});
  // World, rail and camera are one with what they stand on.
  REQUIRE(run.scene.model.size() == 1);
  CHECK(run.scene.model.name[0] == "block");
  CHECK(run.scene.model.mass[0] == Approx(3).epsilon(1e-14));
  CHECK((run.state.c[0] - Vec3(0, 1, 0)).norm() < 1e-12);
  run.run(0.3);
  // By Euler velocity first, then place: x = a h² n (n + 1)/2.
  const double n = 300, x = 9.81 * 0.5 * 1e-6 * n * (n + 1) / 2;
  const Vec3 along(std::cos(kPi / 6), -std::sin(kPi / 6), 0);
  CHECK(along.dot(run.state.c[0] - Vec3(0, 1, 0)) == Approx(x).epsilon(1e-5));
  run.run(1.5);
  CHECK(along.dot(run.state.c[0] - Vec3(0, 1, 0)) == Approx(0.4).margin(2e-3));
}

TEST_CASE("what URDF says and a scene cannot is told with its line", "[import]") {
  const ImportedScene imported = slider();
  const ImportNote mimic = note_with(imported, "follows \"bed\"");
  REQUIRE(mimic.where.size() == 1);
  CHECK(mimic.where[0] == std::pair(std::string("slider.urdf"), 26));
  CHECK(parse_scene(imported.text, "x", {}).description.find("follows \"bed\"") != std::string::npos);
}

TEST_CASE("a joint that mimics another follows it, from where both start", "[import]") {
  const auto robot = [](const std::string& mimic) {
    const auto link = [](const std::string& name, const std::string& at = "0 0 0") {
      return "<link name='" + name + "'><inertial><origin xyz='" + at +
             "'/><mass value='1'/><inertia ixx='.1' iyy='.1' "
             "izz='.1'/></inertial><collision><geometry>"
             "<sphere radius='0.1'/></geometry></collision></link>";
    };
    const auto joint = [](const std::string& name, const std::string& child, const std::string& rest) {
      return "<joint name='" + name + "' type='revolute'><parent link='base'/><child link='" + child +
             "'/><origin xyz='" + (child == "l" ? "1" : "2") + " 1 0'/><axis xyz='1 0 0'/>" + rest +
             "</joint>";
    };
    return import_robot_text("<robot name='r'>" + link("base") + link("l", "0 -0.5 0") + link("m") +
                                 joint("second", "m", "<limit lower='-3' upper='3'/>" + mimic) +
                                 joint("first", "l", "<limit lower='0.2' upper='1'/>") + "</robot>",
                             "r.urdf", {}, {RobotBase::fixed, false});
  };
  ImportedRun run(robot("<mimic joint='first' multiplier='-1.5' offset='0.4'/>").text);
  REQUIRE(run.scene.model.joints.size() == 2);
  const Joint& follower = run.scene.model.joints[1];
  REQUIRE(follower.name == "second");
  REQUIRE(follower.follows);
  CHECK(follower.follows->leader == 0);
  CHECK(follower.follows->ratio == -1.5);
  CHECK(follower.follows->offset == Approx(0.4));
  const auto angle = [&](std::size_t k) {
    const Joint& joint = run.scene.model.joints[k];
    return joint_angle(place(joint.on_i, joint.i, run.state), place(joint.on_j, joint.j, run.state));
  };
  CHECK(angle(0) == Approx(0.2));
  CHECK(angle(1) == Approx(0.1));
  run.run(1);
  CHECK(std::abs(angle(0) - 0.2) > 0.1);
  CHECK(angle(1) == Approx(0.4 - 1.5 * angle(0)).margin(1e-6));
  const auto freely = [&](const std::string& mimic) {
    return !parse_scene(robot(mimic).text, "r", {}).model.joints[1].follows;
  };
  CHECK(freely(""));
  CHECK(freely("<mimic joint='nothing'/>"));
  CHECK(freely("<mimic joint='second'/>"));
  CHECK(freely("<mimic joint='first' multiplier='0'/>"));
  const ImportedScene beyond = robot("<mimic joint='first' multiplier='50'/>");
  note_with(beyond, "starts beyond its range");
}

TEST_CASE("a link has the friction that <contact> says", "[import]") {
  const auto with = [](const std::string& contact) {
    const std::string robot = R"(<robot name="r"><link name="wheel">)" + contact +
                              R"(<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
         <collision><geometry><sphere radius="0.5"/></geometry></collision></link></robot>)";
    return parse_scene(import_robot_text(robot, "r.urdf", {}, {RobotBase::floating, true}).text, "r", {})
        .params.contact;
  };
  const ContactParams all = with(
      R"(<contact><lateral_friction value="1.5"/><rolling_friction value="0.01"/><spinning_friction value="0.02"/></contact>)");
  CHECK(all.mu_static == 1.5);
  CHECK(all.rolling == 0.01);
  CHECK(all.torsional == 0.02);
  CHECK(with(R"(<contact><stiffness value="1000"/></contact>)") == with(""));
  CHECK_THROWS_WITH(with(R"(<contact><rolling_friction value="-1"/></contact>)"),
                    Catch::Contains("is negative"));
}

TEST_CASE("the base of a URDF stands as it is told", "[import]") {
  const std::string robot =
      R"(<robot name="r"><link name="base"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
         <collision><geometry><sphere radius="0.5"/></geometry></collision></link></robot>)";
  const auto with = [&](RobotBase base, bool ground) {
    return parse_scene(import_robot_text(robot, "r.urdf", {}, {base, ground}).text, "r", {});
  };
  CHECK(with(RobotBase::automatic, true).model.name ==
        std::vector<std::string>{"ground under the robot", "base"});
  CHECK(with(RobotBase::floating, false).model.fixed == std::vector<std::uint8_t>{0});
  CHECK(with(RobotBase::fixed, true).model.fixed == std::vector<std::uint8_t>{1});
}

TEST_CASE("half a turn that was rounded up is half a turn, and a whole one is told with its line",
          "[import]") {
  const auto limits = [](const std::string& bounds) {
    const ImportedScene imported = import_robot_text(
        "<robot name='r'><link name='world'/><link name='arm'><inertial><mass value='1'/><inertia ixx='1' "
        "iyy='1' "
        "izz='1'/></inertial></link>\n<joint name='j' type='revolute'><parent link='world'/><child "
        "link='arm'/><limit " +
            bounds + "/></joint></robot>",
        "r.urdf", {});
    return std::pair(imported, parse_scene(imported.text, "r", {}).model.joints.at(0).limits);
  };
  const auto [rounded, held] = limits("lower='-1.9199' upper='3.1416'");
  REQUIRE(held);
  CHECK(held->lo == Approx(-1.9199).epsilon(1e-12));
  CHECK(held->hi == Approx(kPi).epsilon(1e-12));
  for (const char* beyond :
       {"lower='-3.1416' upper='3.1416'", "lower='-4' upper='1'", "lower='-9' upper='9'"}) {
    const auto [told, none] = limits(beyond);
    CHECK_FALSE(none);
    CHECK(note_with(told, "goes beyond ±180°").where == std::vector{std::pair(std::string("r.urdf"), 2)});
  }
}

TEST_CASE("a joint whose range leaves out 0 begins at its bound", "[import]") {
  const std::string robot =
      R"(<robot name="r"><link name="world"/><link name="arm"><inertial><origin xyz="1 0 0"/><mass value="1"/>
         <inertia ixx="1" iyy="1" izz="1"/></inertial></link><joint name="j" type="revolute"><parent link="world"/>
         <child link="arm"/><axis xyz="0 0 1"/><limit lower="0.5" upper="1" effort="1" velocity="1"/></joint></robot>)";
  ImportedRun run(import_robot_text(robot, "r.urdf", {}).text, {"gravity=[0,0,0]"});
  // About the robot's z: its y is the scene's -z.
  CHECK((run.state.c[0] - Vec3(std::cos(0.5), 0, -std::sin(0.5))).norm() < 1e-12);
  run.run(0.5);
  CHECK((run.state.c[0] - Vec3(std::cos(0.5), 0, -std::sin(0.5))).norm() < 1e-6);
  REQUIRE(run.scene.model.joints[0].limits);
  CHECK(run.scene.model.joints[0].limits->lo == Approx(0.5));
}

}  // namespace pabd::test_urdf
