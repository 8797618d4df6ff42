// SPDX-License-Identifier: MIT
// Motors, dampers and friction of robots' joints: what their files say acts in the scene; the rest is noted.
#include <cmath>

#include "tests/import/import_helpers.h"
#include "tests/support/places.h"

namespace pabd::test_motors {

using namespace test;

namespace {

const std::filesystem::path kModels = places::tests() + "/import/models";

const Joint& joint_of(const ImportedRun& run, const std::string& name) {
  const auto& joints = run.scene.model.joints;
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == name; });
  REQUIRE(found != joints.end());
  return *found;
}

double speed_of(const ImportedRun& run, const std::string& body) {
  return run.state.omega[run.body(body)].y();  // the robot's z
}

}  // namespace

TEST_CASE("motors of an MJCF file turn as it says, at the control nearest to 0", "[import]") {
  const ImportedScene imported = import_robot(kModels / "motors.xml");
  ImportedRun run(imported.text);
  const JointAction& speed = *joint_of(run, "speed").action;
  CHECK(speed.motor->profile.at(0) == Approx(3.0 / 2));  // control over gear
  CHECK(speed.motor->gain == Approx(0.5 * 2 * 2));
  CHECK(speed.motor->most == Approx(2 * 0.25));
  CHECK(joint_of(run, "held").action->spring.stiffness == 3);
  CHECK(joint_of(run, "held").action->damping == 0.1);
  CHECK(joint_of(run, "block").action->friction == 4);
  CHECK(joint_of(run, "block").action->spring.stiffness == 3);
  CHECK(joint_of(run, "ball").action->damping == 0.3);

  const double inertia = 0.5 * 3 * 0.2 * 0.2;
  run.run(0.5);
  CHECK(speed_of(run, "torque") == Approx(0.5 * 5 * 0.5 / inertia).epsilon(1e-6));
  run.run(3);
  CHECK(speed_of(run, "speed") == Approx(2 * 1.5 / 2.1).epsilon(1e-6));  // kv' (v − ω) = c ω

  CHECK(note_with(imported, "second motor").where[0].second == 32);
  CHECK(note_with(imported, "position actuator: a spring").where[0].second == 31);
  CHECK(note_with(imported, "frictionloss of a ball").where[0].second == 24);
  CHECK(note_with(imported, "armature: not taken").where[0].second == 16);
  CHECK(note_with(imported, "not the same both ways").where[0].second == 30);
}

TEST_CASE("a position actuator is a spring and a damper about its control, told from the joint's ref",
          "[import]") {
  const ImportedRun run(import_robot_text(R"(<mujoco><worldbody>
      <body pos='0 0 1'><joint name='turned' ref='30'/><geom size='0.1'/></body>
      <body pos='1 0 1'><joint name='pushed' type='slide' ref='0.2' stiffness='10'/><geom size='0.1'/></body>
      <body pos='2 0 1'><joint name='general'/><geom size='0.1'/></body>
      <body pos='3 0 1'><joint name='pulled'/><geom size='0.1'/></body>
      </worldbody><actuator><position joint='turned' kp='5' kv='2'/>
      <position joint='pushed' ctrlrange='0.5 1' kp='40' gear='0.5'/>
      <general joint='general' gear='2' ctrlrange='3 4' gainprm='7' biastype='affine' biasprm='1 -10 -0.5'/>
      <general joint='pulled' gear='2' ctrlrange='3 4' gainprm='7'/>
      </actuator></mujoco>)",
                                          "m.xml", {})
                            .text);
  const JointAction& turned = *joint_of(run, "turned").action;
  CHECK(turned.spring.stiffness == 5);
  CHECK(turned.spring.rest == Approx(-kPi / 6));
  CHECK(turned.damping == 2);
  // kp gear² and the joint's own 10 N/m, which rests at springref, −ref from the pose of the file: forces balance.
  const JointAction& pushed = *joint_of(run, "pushed").action;
  CHECK(pushed.spring.stiffness == Approx(20));
  CHECK(pushed.spring.rest == Approx((10 * -0.2 + 10 * (0.5 / 0.5 - 0.2)) / 20));
  // gear (gain control + b₀ − 10 gear q − gear q̇/2)
  const JointAction& general = *joint_of(run, "general").action;
  CHECK(general.spring.stiffness == Approx(40));
  CHECK(general.spring.rest == Approx(2 * (7 * 3 + 1) / 40.0));
  CHECK(general.damping == Approx(2));
  CHECK(joint_of(run, "pulled").action->motor->profile.at(0) == Approx(2 * 7 * 3));
}

