// SPDX-License-Identifier: MIT
// Damaged scenes: whatever is cut off or changed, the reader either accepts it or throws its own error.
#include <algorithm>
#include <cmath>

#include "sim/scene/random.h"
#include "tests/scene/scene_helpers.h"

namespace pabd::test_fuzz {

using namespace test;

namespace {

const std::string kScene = scene_text(R"("name": "fuzz", "gravity": [0, -9.81, 0], "time_step": 0.0166,
  "solver": { "method": "auto", "iterations": 20, "tolerance": 1e-6, "relaxation": 0.5, "projection": "polar" },
  "contact": { "barrier": "polynomial", "N": 3, "d_hat": 0.01, "kappa": "auto", "onset": 0.2,
               "friction": { "static": 0.5, "dynamic": 0.5 } },
  "bodies": [ { "name": "ground", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 }, "fixed": true },
    { "name": "crate \u00e9", "shape": { "type": "box", "size": [1, 1, 1] }, "density": 1000, "position": [0, 0.51, 0],
      "orientation": [1, 0, 0, 0], "velocity": [0, 0, 0], "angular_velocity": [0, 0, 0],
      "friction": { "static": 0.4, "dynamic": 0.3 }, "group": ["g", "h"] } ],
  "no_collide": [["ground", "pile 0"], [{ "group": "g" }, { "group": "h" }]],
  "generate": [ { "type": "pyramid", "base": 3, "size": [1, 1, 1], "position": [5, 0, 0] },
                { "type": "pile", "count": 9, "seed": 3, "position": [9, 0, 0] },
                { "type": "chain", "links": 3, "direction": [0, 1, 1], "end_mass": 5, "position": [0, 9, 0] },
                { "type": "net", "rows": 2, "columns": 3, "gap": 0.1, "position": [20, 5, 0] } ],
  "joints_default": { "potential": "hard", "kappa": 1e3, "N": 4, "d_hat": 0.1 },
  "joints": [ { "type": "hinge", "bodies": ["crate \u00e9", null], "anchor": [0, 1, 0], "axis": [0, 0, 1],
                "limits": [-10, 20.5], "arm": 0.2, "symmetric": true, "collide": false },
              { "type": "slider", "bodies": ["chain 2", "pile 0"], "anchor": [0, 1, 0], "axis": [0, 0, 1],
                "drive": { "keys": [[0, 0], [1, 0.5]] }, "twist": { "limits": [-5, 5] }, "kappa": "auto" },
              { "type": "spherical", "bodies": ["net 0.1", "pile 1"], "anchor": [0, 1, 0], "axes": "xy",
                "drive": { "value": [1, 2, 3] } },
              { "type": "distance", "bodies": ["pile 2", "ground"], "points": [[0, 1, 0], [1, 1, 1]], "length": 2 } ],
  "camera": { "eye": [6, 4, 8], "target": [0, 1, 0], "fov": 45 })");

// True when the text is refused. Anything but pabd::Error escapes and fails the test.
bool refused(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    const Scene s = parse(text, overrides);
    REQUIRE(s.model.size() >= 1);
    REQUIRE(s.initial.size() == s.model.size());
    for (const Vec3& c : s.initial.c) REQUIRE(c.allFinite());
    for (const Joint& joint : s.model.joints) {
      REQUIRE(joint.i >= kWorld);
      REQUIRE(joint.i < s.model.size());
      REQUIRE(joint.j >= kWorld);
      REQUIRE(joint.j < s.model.size());
      REQUIRE(joint.on_i.r.allFinite());
      REQUIRE(joint.on_j.r.allFinite());
      REQUIRE(joint.law.kappa > 0);
      REQUIRE(std::isfinite(joint.law.kappa));
    }
    return false;
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::bad_input);
    REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
    return true;
  }
}

}  // namespace

TEST_CASE("every truncation is refused", "[scene]") {
  REQUIRE_FALSE(refused(kScene));
  for (std::size_t n = 0; n < kScene.size(); ++n) REQUIRE(refused(kScene.substr(0, n)));
}

