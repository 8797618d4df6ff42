// SPDX-License-Identifier: MIT
// Motors, dampers, springs and friction of joints in scene files and in scenes built in C++: what is said arrives in
// the model, comes out of a saved scene, and bad ones are refused.
#include <cmath>

#include "sim/scene/builder.h"
#include "sim/scene/write_scene.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_read_actions {

using namespace test;

namespace {

std::string joints(const std::string& list) {
  return scene_text(R"("bodies": [
    { "name": "a", "shape": { "type": "box", "size": [2, 1, 1] }, "mass": 3, "position": [0, 1, 0] },
    { "name": "b", "shape": { "type": "sphere", "radius": 0.25 }, "mass": 5, "position": [2, 1, 0] } ],
    "joints": [ )" + list +
                    " ]");
}

JointAction only_action(const std::string& members) {
  const Scene s = parse(joints("{" + members + "}"));
  REQUIRE(s.model.joints.size() == 1);
  REQUIRE(s.model.joints[0].action);
  return *s.model.joints[0].action;
}

const std::string kHinge = R"("type": "hinge", "bodies": ["a", "b"], "anchor": [1, 1, 0], "axis": [0, 0, 2])";
const std::string kSlider =
    R"("type": "slider", "bodies": [null, "a"], "anchor": [0, 1, 0], "axis": [1, 0, 0])";
const std::string kBall = R"("type": "spherical", "bodies": ["a", "b"], "anchor": [1, 1, 0])";
const std::string kRod = R"("type": "distance", "bodies": ["a", "b"], "points": [[0, 1, 0], [2, 1, 0.5]])";

}  // namespace

TEST_CASE("motors: torques and forces, speeds in degrees or metres a second", "[scene]") {
  const JointAction torque = only_action(kHinge + R"(, "motor": { "torque": -3 })");
  REQUIRE(torque.motor);
  CHECK(torque.motor->gives == JointMotor::Gives::force);
  CHECK(torque.motor->profile.at(5) == -3);
  CHECK(torque.damping == 0);
  const JointAction rising =
      only_action(kSlider + R"(, "motor": { "force": { "keys": [[0, 0], [2, 10]] } })");
  CHECK(rising.motor->profile.at(1) == 5);
  const JointAction speed =
      only_action(kHinge + R"(, "motor": { "speed": 90, "max_torque": 4, "gain": 0.5 }, "friction": 0.25)");
  CHECK(speed.motor->gives == JointMotor::Gives::speed);
  CHECK(speed.motor->profile.at(0) == Approx(90 * kDegree));
  CHECK(speed.motor->most == 4);
  CHECK(speed.motor->gain == 0.5);
  CHECK(speed.friction == 0.25);
  const JointAction free = only_action(kSlider + R"(, "motor": { "speed": { "value": 2 } })");
  CHECK(free.motor->profile.at(0) == 2);
  CHECK(std::isinf(free.motor->most));
  CHECK(free.motor->gain == 0);
}

TEST_CASE("springs: N m/rad about an angle in degrees, N/m about an offset in metres", "[scene]") {
  const JointSpring turns = only_action(kHinge + R"(, "spring": { "stiffness": 5, "rest": 30 })").spring;
  CHECK(turns.stiffness == 5);
  CHECK(turns.rest == Approx(30 * kDegree));
  const JointSpring pushes = only_action(kSlider + R"(, "spring": { "stiffness": 7, "rest": -2 })").spring;
  CHECK(pushes.stiffness == 7);
  CHECK(pushes.rest == -2);
  CHECK(only_action(kSlider + R"(, "spring": { "stiffness": 7 })").spring.rest == 0);
  const JointSpring table =
      only_action(kHinge + R"(, "spring": { "table": [[-90, -4], [0, 0], [180, 1]], "rest": 30 })").spring;
  REQUIRE(table.table.points.size() == 3);
  CHECK(table.table.points[0].first == Approx(-kPi / 2));
  CHECK(table.table.points[0].second == -4);
  CHECK(table.stiffness == 0);
  CHECK_FALSE(parse(joints("{" + kHinge + R"(, "spring": { "stiffness": 0 } })")).model.joints[0].action);
}

TEST_CASE("dampers of hinges, sliders, balls and rods", "[scene]") {
  for (const std::string& joint : {kHinge, kSlider, kBall, kRod}) {
    INFO(joint);
    CHECK(only_action(joint + R"(, "damping": 1.5)").damping == 1.5);
    CHECK_FALSE(parse(joints("{" + joint + R"(, "damping": 0 })")).model.joints[0].action);
    CHECK_FALSE(parse(joints("{" + joint + " }")).model.joints[0].action);
  }
}

