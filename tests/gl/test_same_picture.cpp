// SPDX-License-Identifier: MIT
// A picture follows from its scene alone, whatever the renderer drew before: it has the bytes that a fresh renderer draws.
#include <catch2/catch.hpp>
#include <functional>
#include <utility>
#include <vector>

#include "render/visual/build_visual.h"
#include "tests/gl/drawn_scenes.h"
#include "tests/gl/imgui_frame.h"
#include "tests/gl/render_fixture.h"

namespace pabd::test_same_picture {

namespace {

constexpr int kWidth = 320, kHeight = 180;

// Bricks with contacts on a floor, seen from a little above.
VisualScene bricks() {
  const BrickPyramid pyramid(4);
  VisualOptions options;
  options.contacts = true;
  VisualScene scene;
  build_visual(pyramid.tiny.model, pyramid.tiny.state, pyramid.report, options, scene);
  scene.camera.eye = {3, 3, 7};
  return scene;
}

struct Frame {
  VisualScene scene = bricks();
  RenderQuality quality;
  int width = kWidth, height = kHeight;
};

Image draw(Renderer& renderer, const Frame& frame) {
  renderer.resize(frame.width, frame.height);
  renderer.draw(frame.scene, nullptr, frame.quality);
  renderer.queue_read();
  Image image;
  renderer.fetch(image);
  return image;
}

struct Change {
  const char* what;
  std::function<void(Frame&)> apply;
};

// Each shows in the picture.
std::vector<Change> changes() {
  static const PictureTheme red_floor = [] {
    PictureTheme theme = kStudioTheme;
    theme.floor[1] = theme.floor[2] = 0.1f;
    return theme;
  }();
  return {
      {"camera", [](Frame& f) { f.scene.camera.eye.x() += 0.2f; }},
      {"parallel rays", [](Frame& f) { f.scene.camera.orthographic = true; }},
      {"place in the frame", [](Frame& f) { f.scene.camera.shift.x() = 0.3f; }},
      {"theme", [](Frame& f) { f.scene.theme = &kDarkTheme; }},
      {"colour of the floor", [](Frame& f) { f.scene.theme = &red_floor; }},
      {"draft", [](Frame& f) { f.quality.level = Quality::draft; }},
      {"best", [](Frame& f) { f.quality.level = Quality::best; }},
      {"size", [](Frame& f) { f.width = 200; }},
      {"light",
       [](Frame& f) {
         f.scene.light_direction = {0.5f, -1, 0.4f};
       }},
      {"no shadows",
       [](Frame& f) {
         for (Instance& i : f.scene.instances[0]) i.shadow = false;
       }},
      {"height of the floor", [](Frame& f) { f.scene.grounds[0].offset = -0.4f; }},
      {"slope of the floor",
       [](Frame& f) {
         f.scene.grounds[0].normal = {0.1f, 1, 0};
       }},
      {"no floor", [](Frame& f) { f.scene.grounds.clear(); }},
      {"a second floor",
       [](Frame& f) {
         f.scene.grounds.push_back({{1, 0, 0}, -3});
       }},
      {"where the scene is", [](Frame& f) { f.scene.centre.x() += 1; }},
      {"radius", [](Frame& f) { f.scene.radius *= 8; }},
      {"a body", [](Frame& f) { f.scene.instances[0][3].transform(1, 3) += 0.3f; }},
      {"a colour",
       [](Frame& f) {
         f.scene.instances[0][3].color = {0.9f, 0.1f, 0.1f, 1};
       }},
      {"a line",
       [](Frame& f) {
         f.scene.lines.push_back({{-2, 1, 1}, {2, 1, 1}, {1, 0, 0, 1}, 3});
       }},
  };
}

// Pixels that differ.
int differing(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return a.width * a.height;
  int count = 0;
  for (std::size_t at = 0; at < a.rgb.size(); at += 3)
    count += !std::equal(a.rgb.begin() + static_cast<std::ptrdiff_t>(at),
                         a.rgb.begin() + static_cast<std::ptrdiff_t>(at) + 3,
                         b.rgb.begin() + static_cast<std::ptrdiff_t>(at));
  return count;
}

}  // namespace

TEST_CASE("what changes in a scene changes its picture, to what a fresh renderer draws; and back") {
  RenderFixture f(kWidth, kHeight);
  const Frame plain;
  const Image first = draw(f.renderer, plain);
  for (const auto& [what, apply] : changes()) {
    CAPTURE(what);
    Frame changed;
    apply(changed);
    f.context->make_current();
    const Image later = draw(f.renderer, changed), again = draw(f.renderer, changed),
                back = draw(f.renderer, plain);
    Image fresh;
    {
      RenderFixture g(changed.width, changed.height);
      fresh = draw(g.renderer, changed);
    }
    CHECK(differing(later, first) > 50);
    CHECK(differing(later, fresh) == 0);
    CHECK(differing(again, fresh) == 0);
    CHECK(differing(back, first) == 0);
  }
  f.context->make_current();
}

TEST_CASE("a theme that changes in place changes the picture") {
  RenderFixture f(kWidth, kHeight);
  PictureTheme theme = kStudioTheme;
  Frame frame;
  frame.scene.theme = &theme;
  const Image before = draw(f.renderer, frame);
  theme.sun[0] = 0.3f;
  CHECK(differing(draw(f.renderer, frame), before) > 1000);
}

TEST_CASE("bodies that move a little at a time leave nothing of where they were") {
  RenderFixture f(kWidth, kHeight);
  Frame frame;
  for (int k = 0; k < 10; ++k) {
    for (Instance& i : frame.scene.instances[0]) i.transform(0, 3) += 0.01f * static_cast<float>(k);
    frame.scene.centre.x() += 0.01f * static_cast<float>(k);
    draw(f.renderer, frame);
  }
  const Image moved = draw(f.renderer, frame);
  RenderFixture g(kWidth, kHeight);
  CHECK(differing(moved, draw(g.renderer, frame)) == 0);
}

TEST_CASE("what lay over a scene is gone when the same scene is drawn again") {
  RenderFixture f(kWidth, kHeight);
  const Frame frame;
  const Image plain = draw(f.renderer, frame);
  {
    ImGuiFrame interface(f.renderer, kWidth, kHeight);
    interface.list().AddRectFilled({10, 10}, {200, 100}, IM_COL32(255, 0, 0, 255));
    f.renderer.draw(frame.scene, interface.finish());
  }
  CHECK(differing(draw(f.renderer, frame), plain) == 0);
  f.renderer.compose(kWidth, kHeight, {}, {1, 0, 0}, nullptr);
  CHECK(differing(draw(f.renderer, frame), plain) == 0);
  f.renderer.draw_view(0, frame.scene, 100, 50);
  CHECK(differing(draw(f.renderer, frame), plain) == 0);
}

}  // namespace pabd::test_same_picture
