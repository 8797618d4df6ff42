// SPDX-License-Identifier: MIT
// A scene built in C++ is the one that a file with the same entries gives, and is refused with the same
// words.
#include "sim/scene/builder.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/body/shape_kind.h"
#include "sim/scene/document.h"
#include "sim/solver/time_step.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/places.h"

namespace pabd::test_builder {

using namespace test;

namespace {

// Equal to the last bit, now and after ten steps.
void check_same(const Scene& built, const Scene& read) {
  CHECK(built.name == read.name);
  CHECK(built.description == read.description);
  CHECK(built.hash == read.hash);
  CHECK(built.params == read.params);
  CHECK(built.model.name == read.model.name);
  CHECK(built.model.mass == read.model.mass);
  CHECK(built.model.J == read.model.J);
  CHECK(built.model.fixed == read.model.fixed);
  CHECK(built.model.no_collide == read.model.no_collide);
  REQUIRE(built.model.joints.size() == read.model.joints.size());
  for (std::size_t k = 0; k < read.model.joints.size(); ++k) {
    CHECK(built.model.joints[k].name == read.model.joints[k].name);
    CHECK(built.model.joints[k].law.kappa == read.model.joints[k].law.kappa);
    CHECK(built.model.joints[k].on_j.r == read.model.joints[k].on_j.r);
  }
  REQUIRE(built.camera.has_value() == read.camera.has_value());
  if (read.camera) CHECK(built.camera->eye == read.camera->eye);
  CHECK(built.duration == read.duration);
  State a = built.initial, b = read.initial;
  REQUIRE(same_bits(a, b));
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 10; ++k) {
    step(built.model, built.params, {}, a, workspace, report);
    step(read.model, read.params, {}, b, workspace, report);
  }
  CHECK(same_bits(a, b));
}

Vec3 vec3(const Json& list) { return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()}; }

std::string refusal(SceneBuilder& builder) {
  try {
    builder.build();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    return error.what();
  }
  return "accepted";
}

