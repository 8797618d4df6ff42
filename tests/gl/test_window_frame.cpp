// SPDX-License-Identifier: MIT
// A window's frame: views at their places, the interface over them, pictures in it. Whole bytes are compared:
// nothing on the way may change a colour.
#include <imgui.h>

#include <catch2/catch.hpp>
#include <functional>

#include "sim/base/error.h"
#include "tests/gl/imgui_frame.h"
#include "tests/gl/render_fixture.h"

namespace pabd::test_window_frame {

namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 80;

VisualScene lit_ball(const Vec4f& color) {
  VisualScene scene;
  scene.camera = front_camera(5);
  scene.grounds.push_back({{0, 1, 0}, -1});
  scene.instances[1].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, color));
  scene.instances[1][0].shaded = true;
  return scene;
}

Image read(Renderer& renderer) {
  Image image;
  renderer.queue_read();
  renderer.fetch(image);
  return image;
}

bool same(const Rgb& a, const Rgb& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

// Pixels of `window` inside the rectangle that differ from `part`.
int differing(const Image& window, const Image& part, int x0, int y0) {
  int wrong = 0;
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x)
      wrong += same(pixel(window, x0 + x, y0 + y), pixel(part, x, y)) ? 0 : 1;
  }
  return wrong;
}

}  // namespace

TEST_CASE("a view in a window has the very bytes of the frame that the same scene makes") {
  const VisualScene red = lit_ball({0.6f, 0.1f, 0.1f, 1}), blue = lit_ball({0.1f, 0.2f, 0.7f, 1});
  RenderFixture f(50, 60);
  const Image red_frame = render(f.renderer, red), blue_frame = render(f.renderer, blue);

  f.renderer.draw_view(0, red, 50, 60);
  f.renderer.draw_view(1, blue, 50, 60);
  Image blue_view;
  f.renderer.read_view(1, blue_view);
  CHECK(blue_view.rgb == blue_frame.rgb);
  const ViewPlace places[] = {{0, 5, 7, 50, 60}, {1, 61, 12, 50, 60}};
  f.renderer.compose(kWidth, kHeight, places, {0, 0, 0}, nullptr);
  const Image window = read(f.renderer);
  keep_image("window", window);
  REQUIRE(window.width == kWidth);
  REQUIRE(window.height == kHeight);
  CHECK(differing(window, red_frame, 5, 7) == 0);
  CHECK(differing(window, blue_frame, 61, 12) == 0);
  CHECK(same(pixel(window, 4, 30), {0, 0, 0}));
  CHECK(same(pixel(window, 55, 30), {0, 0, 0}));
  CHECK(same(pixel(window, 30, 6), {0, 0, 0}));
  CHECK(same(pixel(window, 30, 67), {0, 0, 0}));

  // It stays while only the interface changes, and may move.
  const ViewPlace moved[] = {{0, 70, 20, 50, 60}};
  f.renderer.compose(kWidth, kHeight, moved, {1, 1, 1}, nullptr);
  const Image later = read(f.renderer);
  CHECK(differing(later, red_frame, 70, 20) == 0);
  CHECK(same(pixel(later, 30, 30), {255, 255, 255}));
}

TEST_CASE("a view of half the size fills its place; one that was never drawn leaves the background") {
  RenderFixture f(16, 16);
  VisualScene scene = lit_ball({0.2f, 0.6f, 0.2f, 1});
  f.renderer.draw_view(0, scene, 60, 40);
  const ViewPlace places[] = {{0, 0, 0, kWidth, kHeight}, {1, 0, 0, 30, 30}};
  f.renderer.compose(kWidth, kHeight, places, {0, 0, 0}, nullptr);
  const Image window = read(f.renderer);
  const Image whole = [&] {
    RenderFixture g(kWidth, kHeight);
    Image image = render(g.renderer, scene);
    return image;
  }();
  f.context->make_current();
  // The ball and the background, away from edges: the same light within 6 levels.
  for (const auto& [x, y] : {std::pair{60, 40}, {50, 35}, {10, 5}, {110, 5}}) {
    CAPTURE(x, y);
    CHECK(std::abs(pixel(window, x, y).g - pixel(whole, x, y).g) <= 6);
    CHECK(std::abs(pixel(window, x, y).r - pixel(whole, x, y).r) <= 6);
  }
}