TEST_CASE("a saved scene has the motors it had, from its own time on", "[scene]") {
  const Scene scene = parse(joints(
      "{" + kHinge + R"(, "motor": { "speed": { "keys": [[0, 0], [2, 360]] }, "max_torque": 4, "gain": 2 },
        "damping": 0.1, "friction": 0.2, "spring": { "stiffness": 3, "rest": -20 } }, {)" +
      kSlider + R"(, "motor": { "force": 7 }, "spring": { "stiffness": 4, "rest": 0.5 } }, {)" + kBall +
      R"(, "damping": 3 }, {)" + kHinge + R"(, "spring": { "table": [[-30, -2], [60, 5]], "rest": 10 } })"));
  State state = scene.initial;
  state.time = 1;
  const std::string saved = scene_to_json(scene.model, state, scene.params, scene.joint_law, "saved", {}, {},
                                          parameter_table(), {});
  const Model again = parse(saved).model;
  REQUIRE(again.joints.size() == 4);
  for (const Joint& joint : again.joints) REQUIRE(joint.action);
  const JointAction &turns = *again.joints[0].action, &pushes = *again.joints[1].action;
  CHECK(turns.motor->profile.at(0) == Approx(kPi));
  CHECK(turns.motor->profile.at(0.5) == Approx(1.5 * kPi));
  CHECK(turns.motor->most == 4);
  CHECK(turns.motor->gain == 2);
  CHECK(turns.damping == 0.1);
  CHECK(turns.friction == 0.2);
  CHECK(turns.spring.stiffness == 3);
  CHECK(turns.spring.rest == Approx(-20 * kDegree));
  CHECK(pushes.spring.stiffness == 4);
  CHECK(pushes.spring.rest == 0.5);
  CHECK(pushes.motor->gives == JointMotor::Gives::force);
  CHECK(pushes.motor->profile.at(0) == 7);
  CHECK(again.joints[2].action->damping == 3);
  const JointSpring &table = again.joints[3].action->spring, &first = scene.model.joints[3].action->spring;
  REQUIRE(table.table.points.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(table.table.points[k].first == Approx(first.table.points[k].first));
    CHECK(table.table.points[k].second == first.table.points[k].second);
  }
  CHECK(table.rest == Approx(first.rest));
}

TEST_CASE("motors built in C++ are those of a file", "[scene]") {
  const Scene read = parse_scene(R"({ "format": "pabd-scene", "version": 1, "name": "all", "bodies": [
      { "name": "a", "shape": { "type": "sphere", "radius": 0.4 }, "mass": 3, "position": [0, 50, 0] },
      { "name": "b", "shape": { "type": "sphere", "radius": 0.4 }, "mass": 3, "position": [0, 40, 0] } ], "joints": [
      { "type": "hinge", "bodies": [null, "a"], "anchor": [1, 50, 0], "axis": [0, 0, 1], "start": 30,
        "motor": { "speed": { "keys": [[0, 1], [1, 2]] }, "max_torque": 4, "gain": 5 }, "damping": 6, "friction": 7,
        "spring": { "stiffness": 9, "rest": 10 } },
      { "type": "slider", "bodies": [null, "b"], "anchor": [1, 50, 0], "axis": [0, 0, 1],
        "motor": { "force": { "keys": [[0, 8]] } } } ] })",
                                 "it", {});
  SceneBuilder builder("all");
  builder.add(spec::Body{.name = "a", .shape = Sphere{0.4}, .mass = 3, .position = Vec3(0, 50, 0)});
  builder.add(spec::Body{.name = "b", .shape = Sphere{0.4}, .mass = 3, .position = Vec3(0, 40, 0)});
  builder.add(spec::Joint{.type = JointType::hinge,
                          .j = "a",
                          .anchor = Vec3(1, 50, 0),
                          .axis = Vec3::UnitZ(),
                          .start = 30,
                          .motor = spec::Motor{.speed = Profile{{{0, 1}, {1, 2}}}, .most = 4, .gain = 5},
                          .damping = 6,
                          .friction = 7,
                          .spring = spec::Spring{9, 10}});
  builder.add(spec::Joint{.type = JointType::slider,
                          .j = "b",
                          .anchor = Vec3(1, 50, 0),
                          .axis = Vec3::UnitZ(),
                          .motor = spec::Motor{.force = Profile{{{0, 8}}}}});
  CHECK(builder.build().hash == read.hash);
}