std::string refusal(const std::string& entries) {
  try {
    parse_scene(R"({ "format": "pabd-scene", "version": 1, )" + entries + " }", "it", {});
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("the shipped pyramid, built", "[scene]") {
  SceneBuilder builder("pyramid");
  builder.description = "210 bricks in a pyramid 20 levels high, resting on each other";
  builder.params.contact.d_hat = 0.01;
  builder.camera = CameraDesc{{7, 6.5, 17}, {0, 4.4, 0}, 45};
  builder.duration = 5;
  builder.add(spec::Pyramid{{.size = Vec3(1, 0.5, 0.5)}, 20});
  builder.add(spec::Body{.name = "ground", .shape = Plane{Vec3::UnitY(), 0}});
  check_same(builder.build(), load_scene(places::scenes() + "/pyramid.json"));
}

TEST_CASE("the shipped bridge, built", "[scene]") {
  const std::string text = read_scene_text(places::scenes() + "/bridge.json");
  const Json file = Json::parse(text);
  SceneBuilder builder("bridge");
  builder.description = file["description"];
  builder.duration = file["duration"].get<double>();
  builder.params.contact.kappa = 200;
  builder.params.contact.mu_static = builder.params.contact.mu_dynamic = 0.7;
  if (file.contains("camera")) {
    const Json& camera = file["camera"];
    builder.camera = CameraDesc{vec3(camera["eye"]), vec3(camera["target"]), camera.value("fov", 45.0)};
  }
  builder.add(spec::Body{.name = "ground", .shape = Plane{Vec3::UnitY(), 0}});
  for (std::size_t i = 1; i < file["bodies"].size(); ++i) {
    const Json& entry = file["bodies"][i];
    spec::Body body{.name = entry["name"],
                    .shape = Box{0.5 * vec3(entry["shape"]["size"])},
                    .fixed = entry.value("fixed", false),
                    .position = vec3(entry["position"])};
    if (entry.contains("density")) body.density = entry["density"];
    if (entry.contains("orientation")) body.orientation = entry["orientation"];
    builder.add(body);
  }
  for (const Json& entry : file["joints"]) {
    builder.add(spec::Joint{.type = JointType::hinge,
                            .i = entry["bodies"][0],
                            .j = entry["bodies"][1],
                            .anchor = vec3(entry["anchor"]),
                            .axis = vec3(entry["axis"])});
  }
  check_same(builder.build(), load_scene(places::scenes() + "/bridge.json"));
}

TEST_CASE("every generator and every kind of joint, built", "[scene]") {
  const Scene read = parse_scene(R"({ "format": "pabd-scene", "version": 1, "name": "all",
    "gravity": [0, -1, 0], "time_step": 0.01, "joints_default": { "potential": "hard", "kappa": 2, "N": 3, "d_hat": 0.02 },
    "bodies": [
      { "name": "a", "shape": { "type": "sphere", "radius": 0.4 }, "mass": 3, "position": [0, 50, 0] },
      { "name": "b", "shape": { "type": "capsule", "radius": 0.2, "length": 1 }, "density": 300, "position": [2, 50, 0],
        "orientation": [0.6, 0, 0.8, 0], "velocity": [1, 2, 3], "angular_velocity": [10, 20, 30] },
      { "shape": { "type": "box", "size": [1, 2, 3] }, "position": [4, 50, 0] },
      { "shape": { "type": "cylinder", "radius": 0.3, "height": 2 }, "position": [60, 50, 0] },
      { "shape": { "type": "cone", "radius": 0.7, "height": 1.5 }, "position": [70, 50, 0] } ],
    "joints": [
      { "type": "spherical", "bodies": [null, "a"], "anchor": [0, 51, 0], "axes": "xz", "arm": 0.3, "symmetric": false,
        "drive": { "keys": [[0, [0, 0, 0]], [1, [0, 30, 0]]] } },
      { "type": "hinge", "name": "h", "bodies": ["a", "b"], "anchor": [1, 50, 0], "axis": [0, 0, 2], "limits": [-30, 45],
        "collide": true },
      { "type": "slider", "bodies": ["b", "body 2"], "anchor": [3, 50, 0], "axis": [1, 0, 0],
        "drive": { "keys": [[0, 0], [2, 0.5]] }, "twist": { "limits": [-5, 5] }, "potential": "soft", "kappa": "auto" },
      { "type": "fixed", "bodies": ["b", "body 2"], "anchor": [3, 51, 0], "kappa": 7 },
      { "type": "distance", "bodies": ["a", "body 2"], "points": [[0, 50, 0], [4, 50, 0]], "length": 3.9 } ],
    "generate": [
      { "type": "stack", "name": "s", "count": 3, "masses": [1, 2], "rotate": 10, "gap": 0.02, "position": [10, 0, 0] },
      { "type": "wall", "columns": 3, "rows": 2, "spacing": 0.1, "half_blocks": false, "density": 200, "position": [20, 0, 0] },
      { "type": "pile", "count": 5, "shape": "mixed", "vary": 0.2, "columns": 2, "spacing": 3, "seed": 9, "mass": 2,
        "position": [30, 0, 0] },
      { "type": "chain", "links": 3, "shape": "capsule", "size": [0.5, 0.1, 0.1], "gap": 0.01, "direction": [0, -1, 0],
        "joint": "hinge", "axis": [1, 0, 0], "fixed": "both", "end_mass": 4, "collide": true, "position": [40, 20, 0] },
      { "type": "net", "rows": 2, "columns": 3, "shape": "sphere", "size": [0.2, 0.2, 0.2], "gap": 0.1, "upright": true,
        "joint": "distance", "fixed": "top", "collide": true, "position": [50, 20, 0] } ] })",
                                 "it", {});
  SceneBuilder builder("all");
  builder.params.gravity = {0, -1, 0};
  builder.params.h = 0.01;
  builder.joint_law = {BondPotential::hard, 2, 3, 0.02};
  builder.add(spec::Body{.name = "a", .shape = Sphere{0.4}, .mass = 3, .position = Vec3(0, 50, 0)});
  builder.add(spec::Body{.name = "b",
                         .shape = Capsule{0.2, 1},
                         .density = 300,
                         .position = Vec3(2, 50, 0),
                         .orientation = {{0.6, 0, 0.8, 0}},
                         .velocity = Vec3(1, 2, 3),
                         .angular_velocity = Vec3(10, 20, 30)});
  builder.add(spec::Body{.shape = Box{{0.5, 1, 1.5}}, .position = Vec3(4, 50, 0)});
  builder.add(spec::Body{.shape = make_shape("cylinder", {0.3, 2}), .position = Vec3(60, 50, 0)});
  builder.add(spec::Body{.shape = make_shape("cone", {0.7, 1.5}), .position = Vec3(70, 50, 0)});
  builder.add(spec::Joint{.j = "a",
                          .anchor = Vec3(0, 51, 0),
                          .arm = 0.3,
                          .symmetric = false,
                          .turn = TurnProfile{{{0, Vec3::Zero()}, {1, Vec3(0, 30, 0)}}},
                          .axes = "xz"});
  builder.add(spec::Joint{.type = JointType::hinge,
                          .i = "a",
                          .j = "b",
                          .name = "h",
                          .anchor = Vec3(1, 50, 0),
                          .axis = Vec3(0, 0, 2),
                          .limits = {{-30, 45}},
                          .collide = true});
  builder.add(spec::Joint{.type = JointType::slider,
                          .i = "b",
                          .j = "body 2",
                          .anchor = Vec3(3, 50, 0),
                          .axis = Vec3(1, 0, 0),
                          .drive = Profile{{{0, 0}, {2, 0.5}}},
                          .twist_limits = {{-5, 5}},
                          .law = {.potential = BondPotential::soft, .kappa = kAutoKappa}});
  builder.add(spec::Joint{
      .type = JointType::fixed, .i = "b", .j = "body 2", .anchor = Vec3(3, 51, 0), .law = {.kappa = 7}});
  builder.add(spec::Joint{.type = JointType::distance,
                          .i = "a",
                          .j = "body 2",
                          .points = {Vec3(0, 50, 0), Vec3(4, 50, 0)},
                          .length = 3.9});
  builder.add(spec::Stack{{.name = "s", .position = Vec3(10, 0, 0), .gap = 0.02}, 3, {1, 2}, 10});
  builder.add(spec::Wall{{.position = Vec3(20, 0, 0), .density = 200}, 3, 2, 0.1, false});
  builder.add(spec::Pile{.count = 5,
                         .shape = "mixed",
                         .position = Vec3(30, 0, 0),
                         .mass = 2,
                         .vary = 0.2,
                         .columns = 2,
                         .spacing = 3,
                         .seed = 9});
  builder.add(spec::Chain{.links = 3,
                          .shape = "capsule",
                          .size = Vec3(0.5, 0.1, 0.1),
                          .position = Vec3(40, 20, 0),
                          .gap = 0.01,
                          .direction = Vec3(0, -1, 0),
                          .joint = JointType::hinge,
                          .axis = Vec3(1, 0, 0),
                          .fixed = "both",
                          .end_mass = 4,
                          .collide = true});
  builder.add(spec::Net{.rows = 2,
                        .columns = 3,
                        .shape = "sphere",
                        .size = Vec3(0.2, 0.2, 0.2),
                        .position = Vec3(50, 20, 0),
                        .gap = 0.1,
                        .upright = true,
                        .joint = JointType::distance,
                        .fixed = "top",
                        .collide = true});
  check_same(builder.build(), read);
}

