// SPDX-License-Identifier: MIT
// Pixels against theory: coverage, sRGB, background, shadow, transparency, glyphs behind bodies, lines.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/gl/drawn_scenes.h"
#include "tests/gl/render_fixture.h"

namespace pabd::test_picture {

namespace {

Mat4f scaled(const Vec3f& at, float half) {
  Mat4f m = Mat4f::Identity() * half;
  m(3, 3) = 1;
  m.block<3, 1>(0, 3) = at;
  return m;
}

// A floor seen from straight above, with a cube of edge 1 high over it, and light from aside.
VisualScene floating_cube(float height, bool shadow) {
  VisualScene scene;
  scene.grounds.push_back({{0, 1, 0}, 0});
  scene.instances[0].push_back({scaled({0.35f, height, 0.35f}, 0.5f), {0.5f, 0.5f, 0.5f, 1}, shadow});
  scene.centre = {0, 0, 0};
  scene.radius = 6;
  scene.light_direction = {-1, -2, -0.5f};
  scene.camera.eye = {0, 20, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  return scene;
}

// Pixel of the floor point (x, z) as that camera sees it.
Rgb floor_pixel(const Image& image, float x, float z) {
  const double f = 1 / std::tan(22.5 * 3.14159265358979 / 180);
  const double half = 0.5 * image.height;
  return pixel(image, static_cast<int>(0.5 * image.width + f * x / 20 * half),
               static_cast<int>(half + f * z / 20 * half));
}

}  // namespace

TEST_CASE("middle grey: linear 0.2140 is level 127, cleared, drawn and blended") {
  RenderFixture f(32, 32);
  Image image;
  f.renderer.compose(32, 32, {}, Vec3f::Constant(0.2140f), nullptr);
  f.renderer.queue_read();
  f.renderer.fetch(image);
  CHECK(std::abs(pixel(image, 16, 16).g - 127) <= 1);

  VisualScene scene;
  scene.camera = front_camera(5);
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {0.2140f, 0.2140f, 0.2140f, 1}));
  CHECK(std::abs(pixel(render(f.renderer, scene), 16, 16).g - 127) <= 1);

  // Half of 0.428 over black is 0.214 in linear light; blending sRGB values would give 88.
  scene.instances[0] = {flat_instance({0, 0, 0}, {1, 1, 1}, {0, 0, 0, 1}),
                        flat_instance({0, 0, 2}, {1, 1, 0.1f}, {0.4280f, 0.4280f, 0.4280f, 0.5f})};
  CHECK(std::abs(pixel(render(f.renderer, scene), 16, 16).g - 127) <= 2);
}

TEST_CASE("the background runs from its lower to its upper colour") {
  RenderFixture f(16, 200);
  const Image image = render(f.renderer, {});
  keep_image("background", image);
  const Rgb top = pixel(image, 8, 0), bottom = pixel(image, 8, 199);
  CHECK(std::abs(top.r - to_srgb_byte(kStudioTheme.top[0])) <= 1);
  CHECK(std::abs(top.b - to_srgb_byte(kStudioTheme.top[2])) <= 1);
  CHECK(std::abs(bottom.r - to_srgb_byte(kStudioTheme.bottom[0])) <= 1);
  CHECK(std::abs(bottom.b - to_srgb_byte(kStudioTheme.bottom[2])) <= 1);
}

