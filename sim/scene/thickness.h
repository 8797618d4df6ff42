// SPDX-License-Identifier: MIT
// How thick bodies are beside d̂, the thickness of their contacts.
//
// Bodies rest about d̂ apart. A scene that states no contact.d_hat has that of a fresh Params, 0.01 m, where its bodies
// are as usual, and a tenth of its thinnest movable body where that is thinner than 0.1 m: what a body of 0.1 m has. At
// h = 1/60, whatever the size, stacks of ten dice that lie askew stand with a tenth and lean by up to a quarter of an
// edge, with a twentieth by 7 %; with a fifth they fall.
#pragma once

#include <optional>
#include <string>

#include "sim/body/model.h"
#include "sim/scene/scene.h"

namespace pabd {

// The thinnest movable body that may touch anything, the first of equals; twice inner_radius (shape.h). Empty without
// one.
std::optional<ThinBody> thinnest_body(const Model& model);

// d̂ of a scene that states none; m.
double default_d_hat(const std::optional<ThinBody>& thinnest);

// "contact.d_hat is 0.0001 m, a tenth of …" where it is a default that is not the usual one, else empty.
std::string default_d_hat_words(const Scene& scene);

struct SceneNote {
  bool warning;
  std::string text;  // one line
};
// What to tell whoever loaded a scene: of such a default; as a warning, of a d̂ that is more than half as thick as a
// body: its surface is then farther from what it lies on than from its own middle.
std::optional<SceneNote> thickness_note(const Scene& scene);

}  // namespace pabd