TEST_CASE("hulls that a program has", "[scene]") {
  const std::string file = GENERATE("meshes", "chairs");  // single ones, and several as one body
  const Scene read = load_scene(places::scenes() + "/" + file + ".json");
  std::size_t hulls = 0;
  SceneBuilder builder("mine");
  for (std::size_t i = 0; i < read.model.shape.size(); ++i) {
    const Shape& shape = read.model.shape[i];
    if (!std::holds_alternative<Hull>(shape) && !std::holds_alternative<Compound>(shape)) continue;
    ++hulls;
    builder.add(spec::Body{.name = read.model.name[i],
                           .shape = shape,
                           .mass = read.model.mass[i],
                           .position = read.initial.c[i]});
  }
  REQUIRE(hulls > 0);
  const Scene built = builder.build();
  CHECK(built.files.empty());
  for (std::size_t k = 0; k < hulls; ++k) {
    const auto place = std::find(read.model.name.begin(), read.model.name.end(), built.model.name[k]);
    const auto i = static_cast<std::size_t>(place - read.model.name.begin());
    CHECK((built.model.J[k] - read.model.J[i]).norm() <= 1e-15 * read.model.J[i].norm());  // density: m / V
    CHECK(built.model.mass[k] == read.model.mass[i]);
  }
}

