// Lines as quads that face the camera, with edges softened over a pixel.
#include "render/gl/line_pass.h"

#include <cstddef>

#include "render/gl/frame_uniforms.h"

namespace pabd {
namespace {

constexpr const char* kVertex = R"(
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 line_color;
layout(location = 3) in float line_width;
flat out vec4 color;
flat out float half_width;
noperspective out float across;
void main() {
  vec4 p = frame.world_to_clip * vec4(a, 1.0);
  vec4 q = frame.world_to_clip * vec4(b, 1.0);
  // An end behind the eye moves along the line to just in front of it.
  float least = 1e-4 * frame.centre.w;
  if (p.w < least && q.w > least) p = mix(q, p, (q.w - least) / (q.w - p.w));
  if (q.w < least && p.w > least) q = mix(p, q, (p.w - least) / (p.w - q.w));
  vec2 size = 0.5 * frame.viewport.xy;
  vec2 along = q.xy / q.w * size - p.xy / p.w * size;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  // Thinner than a pixel: a pixel wide, but fainter.
  float wide = line_width * frame.viewport.z;
  half_width = 0.5 * max(wide, 1.0);
  color = vec4(line_color.rgb, line_color.a * min(wide, 1.0));
  float sign = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  across = sign * (half_width + 0.5);
  vec4 at = (gl_VertexID & 2) == 0 ? p : q;
  gl_Position = vec4(at.xy + side * across / size * at.w, at.zw);
}
)";

constexpr const char* kFragment = R"(
flat in vec4 color;
flat in float half_width;
noperspective in float across;
out vec4 fragment;
void main() { fragment = vec4(color.rgb, color.a * clamp(half_width + 0.5 - abs(across), 0.0, 1.0)); }
)";

}  // namespace

LinePass::LinePass(const GlFunctions& gl)
    : gl_(gl), program_(gl, "lines", {kFrameGlsl, kVertex}, {kFragment}), array_(gl), buffer_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [&](GLuint index, GLint size, std::size_t offset) {
    gl.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(GpuLine),
                           reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(index, 1);
    gl.EnableVertexAttribArray(index);
  };
  attribute(0, 3, offsetof(GpuLine, a));
  attribute(1, 3, offsetof(GpuLine, b));
  attribute(2, 4, offsetof(GpuLine, color));
  attribute(3, 1, offsetof(GpuLine, width));
}

void LinePass::draw(const std::vector<Line>& lines) {
  if (lines.empty()) return;
  packed_.clear();
  GLsizei behind = 0;
  for (const bool on_top : {false, true}) {
    for (const Line& line : lines) {
      if (line.on_top != on_top || !line.a.allFinite() || !line.b.allFinite()) continue;
      GpuLine g{};
      for (int i = 0; i < 3; ++i) {
        g.a[i] = line.a[i];
        g.b[i] = line.b[i];
      }
      for (int i = 0; i < 4; ++i) g.color[i] = line.color[i];
      g.width = line.width;
      packed_.push_back(g);
    }
    if (!on_top) behind = static_cast<GLsizei>(packed_.size());
  }
  const auto total = static_cast<GLsizei>(packed_.size());
  if (total == 0) return;

  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Disable(GL_CULL_FACE);
  gl_.DepthMask(GL_FALSE);
  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  program_.use();
  const auto draw = [&](GLsizei first, GLsizei count, GLenum depth) {
    if (count == 0) return;
    gl_.BufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(static_cast<std::size_t>(count) * sizeof(GpuLine)),
                   packed_.data() + first, GL_STREAM_DRAW);
    gl_.DepthFunc(depth);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
  };
  draw(0, behind, GL_LEQUAL);
  draw(behind, total - behind, GL_ALWAYS);
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_LESS);
  gl_.Enable(GL_CULL_FACE);
  gl_.Disable(GL_BLEND);
}

}  // namespace pabd
