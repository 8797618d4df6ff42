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
std::array<double, 4> weights_at(double u) {
  const double v = 1 - u, u2 = u * u, v2 = v * v;
  return {v2 * v / 6, (4 - 6 * u2 + 3 * u2 * u) / 6, (4 - 6 * v2 + 3 * v2 * v) / 6, u2 * u / 6};
}

// At a time between two moments, or at the nearest one.
Vec3 middle_between(std::span<const TimedSpots> moments, double time) {
  const auto later = std::find_if(moments.begin(), moments.end(),
                                  [&](const TimedSpots& moment) { return moment.time >= time; });
  if (later == moments.begin()) return moments.front().middle;
  if (later == moments.end()) return moments.back().middle;
  const TimedSpots& before = *(later - 1);
  const double part = (time - before.time) / (later->time - before.time);
  return (1 - part) * before.middle + part * later->middle;
}

// Where `time` is among control points, and their weights there.
struct Place {
  std::size_t first;
  std::array<double, 4> weights;
};
Place place_of(double time, std::size_t points) {  // in Δ after the start
  const auto spans = static_cast<double>(points - 3);
  const double place = std::clamp(time, 0.0, spans), k = std::min(std::floor(place), spans - 1);
  return {static_cast<std::size_t>(k), weights_at(place - k)};
}

}  // namespace

EasedCamera::EasedCamera(std::span<const TimedSpots> moments, const Camera& like, double aspect,
                         const PicturePart& part, double closest)
    : start_(moments.front().time) {
  const double span = moments.back().time - start_;
  spacing_ = std::clamp(span / kSpans, kShortest, kLongest);
  const int last = std::max(1, static_cast<int>(std::ceil(span / spacing_))) + 1;
  const double between = span / static_cast<double>(moments.size());
  for (int k = -1; k <= last; ++k) middles_.push_back(middle_between(moments, start_ + k * spacing_));
  controls_.clear();
  std::vector<Spot> window;
  for (int k = -1; k <= last; ++k) {
    window.clear();
    for (const TimedSpots& moment : moments) {
      // What is between two moments is seen by those that see both.
      if (std::abs(moment.time - start_ - k * spacing_) > 2 * spacing_ + between) continue;
      const Vec3 middle = middle_at(moment.time);
      for (const Spot& spot : moment.spots) window.push_back({spot.centre - middle, spot.radius});
    }
    const Camera& nothing = controls_.empty() ? like : controls_.back();
    controls_.push_back(window.empty() ? nothing
                                       : drawn_back(fit_camera(window, like, aspect, part), closest));
  }
}

Vec3 EasedCamera::middle_at(double time) const {
  const Place place = place_of((time - start_) / spacing_, middles_.size());
  Vec3 out = Vec3::Zero();
  for (std::size_t i = 0; i < place.weights.size(); ++i) out += place.weights[i] * middles_[place.first + i];
  return out;
}

Camera EasedCamera::at(double time) const {
  if (is_still()) return controls_.front();
  const Place place = place_of((time - start_) / spacing_, controls_.size());
  Vec3 eye = middle_at(time), target = eye;
  for (std::size_t i = 0; i < place.weights.size(); ++i) {
    const Camera& control = controls_[place.first + i];
    eye += place.weights[i] * control.eye.cast<double>();
    target += place.weights[i] * control.target.cast<double>();
  }
  Camera camera = controls_.front();
  camera.eye = eye.cast<float>();
  camera.target = target.cast<float>();
  return camera;
}

}  // namespace pabd
