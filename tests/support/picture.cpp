// SPDX-License-Identifier: MIT
// A small picture of boxes, shadows and lines, computed ray by ray on the CPU.
#include "tests/support/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pabd {
namespace {

using Vec = std::array<double, 3>;
constexpr double degree = 3.14159265358979323846 / 180;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec unit(const Vec& a) { return (1 / std::sqrt(dot(a, a))) * a; }

// Turned about the vertical axis.
Vec turned(const Vec& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] + s * v[2], v[1], -s * v[0] + c * v[2]};
}

struct Box {
  Vec center, half, color;
  double angle = 0;
  bool casts_shadow = true;
};

struct Hit {
  double t = std::numeric_limits<double>::infinity();
  Vec normal{};
  Vec color{};
};

void hit_box(const Box& box, const Vec& from, const Vec& along, Hit& hit) {
  const Vec o = turned(from - box.center, -box.angle), d = turned(along, -box.angle);
  double enter = 1e-6, leave = hit.t;
  Vec normal{};
  for (std::size_t i = 0; i < 3; ++i) {
    double t0 = (-box.half[i] - o[i]) / d[i], t1 = (box.half[i] - o[i]) / d[i];
    const double side = t0 > t1 ? 1 : -1;
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > enter) {
      enter = t0;
      normal = {};
      normal[i] = side;
    }
    leave = std::min(leave, t1);
  }
  if (enter >= leave || dot(normal, normal) == 0) return;
  hit = {enter, turned(normal, box.angle), box.color};
}

std::vector<Box> boxes_of(const PictureOptions& o) {
  const double a = o.albedo;
  std::vector<Box> boxes = {
      {{-1.3, 0.6, 0}, {0.6, 0.6, 0.6}, a * Vec{0.83, 0.37, 0.20}, 20 * degree + o.turn * degree},
      {{0.2, 0.6, -0.9}, {0.6, 0.6, 0.6}, a * Vec{0.25, 0.55, 0.75}, 55 * degree},
      {{0.1, 1.6, -0.8}, {0.4, 0.4, 0.4}, a * Vec{0.90, 0.75, 0.30}, 10 * degree},
      {{1.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, a * Vec{0.45, 0.65, 0.35}, 35 * degree}};
  if (o.small_box) {
    boxes.push_back({{0.3, 0.12, 1.4}, {0.12, 0.12, 0.12}, a * Vec{0.8, 0.8, 0.8}, 30 * degree, o.shadow});
  }
  return boxes;
}

Vec light_at(const std::vector<Box>& boxes, const Vec& from, const Vec& along) {
  static const Vec sun = unit({0.5, 1.0, 0.7});
  Hit hit;
  for (const Box& box : boxes) hit_box(box, from, along, hit);
  const double ground = -from[1] / along[1];
  if (ground > 0 && ground < hit.t) {
    const Vec p = from + ground * along;
    const bool dark = (static_cast<long>(std::floor(p[0])) + static_cast<long>(std::floor(p[2]))) % 2 != 0;
    hit = {ground, {0, 1, 0}, dark ? Vec{0.55, 0.56, 0.58} : Vec{0.62, 0.63, 0.65}};
  }
  if (!std::isfinite(hit.t)) return Vec{0.70, 0.80, 0.92} + along[1] * Vec{-0.5, -0.4, -0.2};
  const Vec at = from + hit.t * along + 1e-4 * hit.normal;
  Hit between;
  for (const Box& box : boxes) {
    if (box.casts_shadow) hit_box(box, at, sun, between);
  }
  const double direct = std::isfinite(between.t) ? 0 : std::max(0.0, dot(hit.normal, sun));
  return (0.35 + 0.65 * direct) * hit.color;
}

// Where in a pixel it is looked at, 0 … 1.
std::vector<std::array<double, 2>> samples_of(int kind) {
  if (kind == 0) return {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  if (kind == 1) return {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
  std::vector<std::array<double, 2>> grid;
  for (int i = 0; i < 9; ++i) grid.push_back({(i % 3 + 0.5) / 3, (i / 3 + 0.5) / 3});
  return grid;
}

bool on_line(double x, double y, const PictureOptions& o) {
  const double x0 = 0.08 * o.width, y0 = 0.2 * o.height, x1 = 0.9 * o.width, y1 = 0.34 * o.height;
  const double dx = x1 - x0, dy = y1 - y0;
  const double t = std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - x0 - t * dx, y - y0 - t * dy) < 0.75;
}

}  // namespace

Image draw_picture(const PictureOptions& options) {
  const std::vector<Box> boxes = boxes_of(options);
  const auto samples = samples_of(options.samples);
  const Vec eye = {1.6, 2.6, 5.0};
  const Vec back = unit(eye - Vec{0, 0.5, 0});
  const Vec right = unit({back[2], 0, -back[0]});
  const Vec up = {back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
                  back[0] * right[1] - back[1] * right[0]};
  const double scale = std::tan(22 * degree) * 2 / options.height;
  Image image;
  image.resize(options.width, options.height);
  std::size_t at = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      Vec sum{};
      for (const auto& [sx, sy] : samples) {
        if (options.line && on_line(x + sx, y + sy, options)) {
          sum = sum + Vec{0.1, 0.1, 0.12};
          continue;
        }
        const double u = (x + sx - 0.5 * options.width) * scale, v = (0.5 * options.height - y - sy) * scale;
        sum = sum + light_at(boxes, eye, unit(u * right + v * up - back));
      }
      for (double value : sum) {
        const double light = std::clamp(value / static_cast<double>(samples.size()), 0.0, 1.0);
        image.rgb[at++] = static_cast<std::uint8_t>(std::lround(255 * std::pow(light, 1 / 2.2)));
      }
    }
  }
  return image;
}

Image moved(const Image& image, int dx, int dy) {
  Image result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int fx = std::clamp(x - dx, 0, image.width - 1), fy = std::clamp(y - dy, 0, image.height - 1);
      const auto from = image.rgb.begin() + 3L * (static_cast<long>(fy) * image.width + fx);
      std::copy(from, from + 3, result.rgb.begin() + 3L * (static_cast<long>(y) * image.width + x));
    }
  }
  return result;
}

Image test_frame(int width, int height, int seed) {
  Image image;
  image.resize(width, height);
  std::uint32_t state = static_cast<std::uint32_t>(seed) * 2654435761u + 1;
  std::size_t at = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      state = state * 1664525u + 1013904223u;
      const int noise = static_cast<int>(state >> 29);
      image.rgb[at++] = static_cast<std::uint8_t>((x * 200 / width + noise + 5 * seed) % 256);
      image.rgb[at++] = static_cast<std::uint8_t>((y * 200 / height + noise) % 256);
      image.rgb[at++] = static_cast<std::uint8_t>(((x + y) / 2 + 9 * seed) % 256);
    }
  }
  return image;
}

}  // namespace pabd
