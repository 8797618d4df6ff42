// SPDX-License-Identifier: MIT
// A run saved as a scene in the middle and loaded again goes on as the run does.

#include <catch2/catch.hpp>
#include <limits>

#include "app/session/session.h"
#include "app/session/timeline.h"
#include "sim/base/error.h"
#include "sim/scene/write_scene.h"
#include "tests/support/places.h"

namespace pabd::test_write_scene {

namespace {

std::string saved(const Session& session) {
  const Scene& scene = session.scene();
  return scene_to_json(session.model(), session.state(), session.params(), scene.joint_law, scene.name,
                       scene.camera, scene.duration);
}

Session loaded(const std::string& text) { return Session(parse_scene(text, "saved.json", {})); }

}  // namespace

TEST_CASE("a run saved in the middle and loaded goes on as it would: 1e-9 m over 50 steps") {
  // Friction that sticks, stiff and soft joints, drives, limits.
  for (const char* name : {"two_boxes", "bridge", "slider_crank", "incline", "ragdoll", "trampoline",
                           "four_bar", "ferris_wheel", "shapes", "newtons_cradle"}) {
    CAPTURE(name);
    Scene scene = load_scene(std::string(places::scenes() + "/") + name + ".json");
    scene.params.solver.integrator =
        Integrator::euler;  // bdf2 remembers a step, which is in state files only
    Session original(std::move(scene));
    for (int k = 0; k < 70; ++k) original.step();
    Session again = loaded(saved(original));
    CHECK(largest_distance(original.state(), again.state()) < 1e-15);
    CHECK(again.state().time == 0);
    for (int k = 0; k < 50; ++k) {
      original.step();
      again.step();
    }
    // The ball lands in the net: the last bit decides how many iterations a step takes, and so two steps end
    // within the tolerance of each other.
    const Params& params = original.params();
    const bool lands = std::string_view(name) == "trampoline";
    const double bound = lands ? 50 * params.solver.tolerance * params.contact.d_hat : 1e-9;
    CHECK(largest_distance(original.state(), again.state()) < bound);
    CHECK(again.report().elastic == Approx(original.report().elastic).epsilon(1e-6).margin(1e-9));
  }
}

TEST_CASE("what friction keeps from rolling down a slope is kept by a run that was saved") {
  const std::string scene =
      R"({ "format": "pabd-scene", "version": 1, "name": "held", "gravity": [1.5, -9.7, 0],
    "contact": { "friction": { "static": 0.8, "rolling": 0.05, "torsional": 0.01 } },
    "bodies": [{ "name": "ground", "shape": { "type": "plane" } },
               { "name": "ball", "shape": { "type": "sphere", "radius": 0.2 }, "mass": 5, "position": [0, 0.2096, 0] },
               { "name": "turns", "fixed": true, "shape": { "type": "box", "size": [1, 0.2, 1] }, "position": [5, 0, 0],
                 "orientation": { "axis": [1, 2, 0.3], "angle": 3 } },
               { "name": "can", "shape": { "type": "cylinder", "radius": 0.2, "height": 0.3 }, "mass": 5,
                 "position": [5, 0.32, 0], "orientation": { "axis": [1, 0, 0], "angle": 90 } }] })";
  Session original(parse_scene(scene, "held.json", {}));
  for (int k = 0; k < 90; ++k) original.step();
  Session again = loaded(saved(original));
  for (int k = 0; k < 30; ++k) {
    original.step();
    again.step();
  }
  CHECK(original.state().v[1].norm() < 1e-6);
  CHECK(largest_distance(original.state(), again.state()) < 1e-12);
}

