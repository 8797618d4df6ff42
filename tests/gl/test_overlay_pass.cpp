// SPDX-License-Identifier: MIT
// The overlay lands on exact pixels, is clipped, and is blended as sRGB.
#include <imgui.h>

#include <catch2/catch.hpp>

#include "tests/gl/imgui_frame.h"
#include "tests/gl/render_fixture.h"

namespace pabd::test_overlay_pass {

namespace {

constexpr int kWidth = 80;
constexpr int kHeight = 60;

Image draw_plain(Renderer& renderer, const ImDrawData* data, const Vec3f& background) {
  Image image;
  renderer.compose(kWidth, kHeight, {}, background, data);
  renderer.queue_read();
  renderer.fetch(image);
  return image;
}

}  // namespace

TEST_CASE("a rectangle covers exactly its pixels") {
  RenderFixture f(kWidth, kHeight);
  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().AddRectFilled({10, 20}, {30, 50}, IM_COL32(255, 0, 0, 255));
  const Image image = draw_plain(f.renderer, imgui.finish(), {0, 0, 0});
  keep_image("overlay", image);
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 10 && x < 30 && y >= 20 && y < 50;
      const Rgb p = pixel(image, x, y);
      if (p.r != (inside ? 255 : 0) || p.g != 0 || p.b != 0) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("clip rectangles cut at exact pixels") {
  RenderFixture f(kWidth, kHeight);
  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().PushClipRect({15, 5}, {40, 25});
  imgui.list().AddRectFilled({0, 0}, {kWidth, kHeight}, IM_COL32(0, 255, 0, 255));
  imgui.list().PopClipRect();
  const Image image = draw_plain(f.renderer, imgui.finish(), {0, 0, 0});
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) count += pixel(image, x, y).g == 255;
  }
  CHECK(count == 25 * 20);
  CHECK(pixel(image, 15, 5).g == 255);
  CHECK(pixel(image, 39, 24).g == 255);
  CHECK(pixel(image, 14, 5).g == 0);
  CHECK(pixel(image, 15, 25).g == 0);
}

TEST_CASE("half transparent white over black is level 128, and plain colours pass unchanged") {
  RenderFixture f(kWidth, kHeight);
  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().AddRectFilled({0, 0}, {10, 10}, IM_COL32(255, 255, 255, 128));
  imgui.list().AddRectFilled({20, 0}, {30, 10}, IM_COL32(37, 91, 200, 255));
  const Image image = draw_plain(f.renderer, imgui.finish(), {0, 0, 0});
  CHECK(std::abs(pixel(image, 5, 5).r - 128) <= 1);
  const Rgb p = pixel(image, 25, 5);
  CHECK(p.r == 37);
  CHECK(p.g == 91);
  CHECK(p.b == 200);
}

TEST_CASE("the overlay lies over the scene and leaves the rest of it alone") {
  RenderFixture f(kWidth, kHeight);
  VisualScene scene;
  scene.camera = front_camera(5);
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {0, 0, 1, 1}));
  const Image without = render(f.renderer, scene);
  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().AddRectFilled({35, 25}, {45, 35}, IM_COL32(255, 200, 0, 255));
  const Image with = render(f.renderer, scene, imgui.finish());
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 35 && x < 45 && y >= 25 && y < 35;
      const Rgb p = pixel(with, x, y);
      const Rgb q = inside ? Rgb{255, 200, 0} : pixel(without, x, y);
      if (p.r != q.r || p.g != q.g || p.b != q.b) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("text leaves ink where it is drawn") {
  RenderFixture f(kWidth, kHeight);
  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().AddText({10, 10}, IM_COL32(255, 255, 255, 255), "HHHH");
  const Image image = draw_plain(f.renderer, imgui.finish(), {0, 0, 0});
  int ink = 0;
  for (int y = 10; y < 23; ++y) {
    for (int x = 10; x < 38; ++x) ink += pixel(image, x, y).r > 128;
  }
  CHECK(ink > 40);  // four letters of the 13 pixel font
  CHECK(ink < 13 * 28 / 2);
}

}  // namespace pabd::test_overlay_pass
