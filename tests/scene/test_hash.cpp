// SPDX-License-Identifier: MIT
// The hash of a scene: a fingerprint of what it says, not of how it is written.
#include <set>

#include "tests/scene/scene_helpers.h"

namespace pabd::test_hash {

using namespace test;

TEST_CASE("the hash does not depend on formatting, key order or written-out defaults", "[scene]") {
  const std::string a = R"({"format":"pabd-scene","version":1,"contact":{"N":3,"d_hat":0.02},
    "bodies":[{"name":"b","shape":{"type":"box","size":[1,1,1]},"position":[0,1,0]}]})";
  const std::string b = R"({ "bodies": [ { "position": [0.0, 1e0, 0], "density": 1000, "fixed": false,
      "shape": { "size": [1.0, 1, 1], "type": "box" }, "name": "b" } ],
    "contact": { "d_hat": 2e-2, "N": 3.0, "kappa": "auto" }, "time_step": 0.016666666666666666,
    "version": 1, "format": "pabd-scene", "joints": [], "generate": [] })";
  CHECK(parse(a).hash.size() == 16);
  // "density" was left out in a, and its default written out in b.
  CHECK(parse(a).hash == parse(b).hash);
  CHECK(parse(a, {"contact.N=4"}).hash != parse(a).hash);
  CHECK(parse(a, {"contact.N=3"}).hash == parse(a).hash);
}

TEST_CASE("who computes a scene is none of its fingerprint", "[scene]") {
  const std::string plain = scene_text(R"("bodies": [{ "shape": { "type": "sphere", "radius": 1 } }])");
  const std::string iterations = scene_text(
      R"("solver": { "iterations": 7 }, "bodies": [{ "shape": { "type": "sphere", "radius": 1 } }])");
  CHECK(parse(plain).params.solver.device == SolverDevice::cpu);
  for (const char* device : {"cpu", "gpu", "auto"}) {
    const std::vector<std::string> set = {std::string("solver.device=") + device};
    CHECK(to_string(parse(plain, set).params.solver.device) == std::string(device));
    CHECK(parse(plain, set).hash == parse(plain).hash);
    CHECK(parse(iterations, set).hash == parse(iterations).hash);
  }
  // As of before there was the key.
  CHECK(parse(plain).hash == "d69d442848ea6571");
  CHECK(parse(iterations).hash != parse(plain).hash);
}

