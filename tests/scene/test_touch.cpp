// SPDX-License-Identifier: MIT
// Friction of single bodies, and groups that never touch: read, written, refused, and what comes of it.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "sim/scene/builder.h"
#include "sim/scene/write_scene.h"
#include "sim/solver/friction.h"
#include "sim/solver/restitution.h"
#include "sim/solver/time_step.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_touch {

using namespace test;

namespace {

State after(const Scene& scene, double time) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  while (state.time < time) step(scene.model, scene.params, {}, state, workspace, report);
  return state;
}

std::string box(const std::string& name, const std::string& rest) {
  return R"({ "name": ")" + name + R"(", "shape": { "type": "box", "size": [1, 1, 1] }, )" + rest + " }";
}

std::string written(const Scene& s) {
  return scene_to_json(s.model, s.initial, s.params, s.joint_law, s.name, {}, {}, parameter_table(), s.looks);
}

const std::string kGround = R"({ "name": "ground", "shape": { "type": "plane" }, "group": "floor" })";

// Two boxes that fall, one above the other, and the ground.
std::string falling(const std::string& low, const std::string& high, const std::string& rest) {
  return scene_text(R"("bodies": [)" + kGround + ", " +
                    box("low", R"("position": [0, 0.51, 0], "group": )" + low) + ", " +
                    box("high", R"("position": [0, 1.53, 0], "group": )" + high) + "]" + rest);
}

}  // namespace

TEST_CASE("a body has friction of its own, as one number or two", "[scene]") {
  const Scene s = parse(
      scene_text(R"("contact": { "friction_rule": "min" }, "bodies": [)" + box("a", R"("friction": 0.7)") +
                 ", " + box("b", R"("position": [3, 0, 0])") + ", " + box("c", R"("position": [6, 0, 0],
                                     "friction": { "static": 0.4, "dynamic": 0.1 })") +
                 R"(, { "shape": { "type": "plane", "offset": -9 }, "friction": 0 }])"));
  REQUIRE(s.model.friction.size() == 4);
  CHECK(s.model.friction[0] == SurfaceFriction{0.7, 0.7});
  CHECK_FALSE(s.model.friction[1]);
  CHECK(s.model.friction[2] == SurfaceFriction{0.4, 0.1});
  CHECK(s.model.friction[3] == SurfaceFriction{0, 0});
  CHECK(s.params.contact.friction_rule == FrictionRule::min);
  const Scene again = parse(written(s));
  CHECK(again.model.friction == s.model.friction);
  CHECK(again.params == s.params);
}

TEST_CASE("friction against turns is read, written and combined", "[scene]") {
  const Scene s = parse(scene_text(
      R"("contact": { "friction": { "static": 0.6, "rolling": 0.01, "torsional": 0.03 } }, "bodies": [)" +
      box("a", R"("friction": { "static": 0.4, "torsional": 0.12, "rolling": 0.09 })") + ", " +
      box("b", R"("position": [3, 0, 0])") + ", " + box("c", R"("position": [6, 0, 0], "friction": 0.4)") +
      "]"));
  CHECK(s.params.contact.rolling == 0.01);
  CHECK(s.params.contact.torsional == 0.03);
  CHECK(s.model.friction[0] == SurfaceFriction{0.4, 0.4, 0.12, 0.09});
  CHECK(s.model.friction[2] == SurfaceFriction{0.4, 0.4});
  const Scene again = parse(written(s));
  CHECK(again.model.friction == s.model.friction);
  CHECK(again.params == s.params);
  const auto between = [&](Index i, Index j) { return friction_between(s.model, s.params.contact, i, j); };
  CHECK(between(0, 1).torsional == Approx(0.06));
  CHECK(between(0, 1).rolling == Approx(0.03));
  CHECK(between(1, 2).rolling == 0);  // a number says that there is none
  CHECK(between(1, 1) == SurfaceFriction{0.6, 0.6, 0.03, 0.01});
  SceneBuilder builder("scene");
  builder.add(spec::Body{.name = "a", .friction = SurfaceFriction{0.4, 0.3, 0.12, 0.09}});
  CHECK(builder.build().model.friction[0] == SurfaceFriction{0.4, 0.3, 0.12, 0.09});
}

