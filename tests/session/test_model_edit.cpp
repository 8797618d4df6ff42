// SPDX-License-Identifier: MIT
// Bodies and joints that come and go while a simulation runs.

#include <catch2/catch.hpp>
#include <cstring>
#include <functional>

#include "app/session/session.h"
#include "app/session/timeline.h"
#include "sim/base/error.h"
#include "sim/scene/write_scene.h"

namespace pabd::test_model_edit {

namespace {

constexpr const char* kGround = R"({ "name": "ground", "shape": { "type": "plane" } })";

std::string crate(const std::string& name, double x, double y) {
  return R"({ "name": ")" + name + R"(", "shape": { "type": "box", "size": [1, 1, 1] }, "density": 100,
    "position": [)" +
         std::to_string(x) + ", " + std::to_string(y) + R"(, 0], "angular_velocity": [0, 20, 0] })";
}

Session session_of(const std::string& bodies, const std::string& joints = "") {
  const std::string text = R"({ "format": "pabd-scene", "version": 1, "contact": { "kappa": 300 },
    "bodies": [ )" + bodies +
                           "]" + (joints.empty() ? "" : R"(, "joints": [ )" + joints + "]") + "}";
  return Session(parse_scene(text, "test.json", {}));
}

void run(Session& session, int steps) {
  for (int k = 0; k < steps; ++k) REQUIRE(session.step().status != StepStatus::non_finite);
}

void check_refused(Session& session, const ModelEdit& edit, const std::string& part) {
  const State before = session.state();
  const std::size_t joints = session.model().joints.size(), pairs = session.model().no_collide.size();
  try {
    session.edit(edit);
    FAIL_CHECK("accepted; expected a refusal about " << part);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    CHECK_THAT(error.what(), Catch::Contains(part));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
  CHECK(same_bits(session.state(), before));
  CHECK(session.model().joints.size() == joints);
  CHECK(session.model().no_collide.size() == pairs);
}

void check_json(const ModelEdit& edit, const std::string& text) {
  CHECK(to_json(edit) == text);
  CHECK(to_json(edit_from_json(text, "script")) == text);
}

void check_text_refused(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CHECK_THROWS_WITH(edit_from_json(text, "script"), Catch::StartsWith("script: ") && Catch::Contains(part));
}

const std::string kPair = std::string(kGround) + "," + crate("left", -3, 0.6) + "," + crate("right", 3, 0.7);

}  // namespace

TEST_CASE("a body removed in the middle: the others go on as in a scene that never had it, to the bit") {
  Session with = session_of(std::string(kGround) + "," + crate("a", -3, 0.6) + "," + crate("b", 0, 0.7) +
                            "," + crate("c", 3, 0.8) + "," + crate("d", 3, 1.9));
  Session without = session_of(std::string(kGround) + "," + crate("a", -3, 0.6) + "," + crate("c", 3, 0.8) +
                               "," + crate("d", 3, 1.9));
  // Iterations end for all bodies together, and a line search looks at all of them.
  Params params = with.params();
  params.solver.method = SolverMethod::descent;
  params.solver.tolerance = 0;
  with.set_params(params);
  without.set_params(params);
  run(with, 40);
  run(without, 40);
  CHECK(with.report().contacts > without.report().contacts);
  with.edit(RemoveBody{2});
  CHECK(with.model().name == without.model().name);
  CHECK(same_bits(with.state(), without.state()));  // what friction remembers too
  run(with, 40);
  run(without, 40);
  CHECK(same_bits(with.state(), without.state()));
  CHECK(with.state().step == 80);
}

TEST_CASE("what is added and removed again leaves model and state as they were, to the bit") {
  Session session = session_of(kPair);
  run(session, 30);
  const State before = session.state();
  AddBody ball;
  ball.shape = Sphere{0.3};
  ball.position = {0, 3, 0};
  session.edit(ball);
  CHECK(session.model().name.back() == "body 3");
  AddJoint joint;
  joint.i = 1;
  joint.j = 3;
  joint.anchor = {-1, 2, 0};
  session.edit(joint);
  CHECK(session.model().joints.size() == 1);
  CHECK(session.model().no_collide == std::vector<std::pair<Index, Index>>{{1, 3}});
  session.edit(RemoveBody{3});
  CHECK(session.model().joints.empty());
  CHECK(session.model().no_collide.empty());
  CHECK(same_bits(session.state(), before));
  joint.j = 2;
  session.edit(joint);
  session.edit(joint);
  session.edit(RemoveJoint{0});
  CHECK(session.model().no_collide.size() == 1);  // the other one still holds
  session.edit(RemoveJoint{0});
  CHECK(session.model().no_collide.empty());
  CHECK(same_bits(session.state(), before));

  Session untouched = session_of(kPair);
  run(untouched, 30);
  run(session, 30);
  run(untouched, 30);
  CHECK(same_bits(session.state(), untouched.state()));
  session.reset();
  CHECK(session.model().size() == 3);
}

TEST_CASE("a body that is added is the one that a scene file would have, to the bit") {
  Session session = session_of(kGround + std::string(",") + crate("left", -3, 0.6));
  session.edit(
      edit_from_json(R"({"do": "add_body", "name": "right", "shape": {"type": "box", "size": [1, 1, 1]},
    "density": 100, "position": [3, 0.7, 0], "angular_velocity": [0, 20, 0]})",
                     "script"));
  Session whole = session_of(kPair);
  run(session, 60);
  run(whole, 60);
  CHECK(same_bits(session.state(), whole.state()));
}