TEST_CASE("single changed, lost and doubled bytes never crash the reader", "[scene]") {
  Random random(2024);
  const std::string likely = "0123456789-+.eE\"{}[],: \\nu";
  int refusals = 0;
  constexpr int kRounds = 6000;
  for (int i = 0; i < kRounds; ++i) {
    std::string text = kScene;
    const std::size_t at = random.bits() % text.size();
    switch (i % 4) {
      case 0:
        text[at] = static_cast<char>(random.bits() & 0xff);
        break;
      case 1:
        text[at] = likely[random.bits() % likely.size()];
        break;
      case 2:
        text.erase(at, 1);
        break;
      default:
        text.insert(at, 1, text[at]);
        break;
    }
    refusals += refused(text) ? 1 : 0;
  }
  CHECK(refusals > kRounds / 2);
  CHECK(refusals < kRounds);
}

TEST_CASE("wrong values in every place never crash the reader", "[scene]") {
  const std::vector<std::string> places{"version",
                                        "name",
                                        "gravity",
                                        "gravity.0",
                                        "time_step",
                                        "solver",
                                        "solver.iterations",
                                        "contact",
                                        "contact.N",
                                        "contact.d_hat",
                                        "contact.kappa",
                                        "contact.friction",
                                        "contact.friction.static",
                                        "bodies",
                                        "bodies.0",
                                        "bodies.0.shape",
                                        "bodies.0.shape.normal",
                                        "bodies.1.shape",
                                        "bodies.1.shape.size",
                                        "bodies.1.shape.size.0",
                                        "bodies.1.name",
                                        "bodies.1.density",
                                        "bodies.1.position",
                                        "bodies.1.orientation.0",
                                        "bodies.1.orientation",
                                        "bodies.1.friction",
                                        "bodies.1.group",
                                        "no_collide.0",
                                        "no_collide.0.0",
                                        "includes",
                                        "generate",
                                        "generate.0",
                                        "generate.0.base",
                                        "generate.0.size",
                                        "generate.1.count",
                                        "generate.1.seed",
                                        "generate.1.columns",
                                        "camera",
                                        "camera.fov",
                                        "joints",
                                        "joints.0",
                                        "joints.0.type",
                                        "joints.0.bodies",
                                        "joints.0.bodies.0",
                                        "joints.0.anchor",
                                        "joints.0.axis",
                                        "joints.0.limits",
                                        "joints.0.limits.0",
                                        "joints.0.arm",
                                        "joints.1.drive",
                                        "joints.1.drive.keys",
                                        "joints.1.drive.keys.1",
                                        "joints.1.drive.keys.1.0",
                                        "joints.1.twist",
                                        "joints.1.kappa",
                                        "joints.2.drive.value",
                                        "joints.3.points",
                                        "joints.3.length",
                                        "joints_default.kappa",
                                        "joints_default.N",
                                        "generate.2.links",
                                        "generate.2.direction",
                                        "generate.2.fixed",
                                        "generate.3.rows",
                                        "generate.3.gap",
                                        "joints_default",
                                        "$schema",
                                        "description"};
  const std::vector<std::string> values{"null",
                                        "true",
                                        "-1",
                                        "0",
                                        "1e308",
                                        "-1e-320",
                                        "3000000000",
                                        "18446744073709551615",
                                        "\"\"",
                                        "\"x\"",
                                        "[]",
                                        "{}",
                                        "[[[]]]",
                                        "[1e308,1e308,1e308]",
                                        "{\"type\":\"box\"}"};
  int refusals = 0;
  for (const std::string& place : places) {
    for (const std::string& value : values) {
      INFO(place << "=" << value);
      refusals += refused(kScene, {place + "=" + value}) ? 1 : 0;
    }
  }
  CHECK(refusals > static_cast<int>(places.size() * values.size() * 2 / 3));
}

}  // namespace pabd::test_fuzz