TEST_CASE("a weight on a position actuator hangs where kp carries it", "[import]") {
  ImportedRun run(import_robot_text(R"(<mujoco><worldbody><body pos='0 0 1'><joint name='z' type='slide'
      axis='0 0 1' range='-2 2'/><geom size='0.1' mass='3'/></body></worldbody>
      <actuator><position joint='z' kp='200' kv='40'/></actuator></mujoco>)",
                                    "m.xml", {})
                      .text);
  run.run(3);
  CHECK(run.state.c[0].y() == Approx(1 - 3 * 9.81 / 200).margin(1e-5));
  CHECK(run.scene.model.joints[0].limits);
}

TEST_CASE("a URDF wheel slows down by its damping and friction", "[import]") {
  ImportedRun run(import_robot(kModels / "brake.urdf").text, {"time_step=0.001"});
  const std::size_t wheel = run.body("wheel");
  run.state.omega[wheel] = Vec3(0, 8, 0);
  run.run(1);
  // I ω' = −c ω − f; the implicit steps of 1 ms are near it.
  const double c = 0.05, f = 0.1, I = 0.1;
  CHECK(speed_of(run, "wheel") == Approx((8 + f / c) * std::exp(-c / I) - f / c).epsilon(1e-3));
  run.run(4);
  CHECK(std::abs(speed_of(run, "wheel")) < 1e-6);
}

TEST_CASE("springs of an MJCF file pull back to where they rest, which is told from the joint's ref",
          "[import]") {
  const ImportedScene imported = import_robot_text(R"(<mujoco><option gravity='0 0 0'/><default>
      <joint stiffness='7'/></default><worldbody>
      <body pos='0 0 1'><joint name='turned' ref='30' springref='50' damping='1'/><geom size='0.1'/></body>
      <body pos='1 0 1'><joint name='pushed' type='slide' ref='0.2' stiffness='9'/><geom size='0.1'/></body>
      <body pos='2 0 1'><joint name='ball' type='ball'/><geom size='0.1'/></body>
      <body pos='3 0 1'><joint name='far' springref='181'/><geom size='0.1'/></body>
      <body pos='4 0 1'><joint name='held'/><geom size='0.1'/></body>
      <body pos='5 0 1'><joint type='free'/><geom size='0.1'/></body>
      </worldbody><actuator><position joint='held'/></actuator></mujoco>)",
                                                   "m.xml", {});
  ImportedRun run(imported.text);
  const JointSpring turned = joint_of(run, "turned").action->spring,
                    pushed = joint_of(run, "pushed").action->spring;
  CHECK(turned.stiffness == 7);
  CHECK(turned.rest == Approx(kPi / 9));
  CHECK(pushed.stiffness == 9);
  CHECK(pushed.rest == Approx(-0.2));
  CHECK_FALSE(joint_of(run, "far").action);
  CHECK(note_with(imported, "stiffness of a ball").where[0].second == 2);
  CHECK(note_with(imported, "rests beyond").where[0].second == 6);
  CHECK(joint_of(run, "held").action->spring.stiffness == 8);
  CHECK(note_with(imported, "stiffness of a free").where[0].second == 2);
}

TEST_CASE("damping that pushes is refused", "[import]") {
  for (const char* text :
       {"<mujoco><worldbody><body><joint damping='-1'/><geom size='1'/></body></worldbody></mujoco>",
        "<mujoco><worldbody><body><joint stiffness='-1'/><geom size='1'/></body></worldbody></mujoco>",
        "<mujoco><worldbody><body><joint frictionloss='-1'/><geom size='1'/></body></worldbody></mujoco>",
        "<robot name='r'><link name='world'/><link name='a'><inertial><mass value='1'/><inertia ixx='1' "
        "iyy='1' "
        "izz='1'/></inertial></link><joint name='j' type='continuous'><parent link='world'/><child link='a'/>"
        "<dynamics damping='-1'/></joint></robot>"})
    CHECK_THROWS_WITH(import_robot_text(text, "robot.xml", "/nowhere"), Catch::Contains("is negative"));
}

}  // namespace pabd::test_motors
