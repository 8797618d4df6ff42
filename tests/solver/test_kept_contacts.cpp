// SPDX-License-Identifier: MIT
// Contacts of bodies that rest are kept from step to step: with the bits of steps that find all of them anew.
#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

#include "sim/scene/scene.h"
#include "sim/solver/step_memory.h"
#include "sim/solver/time_step.h"
#include "tests/solver/same_report.h"
#include "tests/support/places.h"

namespace pabd::test_kept_contacts {

using test::require_same;

namespace {

// A row of things that stand, and a ball that comes rolling after they have come to rest.
Scene yard() {
  return parse_scene(R"({
    "format": "pabd-scene", "version": 1,
    "contact": { "d_hat": 0.001 },
    "bodies": [
      { "name": "ground", "shape": { "type": "plane" } },
      { "name": "plate", "shape": { "type": "box", "size": [4, 0.2, 1] }, "fixed": true, "position": [0, 0.1, 0] },
      { "name": "low", "shape": { "type": "box", "size": [0.4, 0.4, 0.4] }, "mass": 5, "position": [-1, 0.4011, 0] },
      { "name": "top", "shape": { "type": "box", "size": [0.3, 0.3, 0.3] }, "mass": 3, "position": [-1, 0.7522, 0] },
      { "name": "can", "shape": { "type": "cylinder", "radius": 0.15, "height": 0.4 }, "mass": 3,
        "position": [0, 0.4011, 0] },
      { "name": "cone", "shape": { "type": "cone", "radius": 0.15, "height": 0.4 }, "mass": 2,
        "position": [0.6, 0.3011, 0] },
      { "name": "log", "shape": { "type": "capsule", "radius": 0.15, "length": 0.3 }, "mass": 2,
        "position": [1.2, 0.3511, 0], "orientation": [0.7071067811865476, 0, 0, 0.7071067811865476] },
      { "name": "ball", "shape": { "type": "sphere", "radius": 0.2 }, "mass": 20, "position": [-1.8, 0.4011, 0] }
    ]
  })",
                     "yard", {});
}

using Edit = std::function<void(Model&, Params&, State&)>;

struct Kept {
  int steps = 0;          // with bodies that are still
  std::size_t pairs = 0;  // most manifolds that may be those of the step before
};

// Steps with one workspace, and with a fresh one each; `edit` comes before step `at`.
Kept require_same_steps(const Scene& scene, int steps, int at, const Edit& edit, int threads = 1) {
  Model model = scene.model;
  Params params = scene.params;
  State state = scene.initial;
  StepWorkspace workspace;
  StepOptions options;
  options.report_contacts = options.report_bodies = options.report_joints = true;
  options.threads = threads;
  Kept kept;
  for (int k = 0; k < steps; ++k) {
    if (k == at) edit(model, params, state);
    State other = state;
    StepWorkspace fresh;
    StepReport report, anew;
    step(model, params, options, other, fresh, anew);
    step(model, params, options, state, workspace, report);
    INFO("step " << k);
    REQUIRE(same_bits(state, other));
    require_same(report, anew);
    const Detection& found = workspace.memory().detection;
    if (!found.collision.kept.any_still()) continue;
    ++kept.steps;
    const auto pairs = std::count_if(found.made_at.begin(), found.made_at.end(),
                                     [](std::size_t place) { return place != SIZE_MAX; });
    kept.pairs = std::max(kept.pairs, static_cast<std::size_t>(pairs));
  }
  return kept;
}

constexpr int kRest = 150;

}  // namespace

TEST_CASE("contacts at rest are kept, and steps have the bits of steps that find them anew") {
  const Scene scene = yard();
  const Index ball = 7, top = 3, low = 2;
  SECTION("a ball hits what rests") {
    const Kept kept = require_same_steps(scene, kRest + 60, kRest, [&](Model&, Params&, State& state) {
      state.v[ball] = {2, 0, 0};
    });
    CHECK(kept.steps > 60);
    CHECK(kept.pairs > 5);
  }
  SECTION("another body in its place") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [&](Model& model, Params&, State&) {
      std::get<Box>(model.shape[top]).half = {0.15, 0.15, 0.1};
      std::get<Sphere>(model.shape[ball]).radius = 0.2001;
    });
    CHECK(kept.steps > 60);
  }
  SECTION("moved by hand") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest,
                                         [&](Model&, Params&, State& state) { state.c[top].x() += 0.01; });
    CHECK(kept.steps > 60);
  }
  SECTION("a pair that no longer meets") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [&](Model& model, Params&, State&) {
      model.no_collide.emplace_back(low, top);
    });
    CHECK(kept.steps > 60);
  }
  SECTION("another contact law") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [](Model&, Params& params, State&) {
      params.contact.d_hat = 0.0011;
      params.contact.mu_static = params.contact.mu_dynamic = 0.1;
    });
    CHECK(kept.steps > 60);
  }
  SECTION("another barrier, whose contacts are looked for where the step starts") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [](Model&, Params& params, State&) {
      params.contact.barrier = BarrierKind::log;
    });
    CHECK(kept.steps > 60);
  }
  SECTION("gravity turns") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [](Model&, Params& params, State&) {
      params.gravity = {3, -9.81, 0};
    });
    CHECK(kept.steps > 60);
  }
  SECTION("what was fixed falls") {
    const Kept kept = require_same_steps(scene, kRest + 20, kRest, [](Model& model, Params&, State&) {
      model.fixed[1] = 0;
      model.mass[1] = 10;
      model.J[1] = Mat3::Identity();
    });
    CHECK(kept.steps > 60);
  }
}

TEST_CASE("shipped stacks keep their contacts on any number of threads") {
  for (const char* name : {"pyramid", "chairs"}) {
    const Scene scene = load_scene(std::string(places::scenes() + "/") + name + ".json");
    INFO(name);
    const Kept kept = require_same_steps(scene, 120, -1, {}, 3);
    CHECK(kept.steps > 0);
  }
}

}  // namespace pabd::test_kept_contacts
