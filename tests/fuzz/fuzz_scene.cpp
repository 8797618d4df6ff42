// SPDX-License-Identifier: MIT
// A scene file: what is taken fits together and is finite.
#include "sim/scene/guarded_scene.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

namespace {

constexpr const char* kFits = "a scene that is taken fits together and is finite";

// What every included scene is.
constexpr const char* kPart = R"({ "format": "pabd-scene", "version": 1, "bodies": [
  { "name": "ground", "shape": { "type": "plane" } },
  { "name": "rod", "shape": { "type": "box", "size": [1, 1, 1] }, "group": "g", "friction": 0.2, "color": "#112233" },
  { "name": "bob", "shape": { "type": "sphere", "radius": 0.5 }, "position": [2, 0, 0], "velocity": [1, 2, 3] } ],
  "joints": [ { "name": "pin", "type": "hinge", "bodies": ["ground", "rod"], "anchor": [0, 0, 0], "axis": [0, 0, 1] },
              { "type": "distance", "bodies": ["rod", "bob"], "points": [[0, 0, 0], [2, 0, 0]] } ],
  "no_collide": [[{ "group": "g" }, "bob"], [{ "group": "g" }, { "group": "g" }]] })";

void check(const Scene& scene) {
  const Model& model = scene.model;
  const auto count = static_cast<std::size_t>(model.size());
  fuzz::require(count > 0 && scene.initial.c.size() == count && scene.initial.R.size() == count &&
                    scene.initial.v.size() == count && scene.initial.omega.size() == count,
                kFits);
  for (std::size_t i = 0; i < count; ++i) {
    fuzz::require(scene.initial.c[i].allFinite() && scene.initial.R[i].allFinite() &&
                      scene.initial.v[i].allFinite() && scene.initial.omega[i].allFinite(),
                  kFits);
    fuzz::require(model.fixed[i] || (model.mass[i] > 0 && model.J[i].allFinite()), kFits);
  }
  fuzz::require(model.friction.empty() || model.friction.size() == count, kFits);
  fuzz::require(model.groups.of_body.empty() || model.groups.of_body.size() == count, kFits);
  fuzz::require(model.groups.avoids.empty() || model.groups.avoids.size() == count, kFits);
  for (const Joint& joint : model.joints) {
    fuzz::require(joint.i >= kWorld && joint.i < model.size() && joint.j >= kWorld &&
                      joint.j < model.size() && joint.on_i.r.allFinite() && joint.on_j.r.allFinite() &&
                      joint.law.kappa > 0,
                  kFits);
  }
}

}  // namespace

PABD_FUZZ_TARGET(scene, bytes) {
  const ReadSceneText part = [](const auto&, const MayRead&) -> SceneText { return {kPart, {}}; };
  fuzz::accepts(
      [&] { check(parse_guarded_scene(std::string(bytes), "scene.json", "/nowhere", {}, {}, part)); });
}