TEST_CASE("what was saved comes back: names, laws, drives, limits, collisions") {
  Session first(parse_scene(R"({ "format": "pabd-scene", "version": 1, "name": "odd \"name\"",
    "time_step": 0.01, "gravity": [0, -3, 1], "contact": { "kappa": 7, "onset": 0.3 },
    "solver": { "integrator": "euler" },
    "joints_default": { "potential": "hard", "kappa": 500, "N": 6, "d_hat": 0.02 },
    "camera": { "eye": [1, 2, 3], "target": [0, 0, 0], "fov": 30 },
    "duration": 7.5,
    "bodies": [
      { "name": "floor", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": -9 } },
      { "name": "post", "shape": { "type": "box", "size": [1, 1, 1] }, "fixed": true, "position": [0, 3, 0] },
      { "name": "ball", "shape": { "type": "sphere", "radius": 0.4 }, "mass": 3, "position": [2, 3, 0] },
      { "name": "pill", "shape": { "type": "capsule", "radius": 0.2, "length": 1 }, "position": [4, 3, 0],
        "velocity": [0, 1, 0], "angular_velocity": [10, 20, 30] },
      { "name": "cart", "shape": { "type": "box", "size": [1, 2, 3] }, "position": [9, 3, 0] } ],
    "joints": [
      { "type": "spherical", "bodies": ["post", "ball"], "anchor": [1, 3, 0], "axes": "xy", "collide": true,
        "drive": { "keys": [[0, [0, 0, 0]], [0.5, [0, 30, 10]], [2, [40, 0, 0]]] } },
      { "type": "slider", "bodies": ["ball", "pill"], "anchor": [3, 3, 0], "axis": [1, 1, 0], "symmetric": false,
        "limits": [-0.001, 0.2], "twist": { "limits": [-170, 175] }, "potential": "soft", "kappa": "auto" },
      { "name": "spring", "type": "distance", "bodies": [null, "pill"], "points": [[4, 6, 0], [4, 3, 0]],
        "length": 2.5, "potential": "soft", "kappa": 40 },
      { "type": "slider", "bodies": [null, "cart"], "anchor": [9, 3, 0], "axis": [0, 0, 1], "twist": "free",
        "drive": { "keys": [[0.1, 0], [3, 1.5]] } } ] })",
                            "test.json", {}));
  for (int k = 0; k < 60; ++k) first.step();
  const std::string text = saved(first);
  Session second = loaded(text);
  CHECK(second.scene().name == "odd \"name\"");
  REQUIRE(second.scene().camera.has_value());
  CHECK(second.scene().camera->fov == 30);
  CHECK(second.scene().duration == 7.5);
  CHECK(second.params().h == 0.01);
  CHECK(second.params().contact.kappa == 7);
  CHECK(second.model().name == first.model().name);
  CHECK(second.model().no_collide == first.model().no_collide);
  CHECK(second.model().no_collide.size() == 1);
  for (std::size_t k = 0; k < 4; ++k) {
    const Joint &a = first.model().joints[k], &b = second.model().joints[k];
    CAPTURE(a.name);
    CHECK(a.name == b.name);
    CHECK(a.type == b.type);
    CHECK(a.arms == b.arms);
    CHECK(a.symmetric == b.symmetric);
    CHECK(a.twist == b.twist);
    CHECK(a.limit_scale == b.limit_scale);
    CHECK(a.law.potential == b.law.potential);
    CHECK(a.law.kappa == Approx(b.law.kappa).epsilon(1e-12));
    CHECK(a.arm == b.arm);
    CHECK(a.length == b.length);
    if (a.limits) CHECK(a.limits->hi == Approx(b.limits->hi).epsilon(1e-14));
    if (a.twist_limits) CHECK(a.twist_limits->lo == Approx(b.twist_limits->lo).epsilon(1e-14));
    for (const double t : {0.0, 0.3, 1.0, 5.0}) {
      const double now = first.state().time;
      if (a.drive) CHECK(a.drive->at(now + t) == Approx(b.drive->at(t)).epsilon(1e-12).margin(1e-14));
      if (a.turn) CHECK((a.turn->at(now + t) - b.turn->at(t)).norm() < 1e-14);
    }
  }
  for (int k = 0; k < 50; ++k) {
    first.step();
    second.step();
  }
  CHECK(largest_distance(first.state(), second.state()) < 1e-9);
}

