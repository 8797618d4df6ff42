// SPDX-License-Identifier: MIT
// See eased_camera.h.
//
//   Δ      time between control points                        s
//   C_k    control camera at time kΔ after the start; it counts from (k − 2)Δ to (k + 2)Δ
//   u      place between two of them                          0 … 1
#include "render/visual/eased_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pabd {
namespace {

constexpr double kShortest = 0.05, kLongest = 1;  // s: Δ is a sixtieth of the time, but from here to here
constexpr double kSpans = 60;

// From so far, along the same line of sight.
Camera drawn_back(Camera camera, double closest) {
  const Vec3f offset = camera.eye - camera.target;
  const float distance = offset.norm(), least = static_cast<float>(closest);
  if (distance < least) camera.eye = camera.target + least / distance * offset;
  return camera;
}

// Weights of C_{k−1} … C_{k+2} between C_k and C_{k+1}.
std::array<float, 4> weights_at(double u) {
  const double v = 1 - u, u2 = u * u, v2 = v * v;
  return {static_cast<float>(v2 * v / 6), static_cast<float>((4 - 6 * u2 + 3 * u2 * u) / 6),
          static_cast<float>((4 - 6 * v2 + 3 * v2 * v) / 6), static_cast<float>(u2 * u / 6)};
}

}  // namespace

EasedCamera::EasedCamera(std::span<const TimedSpots> moments, const Camera& like, double aspect,
                         const PicturePart& part, double closest)
    : start_(moments.front().time) {
  const double span = moments.back().time - start_;
  spacing_ = std::clamp(span / kSpans, kShortest, kLongest);
  const int last = std::max(1, static_cast<int>(std::ceil(span / spacing_))) + 1;
  const double between = span / static_cast<double>(moments.size());
  controls_.clear();
  std::vector<Spot> window;
  for (int k = -1; k <= last; ++k) {
    window.clear();
    for (const TimedSpots& moment : moments) {
      // What is between two moments is seen by those that see both.
      if (std::abs(moment.time - start_ - k * spacing_) <= 2 * spacing_ + between)
        window.insert(window.end(), moment.spots.begin(), moment.spots.end());
    }
    const Camera& nothing = controls_.empty() ? like : controls_.back();
    controls_.push_back(window.empty() ? nothing
                                       : drawn_back(fit_camera(window, like, aspect, part), closest));
  }
}

Camera EasedCamera::at(double time) const {
  if (is_still()) return controls_.front();
  const auto spans = static_cast<double>(controls_.size() - 3);
  const double place = std::clamp((time - start_) / spacing_, 0.0, spans);
  const double k = std::min(std::floor(place), spans - 1);
  const std::array<float, 4> weights = weights_at(place - k);
  Camera camera = controls_.front();
  camera.eye = camera.target = Vec3f::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const Camera& control = controls_[static_cast<std::size_t>(k) + i];
    camera.eye += weights[i] * control.eye;
    camera.target += weights[i] * control.target;
  }
  return camera;
}

}  // namespace pabd
