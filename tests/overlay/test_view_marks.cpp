// SPDX-License-Identifier: MIT
// The scale bar is as long as it says, the axes point where the camera sees them.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/overlay/view_marks.h"

namespace pabd::test_view_marks {

namespace {

// What is painted, as lines and words.
class Notes : public Canvas {
 public:
  explicit Notes(const FontMetrics& font) : Canvas(font) {}
  std::vector<std::vector<Point>> lines;
  std::vector<std::pair<std::string, Point>> words;

  void polyline(std::span<const Point> points, const Stroke&, bool) override {
    lines.emplace_back(points.begin(), points.end());
  }
  void fill_polygon(std::span<const Point>, Color) override {}
  void fill_rect(const Rect&, Color, double) override {}
  void fill_circle(const Point&, double, Color) override {}
  void text(const Point& at, std::string_view rich, const TextStyle&) override {
    words.emplace_back(std::string(rich), at);
  }
  void push_clip(const Rect&) override {}
  void pop_clip() override {}
};

}  // namespace

TEST_CASE("round lengths are the longest of 1, 2 and 5 that fit, with their unit") {
  CHECK(round_length(0.01, 150) == Approx(1));
  CHECK(round_length(0.01, 200) == Approx(2));
  CHECK(round_length(0.01, 100) == Approx(1));
  CHECK(round_length(0.01, 99) == Approx(0.5));
  CHECK(round_length(7, 150) == Approx(1000));
  CHECK(round_length(0, 150) == 0);
  for (double pixel = 1e-6; pixel < 1e4; pixel *= 1.07) {
    const double length = round_length(pixel, 120);
    CHECK(length <= 120 * pixel * (1 + 1e-12));
    CHECK(length > 120 * pixel / 2.5001);
  }
  CHECK(length_text(2) == "2 m");
  CHECK(length_text(0.5) == "50 cm");
  CHECK(length_text(0.01) == "1 cm");
  CHECK(length_text(0.005) == "5 mm");
  CHECK(length_text(2000) == "2 km");
}

TEST_CASE("the bar is as long as its length is at the target, in every picture") {
  const FontMetrics font;
  for (const bool parallel : {false, true}) {
    for (const double height : {360.0, 720.0, 1440.0}) {
      Camera camera;
      camera.orthographic = parallel;
      Notes notes(font);
      paint_scale_bar(camera, kInksOnLight, height, {0, 0, 1.5 * height, height}, height / 720, notes);
      REQUIRE(notes.words.size() == 1);
      REQUIRE_FALSE(notes.lines.empty());
      const std::vector<Point>& bar = notes.lines.back();
      const double length = std::stod(notes.words[0].first);
      const Mat4f clip = projection_matrix(camera, 1.5f, 0.1f, 100) * view_matrix(camera);
      const Vec3f right = view_matrix(camera).row(0).head<3>();
      const auto pixel = [&](const Vec3f& p) {
        const Vec4f c = clip * p.homogeneous();
        return 0.5 * 1.5 * height * static_cast<double>(c.x() / c.w());
      };
      const double expected =
          pixel(camera.target + static_cast<float>(length) * right) - pixel(camera.target);
      CHECK(bar[2].x - bar[1].x == Approx(expected).epsilon(1e-4));
      CHECK(bar[1].x > 0);
    }
  }
}

TEST_CASE("every theme has inks that stand out from its background") {
  // Relative luminance of sRGB, and contrast as WCAG 2 defines it: 3 is asked of drawings, 4.5 of text.
  const auto linear = [](std::uint8_t c) {
    const double v = c / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const auto luminance = [](double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  for (const PictureTheme* theme : picture_themes()) {
    if (theme->transparent) continue;  // nobody knows what will be behind it
    CAPTURE(theme->name);
    for (const auto& behind : {theme->top, theme->bottom, theme->floor}) {
      const double paper = luminance(static_cast<double>(behind[0]), static_cast<double>(behind[1]),
                                     static_cast<double>(behind[2]));
      const auto contrast = [&](const std::uint8_t(&c)[3]) {
        const double of = luminance(linear(c[0]), linear(c[1]), linear(c[2]));
        return (std::max(of, paper) + 0.05) / (std::min(of, paper) + 0.05);
      };
      for (const auto& axis : theme->inks.axes) CHECK(contrast(axis) > 3);
      CHECK(contrast(theme->inks.text) > 4.5);
    }
  }
}

TEST_CASE("axes: letters to the sides that their axes point to; the one along the line of sight is a dot") {
  const FontMetrics font;
  Camera camera;
  camera.target = {0, 0, 0};
  camera.eye = {0, 0, 5};
  Notes notes(font);
  paint_axes(camera, kInksOnLight, {0, 0, 800, 600}, 1, notes);
  REQUIRE(notes.words.size() == 3);
  const auto at = [&](const std::string& name) {
    for (const auto& [word, place] : notes.words)
      if (word == name) return place;
    FAIL("no " + name);
    return Point{};
  };
  CHECK(at("x").x > at("y").x + 20);
  CHECK(at("y").y < at("x").y - 20);
  CHECK(std::hypot(at("z").x - at("y").x, at("z").y - at("x").y) < 20);
  // Too small a picture has none.
  Notes none(font);
  paint_axes(camera, kInksOnLight, {0, 0, 80, 600}, 1, none);
  CHECK(none.words.empty());
}

}  // namespace pabd::test_view_marks
