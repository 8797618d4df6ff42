// SPDX-License-Identifier: MIT
// d̂ of scenes that state none, what is said of it, and of one that is too large for a body.
#include "sim/scene/thickness.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/scene/tuning.h"
#include "sim/scene/write_scene.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/places.h"

namespace pabd::test_thickness {

using namespace test;

namespace {

std::string box(const std::string& name, double x, double y, double z, const std::string& more = "") {
  return fmt::format(R"({{ "name": "{}", "shape": {{ "type": "box", "size": [{}, {}, {}] }}{} }})", name, x,
                     y, z, more);
}

std::string bodies(const std::vector<std::string>& list, const std::string& members = "") {
  std::string out;
  for (const std::string& body : list) out += (out.empty() ? "" : ", ") + body;
  return scene_text("\"bodies\": [ " + out + " ]" + (members.empty() ? "" : ", " + members));
}

double d_hat_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse(text, overrides).params.contact.d_hat;
}

}  // namespace

TEST_CASE("a scene without d̂ has a tenth of the thickness of its thinnest movable body, and at most 0.01 m") {
  const auto one = [](const std::string& shape) {
    return d_hat_of(only_body(R"({ "shape": )" + shape + " }"));
  };
  for (const double edge : {1e-4, 1e-3, 0.01, 0.09})
    CHECK(d_hat_of(bodies({box("die", edge, 2 * edge, 3 * edge)})) == Approx(0.1 * edge).epsilon(1e-12));
  for (const double edge : {0.1, 0.2, 1.0, 50.0})
    CHECK(d_hat_of(bodies({box("crate", edge, edge, edge)})) == 0.01);
  CHECK(one(R"({ "type": "sphere", "radius": 0.005 })") == Approx(0.001));
  CHECK(one(R"({ "type": "capsule", "radius": 0.002, "length": 1 })") == Approx(0.0004));
  CHECK(one(R"({ "type": "cylinder", "radius": 0.5, "height": 0.02 })") == Approx(0.002));

  // Of several the thinnest; what is fixed does not count, and neither does what touches nothing.
  const std::string crate = box("crate", 1, 1, 1),
                    die = box("die", 0.01, 0.01, 0.01, R"(, "position": [3, 0, 0])");
  CHECK(d_hat_of(bodies({crate, die})) == Approx(0.001));
  CHECK(d_hat_of(bodies({crate, box("floor", 9, 0.001, 9, R"(, "fixed": true)")})) == 0.01);
  CHECK(d_hat_of(bodies({crate, die}, R"("no_collide": [["crate", "die"]])")) == 0.01);

  // Stated is stated.
  CHECK(d_hat_of(bodies({die}, R"("contact": { "d_hat": 0.01 })")) == 0.01);
  CHECK(d_hat_of(bodies({die}, R"("contact": { "N": 4 })")) == Approx(0.001));
  CHECK(d_hat_of(bodies({die}), {"contact.d_hat=0.002"}) == 0.002);
}

TEST_CASE("generators of small bodies leave gaps of the d̂ that follows from them") {
  const Scene stack = parse(generated(R"({ "type": "stack", "count": 3, "size": [0.001, 0.001, 0.001] })"));
  CHECK(stack.params.contact.d_hat == Approx(1e-4));
  CHECK(stack.initial.c[0].y() == Approx(0.5e-3 + 0.95e-4));
  REQUIRE(stack.d_hat_of);
  CHECK(stack.d_hat_of->body == 0);
  CHECK(stack.d_hat_of->thickness == Approx(1e-3));
  // Bricks for which gaps of 0.01 m have no room: half of one would have no width, a cell no room to jitter in.
  const Scene wall =
      parse(generated(R"({ "type": "wall", "columns": 3, "rows": 2, "size": [0.008, 0.004, 0.004] })"));
  CHECK(wall.params.contact.d_hat == Approx(4e-4));
  const Scene pile = parse(generated(
      R"({ "type": "pile", "count": 8, "shape": "sphere", "size": [0.005, 0.005, 0.005], "spacing": 0.006 })"));
  CHECK(pile.params.contact.d_hat == Approx(5e-4));
  // What is wrong with small bodies is told all the same.
  check_refused(generated(R"({ "type": "pile", "count": 8, "shape": "sphere", "size": [0.005, 0.005, 0.005],
                               "spacing": 0.004 })"),
                {"spacing", "0.005"});
  check_refused(bodies({box("die", 0.01, 0.01, -1)}), {"/bodies/0/shape/size"});
}