TEST_CASE("the background shows no bands: means of 4×4 pixels are the gradient's to an eighth of a level") {
  RenderFixture f(16, 720);
  VisualScene scene;
  for (const PictureTheme* theme : {&kStudioTheme, &kDarkTheme}) {
    scene.theme = theme;
    const Image image = render(f.renderer, scene);
    double worst = 0;
    for (int top = 0; top < image.height; top += 4) {
      double mean = 0, exact = 0;
      for (int y = top; y < top + 4; ++y) {
        const double up = 1 - (y + 0.5) / image.height, t = up * up * (3 - 2 * up);
        exact += to_srgb_byte(theme->bottom[1] + t * (theme->top[1] - theme->bottom[1])) / 4;
        for (int x = 4; x < 8; ++x) mean += pixel(image, x, y).g / 16.0;
      }
      worst = std::max(worst, std::abs(mean - exact));
    }
    CAPTURE(theme->name);
    CHECK(worst < 0.125);
  }
  // Where it is the same everywhere, all pixels are too.
  for (const PictureTheme* theme : {&kPaperTheme, &kOnBlackTheme, &kOnWhiteTheme}) {
    scene.theme = theme;
    const Image image = render(f.renderer, scene);
    CHECK(std::count(image.rgb.begin(), image.rgb.end(), image.rgb[0]) == std::ssize(image.rgb));
  }
}

TEST_CASE("a red flat cube covers its projected area to 1 % and is exactly red") {
  RenderFixture f(600, 450);
  VisualScene scene;
  scene.camera = front_camera(10);
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 0, 0, 1}));
  const Image image = render(f.renderer, scene, nullptr, Quality::best);
  // Coverage of a pixel from its green channel, which red takes away (background is not red).
  const Image empty = render(f.renderer, {}, nullptr, Quality::best);
  double area = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      area += 1 - to_linear(pixel(image, x, y).g) / to_linear(pixel(empty, x, y).g);
    }
  }
  // The near face, 9 m away, hides the others: side 2/9 / tan(22.5°) of half the height.
  const double side = 2.0 / 9 / std::tan(22.5 * 3.14159265358979 / 180) * 225;
  CHECK(area == Approx(side * side).epsilon(0.01));
  const Rgb p = pixel(image, 300, 225);
  CHECK(p.r == 255);
  CHECK(p.g == 0);
  CHECK(p.b == 0);
}

TEST_CASE("at best quality edges are smoothed by four samples in linear light") {
  RenderFixture f(64, 64);
  VisualScene scene;
  scene.camera = front_camera(5);
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 0, 0, 1}));
  scene.instances[0][0].transform.block<3, 3>(0, 0) =
      Eigen::AngleAxisf(0.3f, Vec3f(0, 0, 1)).toRotationMatrix();
  const Image image = render(f.renderer, scene, nullptr, Quality::best);
  const Image empty = render(f.renderer, {}, nullptr, Quality::best);
  int edge = 0, off = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double quarter = 4 * to_linear(pixel(image, x, y).g) / to_linear(pixel(empty, x, y).g);
      const bool mixed = quarter > 0.5 && quarter < 3.5;
      edge += mixed;
      off += mixed && std::abs(quarter - std::round(quarter)) > 0.1;
    }
  }
  CHECK(edge > 40);
  CHECK(off == 0);
}

TEST_CASE("a shadow takes exactly the sun's part of the floor's light") {
  RenderFixture f(400, 400);
  // Light (−1, −2, −0.5): from height 4 the cube's centre falls 2 m aside and 1 m back.
  const Image with = render(f.renderer, floating_cube(4, true));
  const Image without = render(f.renderer, floating_cube(4, false));
  keep_image("shadow", with);
  const float x = 0.35f - 2, z = 0.35f - 1;
  const double cosine = 2 / std::sqrt(5.25);
  const Rgb dark = floor_pixel(with, x, z), open = floor_pixel(without, x, z);
  const int dark_channels[] = {dark.r, dark.g, dark.b}, open_channels[] = {open.r, open.g, open.b};
  for (int i = 0; i < 3; ++i) {
    const double sky = kStudioTheme.sky[i], sun = kStudioTheme.sun[i] * cosine;
    // 2 %: two levels of 8 bits. Four metres up, the cube's own contact shade is below 1e-3.
    CHECK(to_linear(dark_channels[i]) / to_linear(open_channels[i]) ==
          Approx(sky / (sky + sun)).epsilon(0.02));
  }
  // Aside of the shadow nothing changes; the shadow is as wide as the cube: 0.5 m from its middle, to 0.1 m.
  CHECK(floor_pixel(with, x - 1.2f, z).g == floor_pixel(without, x - 1.2f, z).g);
  const double middle = 0.5 * (to_linear(dark.g) + to_linear(open.g));
  CHECK(to_linear(floor_pixel(with, x - 0.4f, z).g) < middle);
  CHECK(to_linear(floor_pixel(with, x - 0.9f, z).g) > middle);
  // The floor in the open has its own colour.
  const Rgb lit = floor_pixel(with, 3.37f, 2.61f);
  CHECK(std::abs(lit.g - to_srgb_byte(kStudioTheme.floor[1])) <= 3);
}

