// SPDX-License-Identifier: MIT
// A scene file: what is taken fits together and is finite.
#include "sim/scene/scene.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

namespace {

constexpr const char* kFits = "a scene that is taken fits together and is finite";

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
  for (const Joint& joint : model.joints) {
    fuzz::require(joint.i >= kWorld && joint.i < model.size() && joint.j >= kWorld &&
                      joint.j < model.size() && joint.on_i.r.allFinite() && joint.on_j.r.allFinite() &&
                      joint.law.kappa > 0,
                  kFits);
  }
}

}  // namespace

void fuzz(std::string_view bytes) {
  fuzz::accepts([&] { check(parse_scene(std::string(bytes), "scene.json", "/nowhere")); });
}
