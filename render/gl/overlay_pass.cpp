// SPDX-License-Identifier: MIT
// The one pass that draws Dear ImGui's lists.
#include "render/gl/overlay_pass.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "render/gl/shader_files.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

GLuint name_of(void* id) { return static_cast<GLuint>(reinterpret_cast<std::intptr_t>(id)); }
void* id_of(const GlTexture& texture) {
  return reinterpret_cast<void*>(static_cast<std::intptr_t>(texture.id()));
}

void load(const GlFunctions& gl, const GlTexture& texture, GLenum format, const unsigned char* bytes,
          int width, int height) {
  gl.ActiveTexture(GL_TEXTURE0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  make_texture(gl, texture, GL_RGBA8, width, height, format, GL_UNSIGNED_BYTE, GL_LINEAR, bytes);
}

}  // namespace

OverlayPass::OverlayPass(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "overlay", {shaders::overlay_vert}, {shaders::overlay_frag}),
      scale_(program_.uniform("scale")),
      shift_(program_.uniform("shift")),
      array_(gl),
      vertices_(gl),
      indices_(gl) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  const auto attribute = [&](GLuint index, GLint size, GLenum type, GLboolean normalized,
                             std::size_t offset) {
    gl.VertexAttribPointer(index, size, type, normalized, sizeof(ImDrawVert),
                           reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(index);
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  program_.use();
  gl.Uniform1i(program_.uniform("image"), 0);
}

void* OverlayPass::upload_font_atlas(const unsigned char* rgba, int width, int height) {
  atlas_.emplace(gl_);
  load(gl_, *atlas_, GL_RGBA, rgba, width, height);
  gl_.check("uploading the font");
  return id_of(*atlas_);
}

void* OverlayPass::upload_texture(const unsigned char* rgb, int width, int height) {
  const GLint limit = gl_.integer(GL_MAX_TEXTURE_SIZE);
  if (width < 1 || height < 1 || width > limit || height > limit) {
    throw Error(ErrorKind::bad_input, "a texture of " + std::to_string(width) + "x" + std::to_string(height) +
                                          " pixels: expected sides from 1 to " + std::to_string(limit) +
                                          "; use a smaller picture");
  }
  GlTexture texture(gl_);
  load(gl_, texture, GL_RGB, rgb, width, height);
  gl_.check("uploading a picture");
  void* const id = id_of(texture);
  textures_.emplace(name_of(id), std::move(texture));
  return id;
}

void OverlayPass::free_texture(void* id) {
  if (textures_.erase(name_of(id)) == 0)
    throw Error(ErrorKind::defect, "a texture was freed that is not there; free each id once");
}

bool OverlayPass::knows(void* id) const {
  return (atlas_ && id == id_of(*atlas_)) || textures_.contains(name_of(id));
}

void OverlayPass::draw(const ImDrawData& data, int width, int height) const {
  if (data.CmdListsCount == 0 || data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  for (int l = 0; l < data.CmdListsCount; ++l) {
    for (const ImDrawCmd& command : data.CmdLists[l]->CmdBuffer) {
      if (command.UserCallback == nullptr && command.ElemCount > 0 && !knows(command.GetTexID())) {
        throw Error(ErrorKind::defect,
                    "the overlay names a texture that is not there; upload it before the frame "
                    "and free it after");
      }
    }
  }
  gl_.set({.depth_test = false, .cull = false, .blend = true});
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(array_.id());
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  program_.use();
  // Display coordinates, y down, to clip space.
  const float sx = 2 / data.DisplaySize.x;
  const float sy = -2 / data.DisplaySize.y;
  gl_.Uniform2f(scale_, sx, sy);
  gl_.Uniform2f(shift_, -1 - data.DisplayPos.x * sx, 1 - data.DisplayPos.y * sy);

  const float px = static_cast<float>(width) / data.DisplaySize.x;
  const float py = static_cast<float>(height) / data.DisplaySize.y;
  for (int l = 0; l < data.CmdListsCount; ++l) {
    const ImDrawList& list = *data.CmdLists[l];
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.VtxBuffer.size_in_bytes()),
                   list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.IdxBuffer.size_in_bytes()),
                   list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(&list, &command);
        continue;
      }
      const auto clip = [](float v, float limit) {
        return static_cast<int>(std::lround(std::clamp(v, 0.0f, limit)));
      };
      const int x0 = clip((command.ClipRect.x - data.DisplayPos.x) * px, static_cast<float>(width));
      const int x1 = clip((command.ClipRect.z - data.DisplayPos.x) * px, static_cast<float>(width));
      const int y0 = clip((command.ClipRect.y - data.DisplayPos.y) * py, static_cast<float>(height));
      const int y1 = clip((command.ClipRect.w - data.DisplayPos.y) * py, static_cast<float>(height));
      if (x1 <= x0 || y1 <= y0) continue;
      gl_.Scissor(x0, height - y1, x1 - x0, y1 - y0);
      gl_.BindTexture(GL_TEXTURE_2D, name_of(command.GetTexID()));
      gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                                 reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                 static_cast<GLint>(command.VtxOffset));
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace pabd