TEST_CASE("every value changes the hash", "[scene]") {
  const std::string base =
      scene_text(R"("name": "n", "description": "d", "gravity": [0, -9.81, 0], "bodies": [
    { "name": "a", "shape": { "type": "capsule", "radius": 0.5, "length": 1 }, "density": 5, "orientation": [1, 0, 0, 0],
      "position": [0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0] },
    { "name": "g", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 } } ],
    "generate": [ { "type": "stack", "count": 2, "size": [1, 1, 1], "position": [5, 0, 0] },
                  { "type": "wall", "columns": 2, "rows": 2, "position": [15, 0, 0] },
                  { "type": "pyramid", "base": 2, "position": [25, 0, 0] },
                  { "type": "pile", "count": 2, "position": [35, 0, 0] },
                  { "type": "chain", "links": 2, "joint": "hinge", "size": [1, 0.1, 0.1], "position": [45, 0, 0] },
                  { "type": "net", "rows": 2, "columns": 3, "size": [1, 1, 1], "position": [55, 0, 0] } ],
    "camera": { "eye": [1, 2, 3], "target": [0, 0, 0], "fov": 45 }, "duration": 5)");
  const std::vector<std::string> changes{"name=m",
                                         "description=e",
                                         "gravity.1=-9.8100000000000005",
                                         "time_step=0.01",
                                         "solver.method=sissm",
                                         "solver.iterations=21",
                                         "solver.tolerance=0",
                                         "solver.relaxation=0.6",
                                         "solver.projection=polar",
                                         "contact.barrier=even",
                                         "contact.N=4",
                                         "contact.d_hat=0.011",
                                         "contact.kappa=5",
                                         "contact.onset=0.1",
                                         "contact.friction.static=0.6",
                                         "contact.friction.dynamic=0.4",
                                         "joints_default.potential=hard",
                                         "joints_default.kappa=3",
                                         "joints_default.N=3",
                                         "joints_default.d_hat=1",
                                         "bodies.0.name=b",
                                         "bodies.0.shape.radius=0.51",
                                         "bodies.0.shape.length=1.1",
                                         "bodies.0.density=6",
                                         "bodies.0.fixed=true",
                                         "bodies.0.position.2=1e-12",
                                         "bodies.0.orientation=[0.9999, 0.001, 0, 0]",
                                         "bodies.0.velocity.0=1",
                                         "bodies.0.angular_velocity.0=1",
                                         R"(bodies.0.shape={"type":"sphere","radius":0.5})",
                                         "bodies.1.shape.offset=1",
                                         "bodies.1.shape.normal=[0,1,0.1]",
                                         "generate.0.count=3",
                                         "generate.0.size.0=2",
                                         "generate.0.position.0=6",
                                         "generate.0.mass=4",
                                         "generate.0.density=4",
                                         "generate.0.masses=[4]",
                                         "generate.0.gap=0.1",
                                         "generate.0.rotate=5",
                                         "generate.0.name=s",
                                         "generate.1.columns=3",
                                         "generate.1.rows=3",
                                         "generate.1.spacing=0.2",
                                         "generate.1.gap=0.2",
                                         "generate.1.half_blocks=false",
                                         "generate.2.base=3",
                                         "generate.2.spacing=0.3",
                                         "generate.3.count=3",
                                         "generate.3.shape=sphere",
                                         "generate.3.vary=0.1",
                                         "generate.3.columns=3",
                                         "generate.3.spacing=9",
                                         "generate.3.seed=4",
                                         "generate.4.links=3",
                                         "generate.4.shape=capsule",
                                         "generate.4.size.0=2",
                                         "generate.4.gap=0.1",
                                         "generate.4.direction=[0,1,0]",
                                         "generate.4.joint=fixed",
                                         "generate.4.axis=[0,1,0]",
                                         "generate.4.fixed=both",
                                         "generate.4.end_mass=9",
                                         "generate.4.collide=true",
                                         "generate.5.rows=3",
                                         "generate.5.columns=2",
                                         "generate.5.shape=sphere",
                                         "generate.5.size.2=2",
                                         "generate.5.gap=0.1",
                                         "generate.5.upright=true",
                                         "generate.5.joint=distance",
                                         "generate.5.fixed=top",
                                         "generate.5.density=7",
                                         "generate.5.collide=true",
                                         "camera.eye.0=2",
                                         "camera.target.0=1",
                                         "camera.fov=46",
                                         "duration=6"};
  std::set<std::string> seen{parse(base).hash};
  for (const std::string& change : changes) {
    INFO(change);
    if (change == "gravity.1=-9.8100000000000005") {  // the same double: -9.81
      CHECK(parse(base, {change}).hash == parse(base).hash);
    } else {
      CHECK(seen.insert(parse(base, {change}).hash).second);
    }
  }
  const Scene swapped =
      parse(scene_text(R"("bodies": [ { "name": "a", "shape": { "type": "sphere", "radius": 1 } },
    { "name": "b", "shape": { "type": "sphere", "radius": 2 } } ])"));
  const Scene original =
      parse(scene_text(R"("bodies": [ { "name": "b", "shape": { "type": "sphere", "radius": 2 } },
    { "name": "a", "shape": { "type": "sphere", "radius": 1 } } ])"));
  CHECK(swapped.hash != original.hash);  // the order of bodies is part of a scene
}

}  // namespace pabd::test_hash
