// SPDX-License-Identifier: MIT
// Glyphs as what is seen of them: balls as points whose shader finds the sphere, discs, cylinders and cones of one colour
// as the few triangles within their outlines. Plain numbers, no GL. For software GL, which takes longer over the
// hundreds of small triangles of a mesh than over the pixels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/gl/frame_uniforms.h"
#include "render/visual/primitive_mesh.h"

namespace pabd {

struct GlyphVertex {
  float position[3];
  float color[4];
  float tag;  // as surface.vert.glsl makes one
};

struct GlyphBall {
  float centre[3];
  float radius;
  float color[4];
  float tag;
};

// Keeps its memory from frame to frame.
class GlyphShapes {
 public:
  GlyphShapes();

  // Nothing, for a frame of these uniforms.
  void begin(const FrameUniforms& frame, float tolerance);
  // Takes an opaque instance; false: its mesh must be drawn. `level`: of detail; `pixels`: of a metre where it is.
  bool add(const Instance& instance, Primitive primitive, int level, float pixels);

  bool empty() const { return vertices.empty() && balls.empty(); }

  std::vector<GlyphVertex> vertices;
  std::vector<std::uint32_t> discs, cylinders, cones;  // vertices, three a triangle; both windings
  std::vector<GlyphBall> balls;

 private:
  struct Outline;
  bool add_ball(const Instance& instance, float pixels);

  std::array<std::vector<Eigen::Vector2f>, kLevels> circles_;  // corners; x and z of the meshes
  Mat4f clip_ = Mat4f::Identity();
  Vec3f eye_{0, 0, 0};
  float tolerance_ = 0;
};

}  // namespace pabd
