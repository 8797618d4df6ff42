// SPDX-License-Identifier: MIT
// What other programs take, and a scene does not have: left out or mended, and told with its line.
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/joint/joint_traits.h"
#include "tests/import/import_helpers.h"

namespace pabd::test_mended {

using namespace test;

namespace {

const std::string kLink =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial>"
    "<collision><geometry><box size='1 1 1'/></geometry></collision>";

std::string two_links(const std::string& second, const std::string& joint) {
  return "<robot name='r'><link name='a'>" + kLink + "</link>\n<link name='b'>" + second +
         "</link>\n<joint name='j' " + joint + "<parent link='a'/><child link='b'/></joint></robot>";
}

std::string world(const std::string& inside, const std::string& before = "") {
  return "<mujoco>" + before +
         "<worldbody><body name='ball' pos='0 0 1'><freejoint/><geom size='.1'/></body>\n" + inside +
         "</worldbody></mujoco>";
}

struct Case {
  std::string file, text, note;
  int line;
};

}  // namespace

TEST_CASE("a part that is no body is left out with its line, and the rest is taken", "[import]") {
  const std::string fixed = "type='fixed'>";
  const std::vector<Case> cases{
      {"r.urdf", two_links("<visual><geometry><sphere radius='0'/></geometry></visual>", fixed),
       "its size is 0", 2},
      {"r.urdf", two_links("<visual><geometry><box size='0 0 0'/></geometry></visual>", fixed),
       "its size is 0", 2},
      {"r.urdf",
       two_links("<visual><geometry><material name='x'/><box size='1 1 1'/></geometry></visual>", fixed),
       "<material> in <geometry>", 2},
      {"r.urdf", two_links(kLink, "type='prismatic'><limit lower='-1e16' upper='1e16'/>"), "beyond 1000 km",
       3},
      {"r.urdf", two_links(kLink, "type='prismatic'><limit lower='-inf' upper='inf'/>"), "beyond 1000 km", 3},
      {"r.urdf", two_links(kLink, "type='revolute'><limit lower='1' upper='0'/>"), "lower bound is above", 3},
      {"m.xml", world("<body><joint range='1 0' limited='true'/><geom size='.1'/></body>"),
       "lower bound is above", 2},
      {"m.xml",
       world(
           "<body><joint type='slide'/><geom size='.01' density='1e-5' contype='0' conaffinity='0'/></body>"),
       "less than 1e-09 kg", 2},
      {"r.urdf", two_links(kLink, "type='revolute'>"), "without <limit>", 3},
      {"r.urdf",
       two_links("<collision><geometry><mesh scale='1 1 1 1' filename='a.stl'/></geometry></collision>",
                 fixed),
       "not three numbers", 2},
      {"m.xml",
       "<mujoco><worldbody><body><freejoint name='f'/><geom size='1'/></body></worldbody>\n<actuator><motor "
       "joint='f'/></actuator></mujoco>",
       "actuator of a free joint", 2},
      {"m.xml", world("<geom size='0'/>"), "its size is 0", 2},
      {"m.xml",
       world("<body><geom type='mesh' mesh='m'/></body>", "<asset><mesh name='m' builtin='sphere'/></asset>"),
       "made by MuJoCo itself", 2},
  };
  for (const Case& each : cases) {
    INFO(each.text);
    const ImportedScene imported = import_robot_text(each.text, each.file, {});
    CHECK(note_with(imported, each.note).where == std::vector{std::pair(each.file, each.line)});
    CHECK(parse_scene(imported.text, "r", {}).model.size() > 0);
  }
}

TEST_CASE("a robot without bodies is refused with what was left out", "[import]") {
  CHECK_THROWS_WITH(
      import_robot_text(
          "<robot name='r'><link name='a'>\n<collision><geometry><mesh filename='package://p/a.stl'/>"
          "</geometry></collision></link></robot>",
          "r.urdf", "/nowhere"),
      Catch::Contains("the robot has no bodies") && Catch::Contains("r.urdf:2: mesh left out") &&
          Catch::Contains("no such file"));
}

TEST_CASE("one bound beyond all places leaves the other one", "[import]") {
  const ImportedScene imported = import_robot_text(
      two_links(kLink, "type='prismatic'><limit lower='-0.5' upper='1e16'/>"), "r.urdf", {});
  const Scene scene = parse_scene(imported.text, "r", {});
  REQUIRE(scene.model.joints.at(0).limits);
  CHECK(scene.model.joints[0].limits->lo == Approx(-0.5));
}

TEST_CASE("global coordinates tell places in the world", "[import]") {
  const std::string text = R"(<mujoco><compiler coordinate="global"/><worldbody>
    <body name="a" pos="0 0 1" euler="0 90 0"><freejoint/><geom type="capsule" fromto="0 0 1 0 0 1.5" size=".05"/>
      <body name="b" pos="0 0 1.5"><joint pos="0 0 1.5" axis="0 1 0"/><geom size=".1" pos=".2 0 1.5"/></body>
    </body></worldbody></mujoco>)";
  const Scene scene = parse_scene(import_robot_text(text, "m.xml", {}).text, "m", {});
  CHECK((scene.initial.c[0] - Vec3(0, 1.25, 0)).norm() < 1e-12);
  CHECK((scene.initial.c[1] - Vec3(0.2, 1.5, 0)).norm() < 1e-12);
  const Joint& hinge = scene.model.joints.at(0);
  const Vec3 anchor = place(hinge.on_i, hinge.i, scene.initial).y;
  CHECK((anchor - Vec3(0, 1.5, 0)).norm() < 1e-12);
}