TEST_CASE("joints without names get free ones; edits are saved as well") {
  Session session(load_scene(places::scenes() + "/bridge.json"));
  session.step();
  session.edit(RemoveJoint{0});
  session.edit(AddBody{.name = {}, .shape = Sphere{0.2}, .mass = {}, .position = {0, 8, 0}});
  Session again = loaded(saved(session));
  CHECK(again.model().size() == session.model().size());
  CHECK(again.model().joints.size() == session.model().joints.size());
  for (const Joint& joint : again.model().joints) CHECK_FALSE(joint.name.empty());
}

TEST_CASE("a state that no scene file can hold is refused in one line") {
  const auto refused = [](const Session& session, const char* part) {
    try {
      saved(session);
      FAIL_CHECK("accepted; expected a refusal about " << part);
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::bad_input);
      CHECK_THAT(error.what(), Catch::Contains(part));
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  };
  refused(Session(load_scene(places::scenes() + "/meshes.json")), "mesh file");
  Session session(load_scene(places::scenes() + "/two_boxes.json"));
  State state = session.state();
  Index body = 0;
  while (session.model().fixed[static_cast<std::size_t>(body)]) ++body;
  state.v[static_cast<std::size_t>(body)] = {2e6, 0, 0};
  session.set_state(state);
  refused(session, "velocity");
  state.v[static_cast<std::size_t>(body)] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  session.set_state(state);
  refused(session, "velocity");
}

TEST_CASE("colours and materials come back as they were; nothing is said of bodies without") {
  const std::string text = R"({ "format": "pabd-scene", "version": 1,
    "bodies": [
      { "name": "hex", "shape": { "type": "sphere", "radius": 1 }, "color": "#c8775c" },
      { "name": "numbers", "shape": { "type": "sphere", "radius": 1 }, "position": [3, 0, 0],
        "color": [0.1, 0.25, 1], "material": { "opacity": 0.4, "checker": true } },
      { "name": "plain", "shape": { "type": "sphere", "radius": 1 }, "position": [6, 0, 0] } ] })";
  const Scene first = parse_scene(text, "colours", {});
  REQUIRE(first.looks.size() == 2);
  CHECK((*first.looks.at("hex").color - Vec3(0xc8, 0x77, 0x5c) / 255).norm() < 1e-15);
  CHECK(first.looks.at("numbers").opacity == 0.4);
  CHECK(first.looks.at("numbers").checker);
  const std::string saved = scene_to_json(first.model, first.initial, first.params, first.joint_law, "again",
                                          {}, std::nullopt, parameter_table(), first.looks);
  const Scene again = parse_scene(saved, "again", {});
  CHECK(again.looks == first.looks);
  CHECK(saved.find("\"#c8775c\"") != saved.npos);
  // Not what a run depends on.
  const Scene plain = parse_scene(R"({ "format": "pabd-scene", "version": 1, "bodies": [
      { "name": "hex", "shape": { "type": "sphere", "radius": 1 } } ] })",
                                  "plain", {});
  CHECK(plain.looks.empty());
}

TEST_CASE("a wrong colour is refused, with its place and what was expected") {
  const auto scene_with = [](const std::string& keys) {
    return R"({ "format": "pabd-scene", "version": 1, "bodies": [
      { "shape": { "type": "sphere", "radius": 1 }, )" +
           keys + " } ] }";
  };
  for (const char* wrong :
       {R"("color": "red")", R"("color": "#12345")", R"("color": "#12345g")", R"("color": "#1234567")",
        R"("color": [1, 2, 0])", R"("color": [1, 0])", R"("color": 7)", R"("material": { "opacity": 1.5 })",
        R"("material": { "shiny": true })", R"("material": "glass")"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_scene(scene_with(wrong), "wrong", {}), Error);
  }
  try {
    parse_scene(scene_with(R"("color": "red")"), "wrong", {});
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find("/bodies/0/color") != std::string::npos);
    CHECK(std::string(error.what()).find("#rrggbb") != std::string::npos);
  }
}

}  // namespace pabd::test_write_scene