TEST_CASE("lit faces show no acne: every pixel of a face in the sun has the same light") {
  RenderFixture f(300, 300);
  VisualScene scene = floating_cube(0.5f, true);
  scene.radius = 3;
  const Image image = render(f.renderer, scene);
  keep_image("acne", image);
  // The top face, 19 m below the eye; inside its soft edges.
  const double scale = 150 / std::tan(22.5 * 3.14159265358979 / 180) / 19;
  int lo = 255, hi = 0;
  for (double x = 0.05; x < 0.65; x += 0.02) {
    for (double z = 0.05; z < 0.65; z += 0.02) {
      const int g = pixel(image, static_cast<int>(150 + x * scale), static_cast<int>(150 + z * scale)).g;
      lo = std::min(lo, g);
      hi = std::max(hi, g);
    }
  }
  CHECK(hi - lo <= 2);
}

TEST_CASE("the floor darkens where a body stands on it, and not where one floats high") {
  RenderFixture f(400, 400);
  const Image standing = render(f.renderer, floating_cube(0.5f, true));
  const Image floating = render(f.renderer, floating_cube(5, true));
  // 0.1 m in front of the cube's face at x = 0.85, which the sun lights.
  const double near = to_linear(floor_pixel(standing, 0.95f, 0.45f).g);
  const double free = to_linear(floor_pixel(floating, 0.95f, 0.45f).g);
  CHECK(near < 0.97 * free);
  CHECK(near > 0.5 * free);  // the sun still gets there
}

TEST_CASE("transparent surfaces are blended back to front whatever their order in the list") {
  RenderFixture f(48, 48);
  VisualScene scene;
  scene.camera = front_camera(10);
  const Instance wall = flat_instance({0, 0, -2}, {3, 3, 0.1f}, {0.2f, 0.2f, 0.2f, 1});
  const Instance back = flat_instance({0, 0, 0}, {1, 1, 0.1f}, {0.8f, 0.1f, 0.1f, 0.5f});
  const Instance front = flat_instance({0, 0, 2}, {1, 1, 0.1f}, {0.1f, 0.1f, 0.9f, 0.25f});
  scene.instances[0] = {wall, back, front};
  const Image a = render(f.renderer, scene);
  scene.instances[0] = {front, wall, back};
  const Image b = render(f.renderer, scene);
  CHECK(a.rgb == b.rgb);
  // Linear red: 0.25·0.1 + 0.75·(0.5·0.8 + 0.5·0.2); two roundings to 8 bits.
  const Rgb p = pixel(a, 24, 24);
  CHECK(std::abs(p.r - to_srgb_byte(0.25 * 0.1 + 0.75 * (0.5 * 0.8 + 0.5 * 0.2))) <= 2);
  CHECK(std::abs(p.b - to_srgb_byte(0.25 * 0.9 + 0.75 * (0.5 * 0.1 + 0.5 * 0.2))) <= 2);
}