TEST_CASE("bodies, generators and builders have restitution of their own", "[scene]") {
  const std::string plain = only_body(box("a", R"("mass": 1)"));
  CHECK(parse(plain, {"contact.restitution=0"}).hash == parse(plain).hash);
  CHECK(parse(plain, {"contact.restitution=0.5"}).hash != parse(plain).hash);
  check_refused(only_body(box("a", R"("restitution": 1.1)")), {"/bodies/0/restitution", "0 to 1"});
  const Scene s =
      parse(scene_text(R"("name": "it", "contact": { "restitution": 0.2 }, "bodies": [)" +
                       box("a", R"("restitution": 0.8)") + ", " + box("b", R"("position": [3, 0, 0])") +
                       R"(], "generate": [{ "type": "stack", "count": 2, "position": [6, 0, 0],
                                                       "restitution": 0.5 }])"));
  CHECK(s.model.restitution == std::vector<std::optional<double>>{0.8, std::nullopt, 0.5, 0.5});
  const Scene again = parse(written(s));
  CHECK(again.model.restitution == s.model.restitution);
  CHECK(again.params == s.params);
  const auto e = [&](Index i, Index j) { return restitution_between(s.model, s.params.contact, i, j); };
  CHECK(e(0, 1) == Approx(std::sqrt(0.8 * 0.2)));
  CHECK(e(2, 3) == Approx(0.5));
  SceneBuilder builder("it");
  builder.params.contact.restitution = 0.2;
  builder.add(spec::Body{.name = "a", .restitution = 0.8});
  builder.add(spec::Body{.name = "b", .position = Vec3(3, 0, 0)});
  builder.add(spec::Stack{{.position = Vec3(6, 0, 0), .restitution = 0.5}, 2});
  CHECK(builder.build().hash == s.hash);
}

TEST_CASE("friction that no surface has is refused", "[scene]") {
  const auto with = [](const std::string& friction) {
    return only_body(box("a", R"("friction": )" + friction));
  };
  const std::string at = "/bodies/0/friction";
  check_refused(with("-0.1"), {at, "0 to 100"});
  check_refused(with("\"high\""), {at, "0 to 100", "\"static\""});
  check_refused(with(R"({ "dynamic": 0.2 })"), {at + "/static", "missing"});
  check_refused(with(R"({ "static": 0.2, "dynamic": 0.3 })"), {at + "/dynamic", "not above the static one"});
  check_refused(with(R"({ "static": 0.2, "rolling": -1 })"), {at + "/rolling", "0 to 1000"});
  check_refused(with(R"({ "static": 0.2, "twisting": 0.3 })"), {at + "/twisting", "unknown key", "rolling"});
  check_refused(with_body(R"("contact": { "friction_rule": "mean" })"),
                {"/contact/friction_rule", "\"geometric_mean\"", "\"product\""});
}

TEST_CASE("what says nothing of friction and groups keeps its hash; each value changes it", "[scene]") {
  const std::string plain = only_body(box("a", R"("mass": 1)"));
  std::set<std::string> seen{parse(plain).hash};
  CHECK(parse(plain, {"contact.friction_rule=geometric_mean"}).hash == parse(plain).hash);
  for (
      const char* change :
      {"contact.friction_rule=max",
       R"(bodies.0={"shape":{"type":"box","size":[1,1,1]},"mass":1,"name":"a","friction":0.5})",
       "contact.friction.rolling=0.01", "contact.friction.torsional=0.01",
       R"(bodies.0={"shape":{"type":"box","size":[1,1,1]},"mass":1,"name":"a","friction":{"static":0.5,"rolling":0.1}})",
       R"(bodies.0={"shape":{"type":"box","size":[1,1,1]},"mass":1,"name":"a","friction":{"static":0.5,"dynamic":0.4}})",
       R"(bodies.0={"shape":{"type":"box","size":[1,1,1]},"mass":1,"name":"a","group":"g"})",
       R"(bodies.0={"shape":{"type":"box","size":[1,1,1]},"mass":1,"name":"a","group":["g","h"]})"})
    CHECK(seen.insert(parse(plain, {change}).hash).second);
}

