// SPDX-License-Identifier: MIT
// "force" and "torque" of bodies: read, written, included, refused.
#include <catch2/catch.hpp>

#include "sim/scene/write_scene.h"
#include "tests/scene/scene_helpers.h"
#include "tests/support/errors.h"

namespace pabd::test_external_force {

using namespace test;

namespace {

std::string with(const std::string& keys) {
  return scene_text(R"("bodies": [{ "name": "a", "shape": { "type": "box", "size": [1, 1, 1] }, )" + keys +
                    " }]");
}

}  // namespace

TEST_CASE("a force and a torque are read as a vector, a value or keys, and are part of the hash", "[scene]") {
  const Scene plain = parse(with(R"("mass": 2)")), one = parse(with(R"("mass": 2, "force": [1, 2, 3])"));
  REQUIRE(one.model.external.size() == 1);
  CHECK(one.model.external[0]->force_at(5) == Vec3(1, 2, 3));
  CHECK(one.model.external[0]->torque_at(5) == Vec3::Zero());
  CHECK(plain.model.external.empty());
  CHECK(plain.hash != one.hash);
  const Scene keys = parse(with(
      R"("mass": 2, "torque": { "keys": [[0, [0, 0, 0]], [2, [0, 4, 0]]] }, "force": { "value": [1, 0, 0] })"));
  CHECK(keys.model.external[0]->torque_at(1) == Vec3(0, 2, 0));
  CHECK(keys.model.external[0]->force_at(9) == Vec3(1, 0, 0));
}

TEST_CASE("a scene that is written has its forces, with their keys from its time on", "[scene]") {
  const Scene scene = parse(with(R"("mass": 2, "force": { "keys": [[0, [0, 0, 0]], [2, [0, 4, 0]]] })"));
  State later = scene.initial;
  later.time = 1;
  const Scene again =
      parse(scene_to_json(scene.model, later, scene.params, scene.joint_law, "later", {}, {}));
  REQUIRE(again.model.external.size() == 1);
  for (const double time : {0.0, 0.5, 1.0, 3.0})
    CHECK((again.model.external[0]->force_at(time) - scene.model.external[0]->force_at(time + 1)).norm() <
          1e-15);
}

TEST_CASE("the velocity of a surface is read, also of a plane, and written", "[scene]") {
  const Scene scene =
      parse(scene_text(R"("bodies": [{ "shape": { "type": "plane" }, "surface_velocity": [1, 0, 0] },
    { "shape": { "type": "sphere", "radius": 1 } }])"));
  REQUIRE(scene.model.surface_velocity.size() == 2);
  CHECK(scene.model.surface_velocity[0] == Vec3::UnitX());
  CHECK_FALSE(scene.model.surface_velocity[1]);
  const Scene again =
      parse(scene_to_json(scene.model, scene.initial, scene.params, scene.joint_law, "again", {}, {}));
  CHECK(again.model.surface_velocity == scene.model.surface_velocity);
}

TEST_CASE("forces on what does not move and values that are none are refused, with the place", "[scene]") {
  const auto refusal = [](const std::string& keys) { return caught([&] { parse(with(keys)); }); };
  CHECK(refusal(R"("fixed": true, "force": [1, 0, 0])").says("/bodies/0/force: a fixed body does not move"));
  CHECK(refusal(R"("force": 3)").says("/bodies/0/force: expected three numbers"));
  CHECK(refusal(R"("torque": [1, 2])").says("/bodies/0/torque"));
  CHECK(refusal(R"("torque": { "keys": [[1, [0, 0, 0]], [0, [0, 0, 0]]] })").says("rising times"));
  CHECK(caught([] {
          parse(scene_text(R"("bodies": [{ "shape": { "type": "plane" }, "force": [1, 0, 0] },
                                         { "shape": { "type": "sphere", "radius": 1 } }])"));
        }).says("/bodies/0/force"));
}

}  // namespace pabd::test_external_force
