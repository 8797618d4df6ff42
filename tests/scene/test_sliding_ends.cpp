// SPDX-License-Identifier: MIT
// Where the points of sliders lie, and what that is worth: a load across the axis against beam-like theory.
#include <catch2/catch.hpp>
#include <string>

#include "sim/joint/joint_traits.h"
#include "sim/scene/scene.h"
#include "sim/solver/time_step.h"

namespace pabd::test_sliding_ends {

namespace {

constexpr double kWeight = 2 * 9.81;  // of the cart; N

std::string number(double x) { return std::to_string(x); }

// A cart of 2 kg whose centre of mass starts `lever` along the axis from the anchor and runs at `speed`; on the world, on
// a fixed rail, or on one of 4 kg that the world holds.
Scene cart_scene(const std::string& rail, double speed, double lever, bool swapped,
                 const std::string& more = "") {
  const bool world = rail == "world";
  std::string text = R"({ "format": "pabd-scene", "version": 1, "time_step": 0.01, "bodies": [
    { "name": "cart", "shape": { "type": "box", "size": [0.2, 0.2, 0.2] }, "mass": 2, "position": [)" +
                     number(lever) + R"(, 0, 0], "velocity": [)" + number(speed) + ", 0, 0] }";
  if (!world)
    text += R"(, { "name": "rail", "shape": { "type": "box", "size": [)" + number(2 * speed + 0.5) +
            R"(, 0.1, 0.1] }, "mass": 4, "position": [0, 0, 0], "fixed": )" +
            (rail == "fixed" ? "true" : "false") + " }";
  const std::string other = world ? "null" : "\"rail\"";
  text += R"(], "joints": [ { "type": "slider", "anchor": [0, 0, 0], "axis": [1, 0, 0], "bodies": [)" +
          (swapped ? "\"cart\", " + other : other + ", \"cart\"") + "]" + more + " }";
  if (rail == "held")
    text += R"(, { "type": "fixed", "bodies": [null, "rail"], "anchor": [0, 0, 0], "arm": )" +
            number(speed + lever) + " }";
  return parse_scene(text + "] }", "test.json", {});
}

// How far the cart is from where the axis has its centre of mass after 1 s; m.
double sag(const Scene& scene) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 100; ++k) {
    step(scene.model, scene.params, {}, state, workspace, report);
    REQUIRE(report.status == StepStatus::converged);
  }
  Vec3 c = state.c[0];
  if (state.c.size() > 1) c = state.R[1].transpose() * (c - state.c[1]);
  c.x() = 0;
  return c.norm();
}

// The four bonds share the load.
double least_sag(const Scene& scene) { return kWeight / (4 * scene.model.joints[0].law.kappa); }

}  // namespace

TEST_CASE("a slider gives way to a load by F/4k however far it has gone, whichever body comes first") {
  for (const char* rail : {"world", "fixed", "held"}) {
    for (const double way : {0.1, 1.0, 10.0}) {
      for (const bool swapped : {false, true}) {
        CAPTURE(rail, way, swapped);
        const Scene scene = cart_scene(rail, way, 0, swapped);
        CHECK(scene.model.joints[0].on_second == !swapped);
        CHECK(sag(scene) == Approx(least_sag(scene)).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("a centre of mass beside the anchor is a lever, and the arms are as long: thrice F/4k") {
  for (const char* rail : {"world", "fixed", "held"}) {
    for (const double lever : {0.5, 2.0}) {
      for (const bool swapped : {false, true}) {
        CAPTURE(rail, lever, swapped);
        const Scene scene = cart_scene(rail, 1, lever, swapped);
        CHECK(scene.model.joints[0].arm == Approx(lever).epsilon(1e-12));
        CHECK(sag(scene) == Approx(3 * least_sag(scene)).epsilon(0.01));
      }
    }
  }
  // What a scene says stays.
  CHECK(cart_scene("world", 1, 2, false, R"(, "arm": 0.3)").model.joints[0].arm == 0.3);
}

TEST_CASE("the points of a slider lie on the body that hangs on the other one") {
  const auto second = [](const std::string& held, const std::string& bodies) {
    const auto box = [](const char* name, const char* size) {
      return std::string(R"({ "name": ")") + name + R"(", "shape": { "type": "box", "size": )" + size +
             " } }";
    };
    const std::string text =
        R"({ "format": "pabd-scene", "version": 1, "bodies": [ )" + box("small", "[0.1, 0.1, 0.1]") + "," +
        box("long", "[4, 0.1, 0.1]") + "," + box("twin", "[0.1, 0.1, 0.1]") +
        R"( ], "joints": [ { "type": "cylindrical", "anchor": [0, 0, 0], "axis": [1, 0, 0],
      "bodies": )" +
        bodies + " }" + (held.empty() ? "" : R"(, { "type": "hinge", "anchor": [0, 0, 0], "axis": [0, 0, 1],
      "bodies": [null, ")" + held + "\"] }") +
        "] }";
    return static_cast<bool>(parse_scene(text, "test.json", {}).model.joints[0].on_second);
  };
  // A cart on a beam, and a rod in a bearing that the world holds.
  CHECK(second("long", R"(["long", "small"])"));
  CHECK_FALSE(second("long", R"(["small", "long"])"));
  CHECK(second("small", R"(["small", "long"])"));
  CHECK_FALSE(second("small", R"(["long", "small"])"));
  // Two that float: the smaller one; of equal ones always the same.
  CHECK(second("", R"(["long", "small"])"));
  CHECK_FALSE(second("", R"(["small", "long"])"));
  CHECK(second("", R"(["small", "twin"])"));
  CHECK_FALSE(second("", R"(["twin", "small"])"));
}

}  // namespace pabd::test_sliding_ends