TEST_CASE("generators give all their bodies friction and groups", "[scene]") {
  for (const char* generator :
       {R"("type": "stack", "count": 2)", R"("type": "wall", "columns": 2, "rows": 1)",
        R"("type": "pyramid", "base": 2)", R"("type": "pile", "count": 3)", R"("type": "chain", "links": 2)",
        R"("type": "net", "rows": 2, "columns": 2)"}) {
    INFO(generator);
    const Scene s = parse(scene_text(
        R"("bodies": [)" + box("a", R"("position": [0, 50, 0])") + R"(], "generate": [{ )" + generator +
        R"(, "friction": 0.25, "group": ["g", "h"] }, { "type": "stack", "name": "s",
                                        "count": 1, "position": [90, 0, 0] }])"));
    const std::size_t n = s.model.shape.size();
    REQUIRE(s.model.friction.size() == n);
    REQUIRE(s.model.groups.of_body.size() == n);
    for (std::size_t i = 0; i < n; ++i) {
      const bool made = i > 0 && i + 1 < n;
      CHECK(s.model.friction[i].has_value() == made);
      CHECK(s.model.groups.of_body[i] == (made ? 3u : 0u));
    }
  }
}

TEST_CASE("two groups fall through each other and rest on all else", "[scene]") {
  const std::string pair = R"(, "no_collide": [[{ "group": "dust" }, { "group": "air" }]])";
  const Scene meet = parse(falling("\"dust\"", "\"air\"", "")),
              apart = parse(falling("\"dust\"", "\"air\"", pair));
  CHECK(after(meet, 1.5).c[2].y() > 1.49);
  const State fallen = after(apart, 1.5);
  CHECK(fallen.c[1].y() == Approx(0.51).margin(0.011));
  CHECK(fallen.c[2].y() == Approx(0.51).margin(0.011));  // inside the other one, on the ground
  CHECK(meet.hash != apart.hash);
  // A body of several groups avoids what any of them avoids, in either order of the pair.
  const Scene several = parse(falling(R"(["dust", "heavy"])", "\"air\"",
                                      R"(, "no_collide": [[{ "group": "air" }, { "group": "heavy" }]])"));
  CHECK(same_bits(after(several, 1.5), fallen));
  // Nor does it touch the ground, if it is said so.
  const Scene ground =
      parse(falling("\"dust\"", "\"air\"", R"(, "no_collide": [[{ "group": "air" }, "ground"]])"));
  CHECK(ground.model.no_collide == std::vector<std::pair<Index, Index>>{{0, 2}});
  const Scene floor =
      parse(falling("\"dust\"", "\"air\"", R"(, "no_collide": [[{ "group": "air" }, { "group": "floor" }],
                                                                [{ "group": "air" }, { "group": "dust" }]])"));
  CHECK(floor.model.no_collide.empty());
  const State through = after(floor, 1.5);
  CHECK(through.c[2].y() < -5);
  CHECK(through.c[1].y() > 0.49);
}