TEST_CASE("joints of every type added at the present pose hold to 1e-6 m") {
  for (const JointType type :
       {JointType::spherical, JointType::hinge, JointType::slider, JointType::fixed, JointType::distance}) {
    CAPTURE(to_string(type));
    Session session = session_of(crate("only", 0, 0));
    run(session, 20);  // falls and turns
    const Vec3 c = session.state().c[0];
    AddJoint joint;
    joint.type = type;
    joint.j = 0;
    joint.anchor = c + Vec3(0.3, 0.8, 0.1);
    joint.axis = {1, 0, 1};
    joint.anchor_j = c + Vec3(0, 0.5, 0);
    BondLaw law = session.scene().joint_law;
    law.potential = BondPotential::hard;  // of a soft distance joint no error is reported
    law.kappa = 1e3;
    if (type == JointType::distance) joint.law = law;
    session.edit(joint);
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      run(session, 1);
      worst = std::max(worst, session.report().max_joint_error);
    }
    if (type != JointType::distance) CHECK(worst < 1e-6);
    CHECK(worst < 1e-2);
    CHECK((session.state().c[0] - c).norm() < (type == JointType::slider ? 20 : 3));
    CHECK(session.report().time > 1);
  }
}

TEST_CASE("edits that make no sense are refused and change nothing") {
  Session session = session_of(kPair);
  run(session, 5);
  check_refused(session, RemoveBody{3}, "from 0 to 2");
  check_refused(session, RemoveBody{-1}, "body");
  check_refused(session, RemoveJoint{0}, "joint");
  AddBody body;
  body.name = "left";
  check_refused(session, body, "already");
  body.name = "new\nline";
  check_refused(session, body, "name");
  body.name = "";
  body.density = 0;
  check_refused(session, body, "density");
  body.mass = 1e13;
  check_refused(session, body, "mass");
  body.mass = 1;
  body.position.x() = std::numeric_limits<double>::quiet_NaN();
  check_refused(session, body, "position");
  body.position.setZero();
  body.orientation = 2 * Mat3::Identity();
  check_refused(session, body, "rotation");
  body.orientation.setIdentity();
  body.shape = Sphere{0};
  check_refused(session, body, "radius");
  body.shape = Plane{Vec3::UnitY(), 0};
  check_refused(session, body, "shape");
  body.shape = Sphere{1};
  body.fixed = true;
  body.velocity = {1, 0, 0};
  check_refused(session, body, "fixed");
  AddJoint joint;
  joint.i = joint.j = 1;
  check_refused(session, joint, "different");
  joint.i = 0;
  joint.j = kWorld;
  check_refused(session, joint, "can move");
  joint.j = 7;
  check_refused(session, joint, "from 0 to 2");
  joint.j = 1;
  joint.type = JointType::hinge;
  joint.axis.setZero();
  check_refused(session, joint, "axis");
  joint.axis = Vec3::UnitX();
  joint.law = BondLaw{BondPotential::soft, 4, -1, 0.01};
  check_refused(session, joint, "kappa");

  Session lonely = session_of(crate("only", 0, 0));
  check_refused(lonely, RemoveBody{0}, "only one");
}