TEST_CASE("a glyph behind a body shows through, in front it covers, and it hides in no other glyph") {
  RenderFixture f(48, 48);
  VisualScene scene;
  scene.camera = front_camera(10);
  scene.instances[0] = {flat_instance({0, 0, 0}, {2, 2, 0.5f}, {0, 0, 1, 1})};
  Instance glyph = flat_instance({0, 0, -1}, {1, 1, 0.1f}, {1, 0, 0, 1});
  glyph.xray = true;
  scene.instances[0].push_back(glyph);
  const Rgb behind = pixel(render(f.renderer, scene), 24, 24);
  CHECK(std::abs(behind.r - to_srgb_byte(0.5)) <= 2);
  CHECK(std::abs(behind.b - to_srgb_byte(0.5)) <= 2);
  scene.instances[0][1].transform(2, 3) = 1;
  const Rgb before = pixel(render(f.renderer, scene), 24, 24);
  CHECK(before.r == 255);
  CHECK(before.b == 0);
}

TEST_CASE("glyphs that software GL draws as shapes look as their meshes do, in sight and behind bodies") {
  constexpr int kSize = 240;
  RenderFixture f(kSize, kSize);
  const Primitive kind = GENERATE(Primitive::sphere, Primitive::cylinder, Primitive::cone, Primitive::disc);
  const float slope = GENERATE(-1.5f, -0.8f, -0.05f, 0.6f, 1.2f);  // of the axis towards the eye
  VisualScene scene;
  scene.camera = front_camera(10);
  scene.camera.orthographic = GENERATE(false, true);
  scene.radius = 4;
  // One in sight, one half in a body, one behind it, and one small; off the middle, where balls are ellipses.
  scene.instances[0] = {flat_instance({1.5f, 1.5f, 0}, {1, 1, 1}, {0.1f, 0.1f, 0.6f, 1})};
  const Eigen::Matrix3f turn =
      (Eigen::AngleAxisf(0.4f, Vec3f::UnitZ()) * Eigen::AngleAxisf(slope, Vec3f::UnitX())).matrix();
  for (const Vec4f& at :
       {Vec4f(-2.5f, -2.5f, 0.5f, 0.5f), {2.2f, 1.8f, 1, 0.5f}, {0.8f, 0.9f, -2, 0.5f}, {-2, 2, 0, 0.12f}}) {
    Instance glyph;
    glyph.transform = scaled(at.head<3>(), at.w());
    glyph.transform.block<3, 3>(0, 0) *= turn;
    if (kind == Primitive::cylinder) glyph.transform.block<3, 1>(0, 1) *= 1.5f;
    glyph.color = {0.8f, 0.3f, 0.1f, 1};
    glyph.shadow = false;
    glyph.shaded = kind == Primitive::sphere;
    glyph.xray = true;
    scene.instances[static_cast<int>(kind)].push_back(glyph);
  }
  const auto drawn = [&](Quality level) {
    f.renderer.draw(scene, nullptr, {level, 0.1f});
    f.renderer.queue_read();
    Image image;
    f.renderer.fetch(image);
    return image;
  };
  const Image shapes = drawn(Quality::good), meshes = drawn(Quality::best);
  int off = 0;
  double signed_sum = 0;
  for (std::size_t k = 0; k < shapes.rgb.size(); ++k) {
    const int difference = shapes.rgb[k] - meshes.rgb[k];
    off += std::abs(difference) > 12 ? 1 : 0;
    signed_sum += difference;
  }
  CAPTURE(static_cast<int>(kind), slope, scene.camera.orthographic, off, signed_sum);
  // Edges are smoothed in two ways: a seventh of a percent of the values.
  CHECK(off < 1300);
  CHECK(std::abs(signed_sum) < 1e4);
}

