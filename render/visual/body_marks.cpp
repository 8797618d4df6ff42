// SPDX-License-Identifier: MIT
// See body_marks.h.
#include "render/visual/body_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/visual/bounds.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

constexpr std::uint32_t kVelocity = 0x1b4fd0, kBox = 0x2f3a4a;
constexpr double kLeastArrow = 4, kArrowHead = 9;  // pixels at 720 px frame height
constexpr double kHalfHead = 0.36;                 // half of its width, × its length

template <class F>
void for_each_movable(const Model& model, const State& state, const F& f) {
  for (Index i = 0; i < model.size(); ++i) {
    if (!model.fixed[i] && has_finite_pose(state, i)) f(static_cast<std::size_t>(i));
  }
}

}  // namespace

void add_velocity_arrows(const Model& model, const State& state, VisualScene& out) {
  const PixelMeter meter(out.camera);
  const Pen pen{srgb_color(kVelocity), 2.6};
  for_each_movable(model, state, [&](std::size_t i) {
    const Vec3 way = kVelocityTime * state.v[i];
    const double length = way.norm(), pixel = meter.at(state.c[i]);
    if (!std::isfinite(length) || length < kLeastArrow * pixel) return;
    const Vec3 tip = state.c[i] + way, along = way / length;
    const Vec3 side = along.cross(meter.to_eye(tip)).stableNormalized();
    const double head = std::min(kArrowHead * pixel, 0.6 * length);
    add_line(out, state.c[i], tip, pen);
    for (const double sign : {-1.0, 1.0})
      add_line(out, tip, tip - head * along + sign * kHalfHead * head * side, pen);
  });
}

void add_boxes(const Model& model, const State& state, VisualScene& out) {
  const Pen pen{srgb_color(kBox), 1.2, false};
  for_each_movable(model, state, [&](std::size_t i) {
    const Aabb box = bounds(model.shape[i], state.c[i], state.R[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const int j = (axis + 1) % 3, k = (axis + 2) % 3;
      for (const auto& [pj, pk] : {std::pair{box.lo[j], box.lo[k]},
                                   {box.hi[j], box.lo[k]},
                                   {box.lo[j], box.hi[k]},
                                   {box.hi[j], box.hi[k]}}) {
        Vec3 a = box.lo, b = box.hi;
        a[j] = b[j] = pj;
        a[k] = b[k] = pk;
        add_line(out, a, b, pen);
      }
    }
  });
}

void add_trail(std::span<const Vec3> path, const Vec4f& color, VisualScene& out) {
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (!path[k].allFinite() || !path[k + 1].allFinite()) continue;
    const double age = static_cast<double>(k + 1) / static_cast<double>(path.size() - 1);
    Vec4f ink = color;
    ink.w() *= static_cast<float>(age * age);
    add_line(out, path[k], path[k + 1], {ink, 1.2 + 2.0 * age});
  }
}

Vec4f trail_color(std::size_t number) {
  static constexpr std::array<std::uint32_t, kTrailInks> kInks = {0xd6336c, 0x1c7ed6, 0x2b8a3e, 0xe8590c,
                                                                  0x6741d9};
  return srgb_color(kInks[number % kInks.size()]);
}

}  // namespace pabd
