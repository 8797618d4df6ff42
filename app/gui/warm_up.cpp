// SPDX-License-Identifier: MIT
// See warm_up.h.
#include "app/gui/warm_up.h"

namespace pabd {
namespace {

constexpr int kView = 2;  // for pictures on the side
constexpr int kWidth = 64, kHeight = 36;
constexpr std::size_t kKinds = 5;

Instance small_one(float x, float opacity) {
  Instance out;
  out.transform = Mat4f::Identity();
  out.transform.block<3, 3>(0, 0) *= 0.5f;
  out.transform.block<3, 1>(0, 3) = Vec3f(x, 1, 0);
  out.color = {0.5f, 0.5f, 0.5f, opacity};
  return out;
}

VisualScene things(std::size_t kind) {
  VisualScene scene;
  scene.grounds.emplace_back();
  const auto add = [&](Primitive primitive, float x, float opacity = 1) -> Instance& {
    return scene.instances[static_cast<std::size_t>(primitive)].emplace_back(small_one(x, opacity));
  };
  switch (kind) {
    case 0:
      add(Primitive::cube, 0);
      break;
    case 1:
      add(Primitive::sphere, 0);
      add(Primitive::cylinder, 1);
      break;
    case 2:  // glyphs, before and behind a body
      add(Primitive::cube, 0);
      for (const Primitive primitive :
           {Primitive::disc, Primitive::cylinder, Primitive::cone, Primitive::sphere}) {
        for (const float x : {0.0f, 1.5f}) {
          Instance& glyph = add(primitive, x);
          glyph.shadow = glyph.shaded = false;
          glyph.xray = true;
        }
      }
      break;
    case 3:
      add(Primitive::cube, 0, 0.5f);
      add(Primitive::sphere, 1, 0.5f);
      add(Primitive::cube, -1, 0.5f).xray = true;
      break;
    default:
      scene.lines.push_back({{0, 0, 0}, {1, 1, 0}, {1, 1, 1, 1}, 2});
      scene.lines.push_back({{0, 0, 0}, {1, 1, 1}, {1, 1, 1, 1}, 2, true});
  }
  return scene;
}

}  // namespace

void WarmUp::draw(Renderer& renderer) {
  if (done()) return;
  static_assert(kPictures == 2 * kKinds);
  // What moves first: play is what comes next.
  renderer.draw_view(kView, things(next_ % kKinds), kWidth, kHeight,
                     next_ < kKinds ? RenderQuality::live() : RenderQuality{});
  ++next_;
}

}  // namespace pabd