TEST_CASE("edits as JSON: there and back, and refusals that name the place") {
  AddBody body;
  body.name = "ball";
  body.shape = Sphere{0.25};
  body.mass = 2;
  body.position = {1, 2, 3};
  body.velocity = {0, -1, 0};
  check_json(body, R"({"do":"add_body","name":"ball","shape":{"type":"sphere","radius":0.25},"mass":2.0,)"
                   R"("position":[1.0,2.0,3.0],"velocity":[0.0,-1.0,0.0]})");
  check_json(RemoveBody{4}, R"({"do":"remove_body","body":4})");
  AddJoint joint;
  joint.type = JointType::hinge;
  joint.j = 2;
  joint.law = BondLaw{BondPotential::soft, 4, 500, 0.01};
  check_json(joint, R"({"do":"add_joint","type":"hinge","bodies":[null,2],"anchor":[0.0,0.0,0.0],)"
                    R"("axis":[0.0,0.0,1.0],"potential":"soft","kappa":500.0})");
  joint.type = JointType::distance;
  joint.law.reset();
  joint.length = 1.5;
  check_json(joint, R"({"do":"add_joint","type":"distance","bodies":[null,2],)"
                    R"("points":[[0.0,0.0,0.0],[0.0,0.0,0.0]],"length":1.5})");
  check_json(RemoveJoint{0}, R"({"do":"remove_joint","joint":0})");

  const auto spin =
      std::get<AddBody>(edit_from_json(R"({"do":"add_body","shape":{"type":"capsule","radius":1,"length":2},
        "orientation":[0.5,0.5,0.5,0.5],"angular_velocity":[0,180,0]})",
                                       "script"));
  CHECK(spin.omega.y() == Approx(kPi).epsilon(1e-15));
  CHECK((spin.orientation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-15);
  CHECK(spin.name.empty());

  check_text_refused("[]", "object");
  check_text_refused("{", "line 1");
  check_text_refused(R"({"body": 1})", "/do");
  check_text_refused(R"({"do": "explode"})", "/do");
  check_text_refused(R"({"do": "remove_body", "body": 1, "force": true})", "force");
  check_text_refused(R"({"do": "remove_body", "body": -1})", "/body");
  check_text_refused(R"({"do": "remove_body", "body": 1.5})", "/body");
  check_text_refused(R"({"do": "add_body", "shape": {"type": "mesh", "file": "/etc/passwd"}})", "/shape");
  check_text_refused(R"({"do": "add_body", "shape": {"type": "box", "size": [1, 0, 1]}})", "/shape/size");
  check_text_refused(R"({"do": "add_body"})", "/shape");
  check_text_refused(R"({"do": "add_joint", "type": "hinge", "bodies": [0, 1], "anchor": [0, 0, 0]})",
                     "axis");
  check_text_refused(R"({"do": "add_joint", "type": "fixed", "bodies": [0, "a"], "anchor": [0, 0, 0]})",
                     "/bodies/1");
  check_text_refused(R"({"do": "add_joint", "type": "fixed", "bodies": [0, 1], "anchor": [0, 0, 0], "N": 4})",
                     "kappa");
}

TEST_CASE("a session pulls and reports bodies when asked") {
  Session session = session_of(kPair);
  session.report_bodies(true);
  session.report_contacts(true);
  session.record_iterations(true);
  session.set_pulls({{1, Vec3::Zero(), {-3, 5, 0}, 1e5}});
  run(session, 60);
  CHECK(session.state().c[1].y() > 3);
  CHECK(session.report().body_reports.size() == 3);
  session.edit(RemoveBody{1});  // and the hand lets go
  run(session, 60);
  CHECK(session.state().c[1].y() < 1);
}

