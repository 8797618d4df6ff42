// SPDX-License-Identifier: MIT
// Frames come back in order, whole, and in their own size.
#include <catch2/catch.hpp>

#include "sim/base/error.h"
#include "tests/gl/render_fixture.h"
#include "tests/support/errors.h"

namespace pabd::test_read_back {

namespace {

bool is_plain(const Image& image, int r, int g, int b) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgb p = pixel(image, x, y);
      if (p.r != r || p.g != g || p.b != b) return false;
    }
  }
  return true;
}

// Empty when it went well.
std::optional<ErrorKind> kind_of(RenderFixture& f, int width, int height, std::string& text) {
  const Caught error = caught([&] { f.renderer.resize(width, height); });
  if (error.kind) text = error.text;
  return error.kind;
}

}  // namespace

TEST_CASE("two frames queued come back oldest first; a third is refused; none left gives false") {
  RenderFixture f(31, 17);  // odd on purpose: no row has a friendly length
  Image image;
  CHECK_FALSE(f.renderer.fetch(image));
  f.renderer.compose(31, 17, {}, {1, 0, 0}, nullptr);
  f.renderer.queue_read();
  f.renderer.compose(31, 17, {}, {0, 1, 0}, nullptr);
  f.renderer.queue_read();
  CHECK(f.renderer.queued() == 2);
  f.renderer.compose(31, 17, {}, {0, 0, 1}, nullptr);
  CHECK_THROWS_AS(f.renderer.queue_read(), Error);
  REQUIRE(f.renderer.fetch(image));
  CHECK(is_plain(image, 255, 0, 0));
  f.renderer.queue_read();
  REQUIRE(f.renderer.fetch(image));
  CHECK(is_plain(image, 0, 255, 0));
  REQUIRE(f.renderer.fetch(image));
  CHECK(is_plain(image, 0, 0, 255));
  CHECK_FALSE(f.renderer.fetch(image));
}

TEST_CASE("a queued frame keeps its size over a resize") {
  RenderFixture f(20, 10);
  f.renderer.compose(20, 10, {}, {1, 0, 0}, nullptr);
  f.renderer.queue_read();
  f.renderer.resize(7, 33);
  f.renderer.compose(7, 33, {}, {0, 1, 0}, nullptr);
  f.renderer.queue_read();
  Image image;
  REQUIRE(f.renderer.fetch(image));
  CHECK(image.width == 20);
  CHECK(image.height == 10);
  CHECK(is_plain(image, 255, 0, 0));
  REQUIRE(f.renderer.fetch(image));
  CHECK(image.width == 7);
  CHECK(image.height == 33);
  CHECK(is_plain(image, 0, 255, 0));
}

TEST_CASE("a resized renderer draws what a fresh one draws") {
  VisualScene scene;
  scene.instances[1].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {0.5f, 0.2f, 0.1f, 1}));
  scene.instances[1][0].shaded = true;
  scene.camera = front_camera(5);
  RenderFixture f(64, 64);
  render(f.renderer, scene);
  f.renderer.resize(90, 41);
  RenderFixture fresh(90, 41);
  const Image expected = render(fresh.renderer, scene);
  f.context->make_current();
  CHECK(render(f.renderer, scene).rgb == expected.rgb);
  fresh.context->make_current();
}

TEST_CASE("rows count from the top") {
  RenderFixture f(40, 40);
  VisualScene scene;
  scene.camera = front_camera(5);
  scene.instances[0].push_back(flat_instance({0, 1.2f, 0}, {0.2f, 0.2f, 0.2f}, {1, 0, 0, 1}));
  const Image image = render(f.renderer, scene);
  CHECK(pixel(image, 20, 8).r > 200);
  CHECK(pixel(image, 20, 8).g < 20);
  CHECK(pixel(image, 20, 32).g > 100);
}

TEST_CASE("sizes that cannot be: named, with a remedy") {
  RenderFixture f(16, 16);
  std::string text;
  CHECK(kind_of(f, 0, 16, text) == ErrorKind::bad_input);
  CHECK(text.find("--size") != std::string::npos);
  CHECK(kind_of(f, 16, -3, text) == ErrorKind::bad_input);
  CHECK(kind_of(f, 1000000, 16, text) == ErrorKind::no_context);
  CHECK(kind_of(f, 1000000, 16, text) == ErrorKind::no_context);  // and again
  CHECK(text.find("1000000x16") != std::string::npos);
  CHECK(text.find("--size") != std::string::npos);
  // And the renderer can go on with a size that is fine.
  CHECK(kind_of(f, 16, 16, text) == std::nullopt);
  f.renderer.compose(16, 16, {}, {1, 1, 1}, nullptr);
  f.renderer.queue_read();
  Image image;
  REQUIRE(f.renderer.fetch(image));
  CHECK(is_plain(image, 255, 255, 255));
}

TEST_CASE("the times of a frame are those of the clock") {
  RenderFixture f(64, 64);
  render(f.renderer, {});
  CHECK(f.renderer.times().draw > 0);
  CHECK(f.renderer.times().read_back > 0);
  CHECK_FALSE(f.renderer.gl_renderer().empty());
  CHECK_FALSE(f.renderer.gl_version().empty());
}

}  // namespace pabd::test_read_back