TEST_CASE("settotalmass is the mass of all bodies, in the proportions of the file", "[import]") {
  const std::string text =
      "<mujoco><compiler settotalmass='14'/><worldbody><body><freejoint/><geom size='.2'/></body>"
      "<body><freejoint/><inertial pos='0 0 0' mass='20' diaginertia='1 2 2'/><geom size='.1'/></body>"
      "</worldbody></mujoco>";
  const Scene scene = parse_scene(import_robot_text(text, "m.xml", {}).text, "m", {});
  const double ball = 1000 * 4.0 / 3 * kPi * 0.008, part = 14 / (ball + 20);
  CHECK(scene.model.mass[0] == Approx(ball * part));
  CHECK(scene.model.mass[1] == Approx(20 * part));
  CHECK(inertia_tensor(scene.model.J[1])(0, 0) == Approx(part));
}

TEST_CASE("gravcomp takes its part of the weight of its own body", "[import]") {
  const auto fallen = [](const std::string& inside) {
    const std::string text = "<mujoco><worldbody><body gravcomp='0.75'><freejoint/><geom size='.1'/>" +
                             inside + "</body></worldbody></mujoco>";
    ImportedRun run(import_robot_text(text, "m.xml", {}).text,
                    {"time_step=0.001", "solver.integrator=euler"});
    run.run(0.5);
    return -run.state.c[0].y();
  };
  // By Euler velocity first: y = −a h² n (n + 1)/2.
  const double free = 9.81 * 1e-6 * 500 * 501 / 2;
  CHECK(fallen("") == Approx(0.25 * free).epsilon(1e-9));
  CHECK(fallen("<body><geom size='.1'/></body>") == Approx((1 - 0.75 / 2) * free).epsilon(1e-9));
}

TEST_CASE("replicate makes copies, each turned and moved from the one before", "[import]") {
  const std::string text =
      "<mujoco><worldbody><replicate count='4' euler='0 0 90' sep='-'><body name='leg' pos='1 0 "
      "2'><freejoint/>"
      "<geom size='.1'/></body></replicate></worldbody></mujoco>";
  ImportedRun run(import_robot_text(text, "m.xml", {}).text);
  REQUIRE(run.scene.model.size() == 4);
  for (int k = 0; k < 4; ++k) {
    const double turn = k * kPi / 2;
    const Vec3 at(std::cos(turn), 2, -std::sin(turn));
    CHECK((run.state.c[run.body("leg-" + std::to_string(k))] - at).norm() < 1e-12);
  }
  CHECK_THROWS_WITH(
      import_robot_text("<mujoco><worldbody><replicate count='20000'><replicate count='20000'/></replicate>"
                        "</worldbody></mujoco>",
                        "m.xml", {}),
      Catch::Contains("more than 20000 copies"));
}

TEST_CASE("a keyframe is where joints start and actuators stand", "[import]") {
  const std::string text = R"(<mujoco><option gravity="0 0 0"/><worldbody>
    <body name="free" pos="0 0 1"><freejoint/><geom size=".1"/></body>
    <body name="arm" pos="1 0 1"><joint name="a" axis="0 1 0" ref="30"/><geom size=".1" pos=".2 0 0"/></body>
    <body name="ball" pos="2 0 1"><joint type="ball" pos="0 0 .5"/><geom size=".1"/></body></worldbody>
    <actuator><motor joint="a"/><position joint="a" kp="3"/></actuator>
    <keyframe><key name="none"/><key name="home" qpos="1 2 3 1 0 0 0  1  0.70710678 0.70710678 0 0" ctrl="0 0.7"/>
    <key name="short" qpos="1"/></keyframe></mujoco>)";
  const auto with = [&](const std::string& keyframe) {
    return import_robot_text(text, "m.xml", {}, {.keyframe = keyframe});
  };
  const ImportedRun run(with("home").text);
  CHECK((run.state.c[run.body("free")] - Vec3(1, 3, -2)).norm() < 1e-12);
  // From the pose of the file, which is at 30°: about y, z up, what points along x turns down.
  const double angle = 1 - kPi / 6;
  CHECK(
      (run.state.c[run.body("arm")] - Vec3(1 + 0.2 * std::cos(angle), 1 - 0.2 * std::sin(angle), 0)).norm() <
      1e-9);
  // A quarter of a turn about x, below its anchor: what is down points along y.
  CHECK((run.state.c[run.body("ball")] - Vec3(2, 1.5, -0.5)).norm() < 1e-7);
  CHECK(run.scene.model.joints[0].action->spring.rest == Approx(0.7 - kPi / 6));
  CHECK(note_with(with(""), "--keyframe NAME").where.size() == 2);
  CHECK_THROWS_WITH(with("away"), Catch::Contains("there are \"none\", \"home\", \"short\""));
  CHECK_THROWS_WITH(with("short"), Catch::Contains("1 numbers; expected 12"));
}

TEST_CASE("an equality of one joint holds it at its constant", "[import]") {
  ImportedRun run(import_robot_text(R"(<mujoco><worldbody><body pos="0 0 1"><joint name="a" axis="0 1 0"/>
    <geom size=".1" pos=".2 0 0"/></body></worldbody>
    <equality><joint joint1="a" polycoef="0.5 0 0 0 0"/></equality></mujoco>)",
                                    "m.xml", {})
                      .text);
  run.run(1);
  // About y, z up: what points along x turns down.
  CHECK((run.state.c[0] - Vec3(0.2 * std::cos(0.5), 1 - 0.2 * std::sin(0.5), 0)).norm() < 1e-6);
}

}  // namespace pabd::test_mended