TEST_CASE("friction, forces and groups follow the bodies that come and go") {
  Session session(parse_scene(R"({ "format": "pabd-scene", "version": 1, "bodies": [
    { "name": "a", "shape": { "type": "sphere", "radius": 0.1 }, "group": "g" },
    { "name": "b", "shape": { "type": "sphere", "radius": 0.1 }, "position": [1, 0, 0], "friction": 0.2 },
    { "name": "c", "shape": { "type": "sphere", "radius": 0.1 }, "position": [2, 0, 0], "group": "h", "force": [0, 1, 0], "surface_velocity": [0, 0, 2] } ],
    "no_collide": [[{ "group": "g" }, { "group": "h" }]] })",
                              "test.json", {}));
  CHECK(keeps_apart(session.model().groups, 0, 2));
  session.edit(RemoveBody{1});
  AddBody body;
  body.shape = Sphere{0.1};
  body.position = {3, 0, 0};
  session.edit(body);
  body.position = {4, 0, 0};
  body.friction = SurfaceFriction{0.7, 0.6};
  session.edit(edit_from_json(to_json(body), "test"));
  const Model& model = session.model();
  CHECK(keeps_apart(model.groups, 0, 1));
  CHECK_FALSE(keeps_apart(model.groups, 0, 2));
  REQUIRE(model.friction.size() == 4);
  CHECK_FALSE(model.friction[1]);
  REQUIRE(model.surface_velocity.size() == 4);
  CHECK(model.surface_velocity[1] == Vec3(0, 0, 2));
  REQUIRE(model.external.size() == 4);
  CHECK(model.external[1]->force_at(0) == Vec3::UnitY());
  CHECK_FALSE((model.external[0] || model.external[2] || model.external[3]));
  CHECK(model.friction[3] == SurfaceFriction{0.7, 0.6});
  session.step();
  CHECK(session.report().status == StepStatus::converged);
  CHECK_THROWS_AS(
      edit_from_json(R"({ "do": "add_body", "group": "g", "shape": { "type": "sphere", "radius": 1 } })",
                     "test"),
      Error);
}

TEST_CASE("a joint that goes takes along what it brought, and no pair that the scene states itself") {
  using Pairs = std::vector<std::pair<Index, Index>>;
  const auto ball = [](const char* name, int x) {
    return std::string(R"({ "name": ")") + name + R"(", "shape": { "type": "sphere", "radius": 0.1 },
      "position": [)" +
           std::to_string(x) + ", 0, 0] }";
  };
  const auto rod = [](const char* i, const char* j, const char* more) {
    return std::string(R"({ "type": "distance", "bodies": [")") + i + "\", \"" + j +
           R"("], "points": [[0, 0, 0], [1, 0, 0]])" + more + " }";
  };
  const auto rod_between = [](Index i, Index j) {
    AddJoint joint;
    joint.type = JointType::distance;
    joint.i = i;
    joint.j = j;
    joint.anchor_j = {1, 0, 0};
    return joint;
  };
  Session session(parse_scene(
      R"({ "format": "pabd-scene", "version": 1, "bodies": [ )" + ball("a", 0) + "," + ball("b", 1) + "," +
          ball("c", 2) + "," + ball("d", 3) + R"( ], "no_collide": [["c", "b"], ["d", "c"]], "joints": [ )" +
          rod("a", "b", "") + "," + rod("b", "c", "") + "," + rod("c", "d", R"(, "collide": true)") + "," +
          rod("a", "d", R"(, "collide": true)") + "] }",
      "test.json", {}));
  const Scene saved = parse_scene(
      scene_to_json(session.model(), session.state(), session.params(), {}, "saved", {}, {}), "saved", {});
  Session again(saved);
  for (Session* s : {&session, &again}) {
    const auto apart = [s] { return s->model().no_collide; };
    CHECK(apart() == Pairs{{0, 1}, {1, 2}, {2, 3}});
    s->edit(RemoveJoint{1});
    s->edit(RemoveJoint{1});
    CHECK(apart() == Pairs{{0, 1}, {1, 2}, {2, 3}});
    // A joint that lets its two touch holds nothing of what another one brings.
    s->edit(rod_between(3, 0));
    CHECK(apart() == Pairs{{0, 1}, {0, 3}, {1, 2}, {2, 3}});
    s->edit(RemoveJoint{2});
    CHECK(apart() == Pairs{{0, 1}, {1, 2}, {2, 3}});
    // Numbers move down.
    s->edit(RemoveBody{0});
    CHECK(apart() == Pairs{{0, 1}, {1, 2}});
    s->edit(rod_between(0, 1));
    s->edit(RemoveJoint{0});
    CHECK(apart() == Pairs{{0, 1}, {1, 2}});
  }
}

}  // namespace pabd::test_model_edit
