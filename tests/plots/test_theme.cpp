// SPDX-License-Identifier: MIT
// Themes: contrast as WCAG 2.1 defines it, colours for people with a colour vision deficiency, and that every
// ink of a plot comes from its theme.
//
//   L    relative luminance, 0 … 1: Σ weights of linear-light red, green, blue
//   contrast = (L₁ + 0.05) / (L₂ + 0.05), the lighter one first
//   ΔE   distance in CIE L*a*b* (D65); 10 is told apart at a glance
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/plots/figure.h"
#include "app/plots/theme.h"
#include "sim/base/srgb.h"

namespace pabd::test_theme {

namespace {

using Rgb = std::array<double, 3>;

Rgb linear(const Color& c) {
  const auto decode = [](std::uint8_t byte) { return linear_from_srgb(byte / 255.0); };
  return {decode(c.r), decode(c.g), decode(c.b)};
}

double luminance(const Color& c) {
  const Rgb l = linear(c);
  return 0.2126 * l[0] + 0.7152 * l[1] + 0.0722 * l[2];
}

double contrast(const Color& a, const Color& b) {
  const double la = luminance(a) + 0.05, lb = luminance(b) + 0.05;
  return la > lb ? la / lb : lb / la;
}

using Matrix = std::array<Rgb, 3>;
Rgb operator*(const Matrix& m, const Rgb& v) {
  Rgb out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Rgb lab(const Rgb& rgb) {
  constexpr Matrix to_xyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  const Rgb xyz = to_xyz * rgb;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// What people see: everyone, and those without the long, middle or short wave cones (Machado et al. 2009).
constexpr std::array<Matrix, 4> kVision{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

double difference(const Color& a, const Color& b, const Matrix& eye) {
  const auto seen = [&](const Color& c) {
    Rgb v = eye * linear(c);
    for (double& x : v) x = std::clamp(x, 0.0, 1.0);
    return lab(v);
  };
  const Rgb p = seen(a), q = seen(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double hue(const Color& c) {  // degrees
  const Rgb p = lab(linear(c));
  return std::atan2(p[2], p[1]) * 180 / 3.14159265358979;
}

}  // namespace

TEST_CASE("contrast of black on white is 21") {
  CHECK(contrast({0, 0, 0}, {255, 255, 255}) == Approx(21));
  CHECK(contrast({0x77, 0x77, 0x77}, {255, 255, 255}) == Approx(4.48).margin(0.01));  // the well-known grey
}

TEST_CASE("dark theme: text and curves stand out from the panel") {
  const PlotTheme& t = dark_theme();
  CHECK(t.paper == Color{0x1E, 0x23, 0x29, 255});
  CHECK(contrast(t.text, t.paper) > 7);
  for (const Color& ink : {t.muted, t.axis, t.reference}) CHECK(contrast(ink, t.paper) > 4.5);
  for (const Color& curve : t.palette) CHECK(contrast(curve, t.paper) > 4.5);  // also axis labels
}

TEST_CASE("light theme: text stands out from the paper; the inks are those of the printed figures") {
  const PlotTheme& t = light_theme();
  CHECK(contrast(t.text, t.paper) > 7);
  for (const Color& ink : {t.muted, t.axis, t.reference}) CHECK(contrast(ink, t.paper) > 4.5);
  for (int k = -1; k < 2 * kPaletteSize; ++k) CHECK(t.color(k) == palette_color(k));
  CHECK(t.legend == Color{255, 255, 255, 225});
}

TEST_CASE("curves of a theme are told apart with every kind of colour vision") {
  for (const PlotTheme* theme : {&light_theme(), &dark_theme()}) {
    CAPTURE(theme == &dark_theme());
    for (const Matrix& eye : kVision) {
      for (std::size_t i = 0; i < kPaletteSize; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          CAPTURE(i, j);
          CHECK(difference(theme->palette[i], theme->palette[j], eye) > 10);
        }
      }
    }
  }
}

TEST_CASE("a ramp stands out from the paper, more and more, and twelve neighbours are told apart") {
  for (const PlotTheme* theme : {&light_theme(), &dark_theme()}) {
    CAPTURE(theme == &dark_theme());
    CHECK(theme->color(0, 1) == theme->ramp.front());
    CHECK(theme->color(11, 12) == theme->ramp.back());
    CHECK(theme->color(9, 0) == theme->color(9));
    for (int k = 0; k < 12; ++k) {
      CAPTURE(k);
      CHECK(contrast(theme->color(k, 12), theme->paper) > 3);
      if (k == 0) continue;
      CHECK(contrast(theme->color(k, 12), theme->paper) > contrast(theme->color(k - 1, 12), theme->paper));
      for (const Matrix& eye : kVision)
        CHECK(difference(theme->color(k, 12), theme->color(k - 1, 12), eye) > 4);
    }
  }
}

TEST_CASE("both themes have the same hues in the same order") {
  for (int k = 0; k < kPaletteSize - 1; ++k) {  // slate has none
    CAPTURE(k);
    const double turn = std::remainder(hue(light_theme().color(k)) - hue(dark_theme().color(k)), 360.0);
    CHECK(std::abs(turn) < 30);
  }
}

TEST_CASE("a dark figure has no ink of the light theme") {
  Figure figure;
  figure.title = "title";
  figure.caption = "caption";
  Plot plot;
  plot.title = "plot";
  plot.x.label = "across";
  plot.y.label = "up";
  Series line;
  line.name = "line";
  line.x = {-1, 1};
  line.y = {-1, 1};
  Series marks = line;
  marks.style = SeriesStyle::markers;
  Series level = line;
  level.style = SeriesStyle::level;
  plot.series = {line, marks, level};
  figure.plots = {plot, Plot{}};
  const auto hex = [](const Color& c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.r, c.g, c.b);
    return std::string(text);
  };
  const std::string dark = figure_to_svg(figure, 800, 400, dark_theme());
  const std::string light = figure_to_svg(figure, 800, 400);
  const PlotTheme &l = light_theme(), &d = dark_theme();
  for (const Color& ink : {l.text, l.muted, l.axis, l.reference, l.paper, l.color(0), l.color(1)}) {
    CHECK(dark.find(hex(ink)) == std::string::npos);
    CHECK(light.find(hex(ink)) != std::string::npos);
  }
  for (const Color& ink : {d.text, d.muted, d.axis, d.reference, d.paper, d.color(0), d.color(1)}) {
    CHECK(dark.find(hex(ink)) != std::string::npos);
  }
}

}  // namespace pabd::test_theme