TEST_CASE("live quality shows the same: outlines within a pixel, light within a few levels") {
  constexpr int kSide = 240;
  VisualScene scene = lit_ball({0.5f, 0.3f, 0.2f, 1});
  scene.camera.eye = {1.5f, 2.5f, 6};
  scene.instances[1][0].shadow = true;
  Instance cube = flat_instance({1.6f, -0.5f, 0}, {0.5f, 0.5f, 0.5f}, {0.2f, 0.4f, 0.6f, 1});
  cube.shaded = cube.shadow = true;
  scene.instances[0].push_back(cube);
  scene.radius = 2.5f;
  RenderFixture f(16, 16);
  const ViewPlace place[] = {{0, 0, 0, kSide, kSide}};
  const auto picture = [&](const RenderQuality& quality) {
    f.renderer.draw_view(0, scene, kSide, kSide, quality);
    f.renderer.compose(kSide, kSide, place, {0, 0, 0}, nullptr);
    return read(f.renderer);
  };
  const Image full = picture({}), live = picture(RenderQuality::live()), again = picture({});
  keep_image("quality_full", full);
  keep_image("quality_live", live);
  CHECK(full.rgb == again.rgb);
  CHECK(full.rgb != live.rgb);
  // Off by more than 24 levels (of 255) even from the most similar pixel nearby: only along the rims of
  // shadows, which are harder, and under the bodies, where the darkness near the floor is left out.
  int off = 0, unlike = 0;
  double sum = 0;
  for (int y = 2; y < kSide - 2; ++y) {
    for (int x = 2; x < kSide - 2; ++x) {
      const int v = pixel(live, x, y).g;
      int least = 255;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) least = std::min(least, std::abs(v - pixel(full, x + dx, y + dy).g));
      }
      off += least > 24;
      unlike += std::abs(v - pixel(full, x, y).g) > 24;
      sum += v - pixel(full, x, y).g;
    }
  }
  CAPTURE(off, unlike, sum / (kSide * kSide));
  CHECK(off < kSide * kSide / 100);
  CHECK(unlike < kSide * kSide / 30);
  CHECK(std::abs(sum) / (kSide * kSide) < 2);
}

TEST_CASE("the passes of a frame are timed when asked for") {
  RenderFixture f(64, 64);
  render(f.renderer, lit_ball({0.5f, 0.3f, 0.2f, 1}));
  CHECK(f.renderer.pass_times().bodies == 0);
  f.renderer.measure_passes(true);
  render(f.renderer, lit_ball({0.5f, 0.3f, 0.2f, 1}));
  const PassTimes t = f.renderer.pass_times();
  CHECK(t.bodies > 0);
  CHECK(t.ground > 0);
  CHECK(t.prepare + t.shadow + t.contact_shade + t.bodies + t.ground + t.glyphs + t.resolve <=
        f.renderer.times().draw);
}

TEST_CASE("a view that is not there is refused, and the renderer goes on") {
  RenderFixture f(16, 16);
  CHECK_THROWS_AS(f.renderer.draw_view(Renderer::kViews, {}, 8, 8), Error);
  CHECK_THROWS_AS(f.renderer.draw_view(-1, {}, 8, 8), Error);
  CHECK_THROWS_AS(f.renderer.draw_view(0, {}, 0, 8), Error);
  Image image;
  CHECK_THROWS_AS(f.renderer.read_view(1, image), Error);
  f.renderer.draw_view(1, {}, 5, 9);
  f.renderer.read_view(1, image);
  CHECK(image.width == 5);
  CHECK(image.height == 9);
  f.renderer.draw_view(0, {}, 8, 8);
  f.renderer.compose(16, 16, {}, {1, 1, 1}, nullptr);
  CHECK(same(pixel(read(f.renderer), 3, 3), {255, 255, 255}));
}

TEST_CASE("the interface lies over the views, pictures in it keep their bytes") {
  RenderFixture f(kWidth, kHeight);
  Image picture;
  picture.resize(16, 9);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    picture.rgb[i] = static_cast<std::uint8_t>(i * 37 % 256);
  void* const id = f.renderer.upload_texture(picture);
  Image other = picture;
  for (std::uint8_t& v : other.rgb) v = static_cast<std::uint8_t>(255 - v);
  void* const other_id = f.renderer.upload_texture(other);
  REQUIRE(id != other_id);

  ImGuiFrame imgui(f.renderer, kWidth, kHeight);
  imgui.list().AddRectFilled({0, 0}, {20, 10}, IM_COL32(10, 20, 30, 255));
  imgui.list().AddImage(id, {40, 30}, {56, 39});
  imgui.list().AddImage(other_id, {60, 30}, {76, 39});
  imgui.list().AddRectFilled({100, 0}, {110, 10}, IM_COL32(200, 100, 50, 255));
  const ImDrawData* const data = imgui.finish();
  f.renderer.draw_view(0, lit_ball({0.6f, 0.1f, 0.1f, 1}), kWidth, kHeight);
  const ViewPlace place[] = {{0, 0, 0, kWidth, kHeight}};
  f.renderer.compose(kWidth, kHeight, place, {0, 0, 0}, data);
  const Image window = read(f.renderer);
  CHECK(same(pixel(window, 10, 5), {10, 20, 30}));
  CHECK(same(pixel(window, 105, 5), {200, 100, 50}));
  CHECK(differing(window, picture, 40, 30) == 0);
  CHECK(differing(window, other, 60, 30) == 0);

  f.renderer.free_texture(other_id);
  CHECK_THROWS_AS(f.renderer.compose(kWidth, kHeight, place, {0, 0, 0}, data), Error);
  CHECK_THROWS_AS(f.renderer.free_texture(other_id), Error);
  CHECK_THROWS_AS(f.renderer.free_texture(nullptr), Error);
}

TEST_CASE("pictures that cannot be textures are refused") {
  RenderFixture f(16, 16);
  CHECK_THROWS_AS(f.renderer.upload_texture(Image{}), Error);
  Image wide;
  wide.resize(100000, 1);
  CHECK_THROWS_AS(f.renderer.upload_texture(wide), Error);
}

}  // namespace pabd::test_window_frame