TEST_CASE("what was built may grow", "[scene]") {
  SceneBuilder builder("growing");
  builder.add(spec::Body{});
  CHECK(builder.build().model.size() == 1);
  builder.add(spec::Body{.position = Vec3(3, 0, 0)});
  builder.params.h = 0.02;
  const Scene scene = builder.build();
  CHECK(scene.model.name == std::vector<std::string>{"body 0", "body 1"});
  CHECK(scene.params.h == 0.02);
}

TEST_CASE("a built scene is refused with the words of a file", "[scene]") {
  const auto both = [](const std::string& entries, const auto& fill) {
    SceneBuilder builder("it");
    fill(builder);
    const std::string message = refusal(entries);
    CHECK_THAT(message, Catch::StartsWith("it: /"));
    CHECK(refusal(builder) == message);
  };
  const std::string box = R"({ "shape": { "type": "box", "size": [1, 1, 1] } )";
  both(R"("bodies": [])", [](SceneBuilder&) {});
  both(R"("bodies": [{ "shape": { "type": "sphere", "radius": -1 } }])",
       [](SceneBuilder& b) { b.add(spec::Body{.shape = Sphere{-1}}); });
  both(R"("bodies": [)" + box + R"(, "mass": 1, "density": 2 }])",
       [](SceneBuilder& b) { b.add(spec::Body{.mass = 1, .density = 2}); });
  both(R"("bodies": [)" + box + R"(, "position": [0, 2e6, 0] }])",
       [](SceneBuilder& b) { b.add(spec::Body{.position = Vec3(0, 2e6, 0)}); });
  both(R"("bodies": [)" + box + R"(, "orientation": [1, 1, 0, 0] }])", [](SceneBuilder& b) {
    b.add(spec::Body{.orientation = {{1, 1, 0, 0}}});
  });
  both(R"("bodies": [)" + box + R"(, "fixed": true, "velocity": [1, 0, 0] }])",
       [](SceneBuilder& b) { b.add(spec::Body{.fixed = true, .velocity = Vec3(1, 0, 0)}); });
  both(R"("bodies": [)" + box + R"(, "name": "x" }, )" + box + R"(, "name": "x" }])", [](SceneBuilder& b) {
    b.add(spec::Body{.name = "x"});
    b.add(spec::Body{.name = "x"});
  });
  both(R"("bodies": [)" + box +
           R"(, "name": "crate" }], "joints": [{ "type": "hinge", "bodies": ["crat", null],
          "anchor": [0, 0, 0], "axis": [1, 0, 0] }])",
       [](SceneBuilder& b) {
         b.add(spec::Body{.name = "crate"});
         b.add(spec::Joint{
             .type = JointType::hinge, .i = "crat", .anchor = Vec3::Zero(), .axis = Vec3::UnitX()});
       });
  both(R"("bodies": [)" + box + R"(}], "joints": [{ "type": "hinge", "bodies": ["body 0", null],
          "anchor": [0, 0, 0] }])",
       [](SceneBuilder& b) {
         b.add(spec::Body{});
         b.add(spec::Joint{.type = JointType::hinge, .i = "body 0", .anchor = Vec3::Zero()});
       });
  both(R"("bodies": [)" + box + R"(}], "joints": [{ "type": "hinge", "bodies": ["body 0", null],
          "anchor": [0, 0, 0], "axis": [1, 0, 0], "limits": [10, 20] }])",
       [](SceneBuilder& b) {
         b.add(spec::Body{});
         b.add(spec::Joint{.type = JointType::hinge,
                           .i = "body 0",
                           .anchor = Vec3::Zero(),
                           .axis = Vec3::UnitX(),
                           .limits = {{10, 20}}});
       });
  both(R"("generate": [{ "type": "pyramid", "base": 0 }])",
       [](SceneBuilder& b) { b.add(spec::Pyramid{.base = 0}); });
  both(R"("contact": { "d_hat": -1 }, "generate": [{ "type": "pyramid", "base": 1 }])", [](SceneBuilder& b) {
    b.params.contact.d_hat = -1;
    b.add(spec::Pyramid{.base = 1});
  });
}

TEST_CASE("numbers that a file cannot hold are refused", "[scene]") {
  SceneBuilder builder("it");
  builder.add(spec::Body{.mass = std::numeric_limits<double>::quiet_NaN()});
  CHECK_THAT(refusal(builder), Catch::StartsWith("it: /bodies/0/mass: expected a number from 1e-09 to"));
}

}  // namespace pabd::test_builder