TEST_CASE("lines are as wide as they say, scale with the frame, and hide unless on top") {
  const auto green_loss = [](const Image& image, const Image& empty, int x) {
    double width = 0;
    for (int y = 0; y < image.height; ++y) {
      width += 1 - to_linear(pixel(image, x, y).g) / to_linear(pixel(empty, x, y).g);
    }
    return width;
  };
  for (const int height : {180, 360}) {
    RenderFixture f(height, height);
    VisualScene scene;
    scene.camera = front_camera(10);
    const Image empty = render(f.renderer, scene);
    scene.lines.push_back({{-2, 0.13f, 0}, {2, 0.13f, 0}, {1, 0, 0, 1}, 12, false});
    const Image image = render(f.renderer, scene);
    CHECK(green_loss(image, empty, height / 2) == Approx(12.0 * height / 720).margin(0.15));
  }
  RenderFixture f(90, 90);
  VisualScene scene;
  scene.camera = front_camera(10);
  scene.instances[0].push_back(flat_instance({0, 0, 1}, {1, 1, 0.5f}, {0, 0, 1, 1}));
  scene.lines.push_back({{-2, 0, 0}, {2, 0, 0}, {1, 0, 0, 1}, 32, false});
  CHECK(pixel(render(f.renderer, scene), 45, 45).r == 0);
  scene.lines[0].on_top = true;
  CHECK(pixel(render(f.renderer, scene), 45, 45).r == 255);
  // An end behind the eye does not tear the line.
  scene.lines[0] = {{0, 0, 30}, {0, 0.5f, -5}, {1, 0, 0, 1}, 32, true};
  CHECK_NOTHROW(render(f.renderer, scene));
}

TEST_CASE("radii nearly equal give floors nearly equal, at every size") {
  RenderFixture f(240, 160);
  VisualScene scene;
  scene.grounds.push_back({{0, 1, 0}, 0});
  scene.camera.target = {0, 0, 0};
  for (float radius = 0.2f; radius < 30; radius *= 1.07f) {
    // The middle of a pair is at each end of a decade once: 2.5 · 10ᵏ m.
    const float decade = 0.25f * std::pow(10.0f, std::round(std::log10(radius / 0.25f)));
    const float middle = std::abs(radius / decade - 1) < 0.035f ? decade : radius;
    scene.camera.eye = {1.5f * middle, 2 * middle, 2.5f * middle};
    scene.radius = 0.9995f * middle;
    const Image smaller = render(f.renderer, scene);
    scene.radius = 1.0005f * middle;
    const Image larger = render(f.renderer, scene);
    int worst = 0, dark = 255, light = 0;
    for (std::size_t i = 0; i < smaller.rgb.size(); ++i) {
      worst = std::max(worst, std::abs(smaller.rgb[i] - larger.rgb[i]));
      if (i < smaller.rgb.size() / 2) continue;  // below: the floor alone
      dark = std::min<int>(dark, smaller.rgb[i]);
      light = std::max<int>(light, smaller.rgb[i]);
    }
    CAPTURE(middle);
    CHECK(worst <= 2);
    CHECK(light - dark > 5);  // there is a grid to be seen
    if (middle == decade) keep_image("floor " + std::to_string(middle), smaller);
  }
}

TEST_CASE("scenes that make no sense are drawn as far as they do") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  RenderFixture f(40, 30);
  VisualScene scene;
  scene.grounds.push_back({{0, 0, 0}, 0});
  scene.grounds.push_back({{0, 1, 0}, nan});
  scene.instances[0].push_back({scaled({0, nan, 0}, 1), {1, 1, 1, 1}});
  scene.instances[1].push_back({Mat4f::Zero(), {1, 1, 1, 1}});
  scene.lines.push_back({{0, nan, 0}, {0, 0, 0}, {1, 0, 0, 1}, 2, true});
  scene.lines.push_back({{0, 0, 0}, {0, 0, 0}, {1, 0, 0, 1}, 2, true});
  scene.light_direction = {0, 0, 0};
  scene.radius = 0;
  scene.camera.eye = scene.camera.target;
  CHECK_NOTHROW(render(f.renderer, scene));
  scene.radius = 1e9f;
  CHECK_NOTHROW(render(f.renderer, scene));
}

TEST_CASE("a pile of all shapes, for looking at") {
  RenderFixture f(320, 180);
  const TinyModel tiny = mixed_bodies(4);
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  scene.camera = frame_camera(tiny.model, tiny.state, 16.0 / 9);
  const Image image = render(f.renderer, scene);
  keep_image("pile", image);
  CHECK(image.rgb == render(f.renderer, scene).rgb);
}

}  // namespace pabd::test_picture