TEST_CASE("a default is as good as the same number written down: same hash, same places") {
  const std::string small = R"("generate": [ { "type": "stack", "count": 3, "size": [0.02, 0.02, 0.02] } ])",
                    large = R"("generate": [ { "type": "stack", "count": 3 } ])";
  for (const auto& [made, number] : {std::pair(small, "0.002"), std::pair(large, "0.01")}) {
    const Scene left = parse(scene_text(made)),
                stated = parse(scene_text(fmt::format(R"("contact": {{ "d_hat": {} }}, {})", number, made)));
    CHECK(left.hash == stated.hash);
    for (std::size_t k = 0; k < 3; ++k) CHECK(left.initial.c[k] == stated.initial.c[k]);
    CHECK_FALSE(stated.d_hat_of);
  }
}

TEST_CASE("what is saved has the d̂ of the run, whether it is the default or not") {
  const std::string text = bodies({box("die", 0.01, 0.01, 0.01)});
  const Scene scene = parse(text);
  const Scene again = parse(scene_to_json(scene.model, scene.initial, scene.params, scene.joint_law, "again",
                                          std::nullopt, std::nullopt));
  CHECK(again.params == scene.params);
  for (const double d_hat : {0.001, 0.01, 0.0005}) {
    Params wanted = scene.params;
    wanted.contact.d_hat = d_hat;
    Params defaults;
    defaults.contact.d_hat = scene.params.contact.d_hat;
    const std::string saved = tuned_scene_text(text, "die.json", {}, wanted, parameter_table(), defaults);
    CHECK(parse(saved).params == wanted);
    CHECK((saved.find("d_hat") == saved.npos) == (wanted == scene.params));
  }
}

TEST_CASE("a default that is not the usual one is told with its reason") {
  const auto note = thickness_note(parse(bodies({box("crate", 1, 1, 1), box("die", 0.01, 0.01, 0.01)})));
  REQUIRE(note);
  CHECK_FALSE(note->warning);
  CHECK(note->text ==
        "contact.d_hat is 0.001 m, a tenth of the thickness of \"die\" (0.01 m): the scene states none");
  CHECK_FALSE(thickness_note(parse(bodies({box("crate", 1, 1, 1)}))));
}

TEST_CASE("a d̂ of more than half of a body's thickness is warned of, once, with the body and both numbers") {
  const auto note = [](const std::string& d_hat) {
    return thickness_note(
        parse(bodies({box("crate", 1, 1, 1), box("die", 0.01, 0.02, 0.03), box("dice", 1, 2, 0.01)},
                     R"("contact": { "d_hat": )" + d_hat + " }")));
  };
  CHECK_FALSE(note("0.005"));
  const auto warned = note("0.0051");
  REQUIRE(warned);
  CHECK(warned->warning);
  CHECK(
      warned->text ==
      "contact.d_hat, 0.0051 m, is more than half of the thickness of \"die\" (0.01 m), and bodies rest that "
      "far "
      "apart; try contact.d_hat=0.001");
}

TEST_CASE("no shipped scene has anything to tell of its d̂") {
  for (const auto& entry : std::filesystem::directory_iterator(places::scenes())) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path().stem());
    const auto note = thickness_note(load_scene(entry.path()));
    INFO((note ? note->text : ""));
    CHECK_FALSE(note);
  }
}

}  // namespace pabd::test_thickness
