// SPDX-License-Identifier: MIT
// See glyph_shapes.h. In the space of the mesh, where round things have radius 1:
//
//   v          towards the eye; v⊥ its part across the axis
//   φ          angle from v⊥ about the axis
//   outline    of a cylinder at cos φ = 0, of a cone at cos φ = −v_y/|v⊥|
//
// Between the outlines goes the side that is seen, where its end is hardly seen as two triangles or strips.
#include "render/gl/glyph_shapes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace pabd {
namespace {

constexpr float kLargestBall = 120;  // pixels across; software GL draws points twice as large

// Hardly two glyphs side by side share it. 0 is the floor and what is behind it.
float tag_of(const Mat4f& m) {
  std::uint32_t h = std::bit_cast<std::uint32_t>(m(0, 3)) * 0x8da6b343u ^
                    std::bit_cast<std::uint32_t>(m(1, 3)) * 0xd8163841u ^
                    std::bit_cast<std::uint32_t>(m(2, 3)) * 0xcb1ab31fu;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  return static_cast<float>(1 + (h >> 17)) / 65535;
}

}  // namespace

// The triangles of one instance.
struct GlyphShapes::Outline {
  GlyphShapes& shapes;
  const Mat4f& m;
  GlyphVertex next;
  std::vector<std::uint32_t>& indices;

  std::uint32_t vertex(float x, float y, float z) {
    const Vec3f p = m.block<3, 3>(0, 0) * Vec3f(x, y, z) + m.block<3, 1>(0, 3);
    for (int i = 0; i < 3; ++i) next.position[i] = p[i];
    shapes.vertices.push_back(next);
    return static_cast<std::uint32_t>(shapes.vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices.insert(indices.end(), {a, b, c});
  }
  void circle(float y, const std::vector<Eigen::Vector2f>& corners) {
    std::uint32_t first = 0, last = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t here = vertex(corners[k].x(), y, corners[k].y());
      if (k == 0) first = here;
      if (k > 1) triangle(first, last, here);
      last = here;
    }
  }
};

GlyphShapes::GlyphShapes() {
  for (std::size_t level = 0; level < circles_.size(); ++level) {
    for (int i = 0; i < kSegments[level]; ++i) {
      const double a = 2 * std::numbers::pi * i / kSegments[level];
      circles_[level].emplace_back(static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)));
    }
  }
}

void GlyphShapes::begin(const FrameUniforms& frame, float tolerance) {
  vertices.clear();
  discs.clear();
  cylinders.clear();
  cones.clear();
  balls.clear();
  std::memcpy(clip_.data(), frame.world_to_clip, sizeof(frame.world_to_clip));
  eye_ = Vec3f(frame.eye[0], frame.eye[1], frame.eye[2]);
  tolerance_ = tolerance;
}

bool GlyphShapes::add(const Instance& instance, Primitive primitive, int level, float pixels) {
  if (primitive == Primitive::sphere) return instance.shaded && add_ball(instance, pixels);
  const bool flat = primitive == Primitive::disc, pointed = primitive == Primitive::cone;
  if (instance.shaded || (!flat && !pointed && primitive != Primitive::cylinder)) return false;
  const Mat4f& m = instance.transform;
  const auto& corners = circles_[static_cast<std::size_t>(level)];
  Outline outline{*this, m, {}, flat ? discs : pointed ? cones : cylinders};
  for (int i = 0; i < 4; ++i) outline.next.color[i] = instance.color[i];
  outline.next.tag = tag_of(m);
  if (flat) {
    outline.circle(0, corners);
    return true;
  }
  // Columns of the matrix are orthogonal.
  const Eigen::Array3f squares = m.block<3, 3>(0, 0).colwise().squaredNorm().transpose();
  const Vec3f away = eye_ - m.block<3, 1>(0, 3);
  const Vec3f v = ((m.block<3, 3>(0, 0).transpose() * away).array() / squares.max(1e-24f)).matrix();
  const float across = std::hypot(v.x(), v.z());
  const Eigen::Vector2f front =
      across > 1e-12f ? Eigen::Vector2f(v.x() / across, v.z() / across) : Eigen::Vector2f(1, 0);
  const Eigen::Vector2f side(-front.y(), front.x());
  const float cosine = pointed ? -v.y() / std::max(across, 1e-12f) : 0;
  const float turn = std::acos(std::clamp(cosine, -1.0f, 1.0f));  // φ of the outline
  // The end is an ellipse, half as high in pixels: hardly seen it is as good as a straight edge, or as four corners.
  const float ahead = std::abs(v.y()) * std::sqrt(squares.y()) / std::max(away.norm(), 1e-24f);
  const float height = ahead * std::sqrt(std::max(squares.x(), squares.z())) * pixels;
  const bool open = height > tolerance_, round = height > 3 * tolerance_;
  const auto corner = [&](float angle, float y) {
    const Eigen::Vector2f at = std::cos(angle) * front + std::sin(angle) * side;
    return outline.vertex(at.x(), y, at.y());
  };
  const auto steps = [&](float angle) {
    const float parts = angle / (2 * std::numbers::pi_v<float>)*static_cast<float>(kSegments[level]);
    return round ? std::max(2, static_cast<int>(std::ceil(parts - 1e-3f))) : 2;
  };
  const int near = turn > 1e-3f ? steps(2 * turn) : 0;
  const std::uint32_t tip = pointed ? outline.vertex(0, 1, 0) : 0;
  std::uint32_t below = 0, above = 0;
  for (int k = 0; k <= near && near > 0; ++k) {
    const float angle = turn * (2 * static_cast<float>(k) / static_cast<float>(near) - 1);
    const std::uint32_t low = corner(angle, pointed ? 0 : -1), high = pointed ? tip : corner(angle, 1);
    if (k > 0) outline.triangle(below, low, high);
    if (k > 0 && !pointed) outline.triangle(above, below, high);
    below = low;
    above = high;
  }
  if (!open || (pointed && v.y() > 0)) return true;
  // The end that faces the eye, with the corners that it shares with the side.
  const float y = pointed ? 0 : v.y() > 0 ? 1 : -1;
  const float rest = 2 * (std::numbers::pi_v<float> - turn);
  const int far = steps(rest);
  std::uint32_t first = 0, last = 0;
  for (int k = 0; k < near + far; ++k) {
    const float angle = k < near ? turn * (2 * static_cast<float>(k) / static_cast<float>(near) - 1)
                                 : turn + rest * static_cast<float>(k - near) / static_cast<float>(far);
    const std::uint32_t here = corner(angle, y);
    if (k == 0) first = here;
    if (k > 1) outline.triangle(first, last, here);
    last = here;
  }
  return true;
}

bool GlyphShapes::add_ball(const Instance& instance, float pixels) {
  const Mat4f& m = instance.transform;
  const float radius = m.block<3, 1>(0, 0).norm();
  const Vec4f centre = clip_ * m.col(3);
  const bool seen = centre.head<3>().cwiseAbs().maxCoeff() < centre.w();  // GL cuts points by their middle
  if (!seen || 2 * radius * pixels > kLargestBall) return false;
  GlyphBall ball{};
  for (int i = 0; i < 3; ++i) ball.centre[i] = m(i, 3);
  ball.radius = radius;
  for (int i = 0; i < 4; ++i) ball.color[i] = instance.color[i];
  ball.tag = tag_of(m);
  balls.push_back(ball);
  return true;
}

}  // namespace pabd