TEST_CASE("bad motors, dampers and friction are refused", "[scene]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {kHinge + R"(, "motor": 5)", {"/joints/0/motor", "expected an object"}},
      {kHinge + R"(, "motor": {})", {"/joints/0/motor", "either \"torque\" or \"speed\""}},
      {kHinge + R"(, "motor": { "torque": 1, "speed": 1 })", {"/joints/0/motor", "either"}},
      {kHinge + R"(, "motor": { "force": 1 })", {"/joints/0/motor/force", "unknown key"}},
      {kSlider + R"(, "motor": { "torque": 1 })", {"/joints/0/motor/torque", "unknown key"}},
      {kSlider + R"(, "motor": { "force": "much" })", {"/joints/0/motor/force", "(N)", "\"keys\""}},
      {kSlider + R"(, "motor": { "force": 1e13 })", {"/joints/0/motor/force", "(N)"}},
      {kHinge + R"(, "motor": { "torque": 1, "gain": 1 })", {"/joints/0/motor/gain", "\"speed\""}},
      {kHinge + R"(, "motor": { "torque": 1, "max_torque": 1 })", {"/joints/0/motor/max_torque", "remove"}},
      {kHinge + R"(, "motor": { "speed": 1, "max_torque": -1 })", {"/joints/0/motor/max_torque", "(N m)"}},
      {kHinge + R"(, "motor": { "speed": 1, "gain": 0 })", {"/joints/0/motor/gain", "(N m s/rad)"}},
      {kHinge + R"(, "motor": { "speed": 1e9 })", {"/joints/0/motor/speed", "(degrees/s)"}},
      {kHinge + R"(, "motor": { "torque": 1 }, "drive": { "value": 0 })",
       {"/joints/0/motor", "one of \"motor\" and \"drive\""}},
      {kHinge + R"(, "friction": -1)", {"/joints/0/friction", "(N m)"}},
      {kSlider + R"(, "friction": 1, "drive": { "value": 0 })", {"/joints/0/friction", "remove one"}},
      {kHinge + R"(, "spring": 5)", {"/joints/0/spring", "expected an object"}},
      {kHinge + R"(, "spring": { "rest": 5 })", {"/joints/0/spring", "stiffness"}},
      {kHinge + R"(, "spring": { "stiffness": 1, "table": [[0, 0], [1, 1]] })",
       {"/joints/0/spring", "either \"stiffness\" or \"table\""}},
      {kHinge + R"(, "spring": { "table": [[0, 0]] })", {"/joints/0/spring/table", "pairs [way from rest"}},
      {kHinge + R"(, "spring": { "table": [[0, 0], [0, 1]] })", {"/joints/0/spring/table/1/0", "must rise"}},
      {kSlider + R"(, "spring": { "table": [[0, 0], [1]] })", {"/joints/0/spring/table/1", "a pair"}},
      {kSlider + R"(, "spring": { "table": [[0, 0], [1, 1e20]] })", {"/joints/0/spring/table/1/1", "(N)"}},
      {kHinge + R"(, "spring": { "stiffness": -1 })", {"/joints/0/spring/stiffness", "(N m/rad)"}},
      {kSlider + R"(, "spring": { "stiffness": -1 })", {"/joints/0/spring/stiffness", "(N/m)"}},
      {kHinge + R"(, "spring": { "stiffness": 1, "rest": 181 })", {"/joints/0/spring/rest", "(degrees)"}},
      {kHinge + R"(, "spring": { "stiffness": 1 }, "drive": { "value": 0 })",
       {"/joints/0/spring", "remove one"}},
      {kRod + R"(, "spring": { "stiffness": 1 })", {"/joints/0/spring", "unknown key"}},
      {kHinge + R"(, "damping": -1)", {"/joints/0/damping", "(N m s/rad)"}},
      {kRod + R"(, "damping": -1)", {"/joints/0/damping", "(N s/m)"}},
      {kRod + R"(, "friction": 1)", {"/joints/0/friction", "unknown key"}},
      {kBall + R"(, "motor": { "torque": 1 })", {"/joints/0/motor", "unknown key"}},
      {kBall + R"(, "damping": 1, "drive": { "value": [0, 0, 0] })", {"/joints/0/damping", "remove one"}},
      {R"("type": "fixed", "bodies": ["a", "b"], "anchor": [1, 1, 0], "damping": 1)",
       {"/joints/0/damping", "unknown key"}}};
  for (const auto& [members, parts] : cases) check_refused(joints("{" + members + "}"), parts);
}

TEST_CASE("every value of a motor, damper or brake changes the hash of the scene", "[scene]") {
  const std::string base =
      joints("{" + kHinge +
             R"(, "motor": { "speed": 5, "max_torque": 4, "gain": 2 }, "damping": 1, "friction": 2,
             "spring": { "stiffness": 3, "rest": 4 } }, {)" +
             kSlider + R"(, "motor": { "force": 7 }, "start": 0.1 })");
  std::vector<std::string> hashes{parse(base).hash};
  for (const char* change :
       {"joints.0.motor.speed=6", "joints.0.motor.max_torque=5", "joints.0.motor.gain=3",
        "joints.0.damping=2", "joints.0.spring.stiffness=4", "joints.0.spring.rest=5", "joints.0.friction=3",
        "joints.1.motor.force=8", "joints.1.start=0.2", "joints.0.start=1"}) {
    INFO(change);
    hashes.push_back(parse(base, {change}).hash);
    for (std::size_t k = 0; k + 1 < hashes.size(); ++k) CHECK(hashes[k] != hashes.back());
  }
}

}  // namespace pabd::test_read_actions
