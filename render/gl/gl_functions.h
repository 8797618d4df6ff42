// SPDX-License-Identifier: MIT
// The GL 3.3 core entry points in use, looked up through the context. A table instead of a loader library:
// the same code reaches EGL, OSMesa and a window.
#pragma once

#include <GL/glcorearb.h>

#include <string>

#include "render/context/context.h"

// clang-format off
#define PABD_GL_FUNCTIONS(X) \
  X(ActiveTexture, ACTIVETEXTURE) X(AttachShader, ATTACHSHADER) X(BindBuffer, BINDBUFFER) \
  X(BindBufferBase, BINDBUFFERBASE) X(BindFramebuffer, BINDFRAMEBUFFER) X(BindRenderbuffer, BINDRENDERBUFFER) \
  X(BindTexture, BINDTEXTURE) X(BindVertexArray, BINDVERTEXARRAY) X(BlendFunc, BLENDFUNC) \
  X(BlendFuncSeparate, BLENDFUNCSEPARATE) X(BlitFramebuffer, BLITFRAMEBUFFER) X(BufferData, BUFFERDATA) \
  X(BufferSubData, BUFFERSUBDATA) X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) X(Clear, CLEAR) \
  X(ClearColor, CLEARCOLOR) X(ColorMask, COLORMASK) X(CompileShader, COMPILESHADER) X(CreateProgram, CREATEPROGRAM) \
  X(CreateShader, CREATESHADER) X(CullFace, CULLFACE) X(DeleteBuffers, DELETEBUFFERS) \
  X(DeleteFramebuffers, DELETEFRAMEBUFFERS) X(DeleteProgram, DELETEPROGRAM) \
  X(DeleteRenderbuffers, DELETERENDERBUFFERS) X(DeleteShader, DELETESHADER) X(DeleteTextures, DELETETEXTURES) \
  X(DeleteVertexArrays, DELETEVERTEXARRAYS) X(DepthFunc, DEPTHFUNC) X(DepthMask, DEPTHMASK) X(Disable, DISABLE) \
  X(DrawArrays, DRAWARRAYS) X(DrawArraysInstanced, DRAWARRAYSINSTANCED) X(DrawBuffer, DRAWBUFFER) \
  X(DrawElementsBaseVertex, DRAWELEMENTSBASEVERTEX) X(DrawElementsInstanced, DRAWELEMENTSINSTANCED) \
  X(Enable, ENABLE) X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) X(Finish, FINISH) X(Flush, FLUSH) \
  X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER) X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) \
  X(GenBuffers, GENBUFFERS) X(GenFramebuffers, GENFRAMEBUFFERS) X(GenRenderbuffers, GENRENDERBUFFERS) \
  X(GenTextures, GENTEXTURES) X(GenVertexArrays, GENVERTEXARRAYS) \
  X(GetActiveUniformBlockiv, GETACTIVEUNIFORMBLOCKIV) X(GetActiveUniformsiv, GETACTIVEUNIFORMSIV) \
  X(GetError, GETERROR) X(GetIntegerv, GETINTEGERV) \
  X(GetProgramInfoLog, GETPROGRAMINFOLOG) X(GetProgramiv, GETPROGRAMIV) X(GetShaderInfoLog, GETSHADERINFOLOG) \
  X(GetShaderiv, GETSHADERIV) X(GetString, GETSTRING) X(GetUniformBlockIndex, GETUNIFORMBLOCKINDEX) \
  X(GetUniformIndices, GETUNIFORMINDICES) \
  X(GetUniformLocation, GETUNIFORMLOCATION) X(LinkProgram, LINKPROGRAM) X(MapBufferRange, MAPBUFFERRANGE) \
  X(PixelStorei, PIXELSTOREI) X(PolygonOffset, POLYGONOFFSET) X(ReadBuffer, READBUFFER) X(ReadPixels, READPIXELS) \
  X(RenderbufferStorage, RENDERBUFFERSTORAGE) \
  X(Scissor, SCISSOR) X(ShaderSource, SHADERSOURCE) X(TexImage2D, TEXIMAGE2D) \
  X(TexImage2DMultisample, TEXIMAGE2DMULTISAMPLE) X(TexParameteri, TEXPARAMETERI) X(TexSubImage2D, TEXSUBIMAGE2D) \
  X(Uniform1f, UNIFORM1F) X(Uniform1i, UNIFORM1I) X(Uniform2f, UNIFORM2F) X(Uniform4f, UNIFORM4F) \
  X(UniformBlockBinding, UNIFORMBLOCKBINDING) X(UnmapBuffer, UNMAPBUFFER) X(UseProgram, USEPROGRAM) \
  X(VertexAttribDivisor, VERTEXATTRIBDIVISOR) X(VertexAttribPointer, VERTEXATTRIBPOINTER) X(Viewport, VIEWPORT)
// clang-format on

namespace pabd {

// How triangles are drawn. Every pass sets all of it and relies on nothing that another left.
struct DrawState {
  bool depth_test = true;
  GLenum depth = GL_LESS;
  bool write_depth = true;
  bool cull = true;    // back faces
  bool blend = false;  // with the blend function that the pass sets
};

struct GlFunctions {
  // Throws Error(no_context) naming the first function that the driver lacks.
  explicit GlFunctions(GlContext& context);

#define PABD_DECLARE(entry, type) PFNGL##type##PROC entry = nullptr;
  PABD_GL_FUNCTIONS(PABD_DECLARE)
#undef PABD_DECLARE

  std::string string(GLenum name) const;  // glGetString, never null
  GLint integer(GLenum name) const;

  void set(const DrawState& state) const;

  void forget_errors() const;  // of what was done before
  // Throws Error(no_context) with the error's name if one is pending. `doing` says what was being done.
  void check(const char* doing) const;
};

// "GL_INVALID_ENUM", …
const char* gl_error_name(GLenum error);

}  // namespace pabd