TEST_CASE("bodies of one group that avoids itself fly as if each were alone, however many overlap",
          "[scene]") {
  const Scene s = parse(
      scene_text(R"("generate": [{ "type": "pile", "count": 64, "size": [0.5, 0.5, 0.5], "group": "dust" }],
                    "bodies": [{ "name": "x", "shape": { "type": "sphere", "radius": 9 }, "group": "dust" }],
                    "no_collide": [[{ "group": "dust" }, { "group": "dust" }]])"));
  const State state = after(s, 1);
  const double fall = 0.5 * 9.81 * state.time * state.time;
  for (std::size_t i = 0; i < state.c.size(); ++i)
    CHECK((state.c[i] - s.initial.c[i] + fall * Vec3::UnitY()).norm() < 1e-9);
  CHECK(state.contacts.empty());
}

TEST_CASE("a body and a group are pairs of bodies", "[scene]") {
  const Scene s = parse(scene_text(R"("bodies": [)" + box("a", R"("group": "g")") + ", " +
                                   box("b", R"("position": [3, 0, 0])") + ", " +
                                   box("c", R"("position": [6, 0, 0], "group": "g")") +
                                   R"(], "no_collide": [["b", { "group": "g" }], [{ "group": "g" }, "a"]])"));
  CHECK(s.model.no_collide == std::vector<std::pair<Index, Index>>{{0, 1}, {0, 2}, {1, 2}});
}

TEST_CASE("groups that cannot be are refused", "[scene]") {
  const auto with = [](const std::string& group, const std::string& pairs) {
    return scene_text(R"("bodies": [)" + box("a", R"("group": )" + group) + R"(], "no_collide": [)" + pairs +
                      "]");
  };
  check_refused(with("3", ""), {"/bodies/0/group", "the name of a group"});
  check_refused(with("[]", ""), {"/bodies/0/group", "0 groups", "1 to 64"});
  check_refused(with(R"(["g", "g"])", ""), {"/bodies/0/group/1", "\"g\" is there twice"});
  check_refused(with(R"("")", ""), {"/bodies/0/group", "at least one character"});
  check_refused(with(R"("dust")", R"([{ "group": "dusk" }, "a"])"),
                {"/no_collide/0/0/group", "no body is of a group \"dusk\"", "did you mean \"dust\""});
  check_refused(with(R"("dust")", R"([{ "body": "a" }, "a"])"), {"/no_collide/0/0/body", "unknown key"});
  check_refused(with(R"("dust")", R"([{ "group": "dust" }])"), {"/no_collide/0"});
  std::string many;
  for (int k = 0; k < 65; ++k)
    many += (k == 0 ? "" : ", ") + box(fmt::format("b{}", k), fmt::format(R"("group": "g{}")", k));
  check_refused(scene_text("\"bodies\": [" + many + "]"), {"/bodies/64", "\"g64\"", "at most 64 groups"});
}

TEST_CASE("groups stay when a scene is saved", "[scene]") {
  const Scene s = parse(falling(R"(["dust", "heavy"])", "\"air\"",
                                R"(, "no_collide": [[{ "group": "air" }, { "group": "heavy" }],
                                                    [{ "group": "dust" }, { "group": "dust" }]])"));
  const Scene again = parse(written(s));
  CHECK(again.model.groups == s.model.groups);
  CHECK(same_bits(after(again, 1), after(s, 1)));
}

TEST_CASE("a builder says friction and groups as a file does", "[scene]") {
  const Scene read =
      parse(scene_text(R"("name": "it", "bodies": [)" +
                       box("a", R"("friction": { "static": 0.5, "dynamic": 0.4 }, "group": ["g"])") +
                       R"(], "generate": [{ "type": "stack", "count": 2, "position": [5, 0, 0],
                                         "friction": { "static": 0.1, "dynamic": 0.1 }, "group": ["g", "h"] }],
                                         "no_collide": [["a", { "group": "h" }], [{ "group": "g" }, { "group": "g" }]])"));
  SceneBuilder builder("it");
  builder.add(spec::Body{.name = "a", .friction = SurfaceFriction{0.5, 0.4}, .groups = {"g"}});
  builder.add(spec::Stack{
      {.position = Vec3(5, 0, 0), .friction = SurfaceFriction{0.1, 0.1}, .groups = {"g", "h"}}, 2});
  builder.add(spec::NoCollide{"a", spec::Group{"h"}});
  builder.add(spec::NoCollide{spec::Group{"g"}, spec::Group{"g"}});
  const Scene built = builder.build();
  CHECK(built.hash == read.hash);
  CHECK(built.model.friction == read.model.friction);
  CHECK(built.model.groups == read.model.groups);
  CHECK(built.model.no_collide == read.model.no_collide);
}

}  // namespace pabd::test_touch
