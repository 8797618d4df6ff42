// SPDX-License-Identifier: MIT
// See thickness.h.
#include "sim/scene/thickness.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "sim/scene/text.h"

namespace pabd {
namespace {

constexpr double kShare = 0.1;    // of the thickness of a body
constexpr double kTooMuch = 0.5;  // the same

// Of a body, how many others it never touches.
std::vector<Index> kept_apart(const Model& model) {
  std::vector<Index> out(model.shape.size(), 0);
  for (const auto& [a, b] : model.no_collide) {
    ++out[static_cast<std::size_t>(a)];
    ++out[static_cast<std::size_t>(b)];
  }
  return out;
}

std::string words_of(const Scene& scene, const ThinBody& body) {
  return fmt::format("{} ({:.4g} m)", in_quotes(scene.model.name[static_cast<std::size_t>(body.body)]),
                     body.thickness);
}

}  // namespace

std::optional<ThinBody> thinnest_body(const Model& model) {
  const std::vector<Index> apart = kept_apart(model);
  std::optional<ThinBody> out;
  for (Index i = 0; i < model.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (model.fixed[k] || (apart[k] > 0 && apart[k] == model.size() - 1)) continue;
    const double thickness = 2 * inner_radius(model.shape[k]);
    if (!out || thickness < out->thickness) out = {i, thickness};
  }
  return out;
}

double default_d_hat(const std::optional<ThinBody>& thinnest) {
  const double usual = ContactParams{}.d_hat;
  return thinnest ? allowed(&ContactParams::d_hat, std::min(usual, kShare * thinnest->thickness)) : usual;
}

std::string default_d_hat_words(const Scene& scene) {
  if (!scene.d_hat_of) return "";
  return fmt::format("contact.d_hat is {:.4g} m, a tenth of the thickness of {}: the scene states none",
                     scene.params.contact.d_hat, words_of(scene, *scene.d_hat_of));
}

std::optional<SceneNote> thickness_note(const Scene& scene) {
  if (scene.d_hat_of) return SceneNote{false, default_d_hat_words(scene)};
  const double d_hat = scene.params.contact.d_hat;
  const std::optional<ThinBody> thinnest = thinnest_body(scene.model);
  if (!thinnest || !(d_hat > kTooMuch * thinnest->thickness)) return std::nullopt;
  return SceneNote{
      true,
      fmt::format("contact.d_hat, {:.4g} m, is more than half of the thickness of {}, and bodies rest that "
                  "far apart; try contact.d_hat={:.2g}",
                  d_hat, words_of(scene, *thinnest), default_d_hat(thinnest))};
}

}  // namespace pabd
