// SPDX-License-Identifier: MIT
// One compute shader, linked, and its dispatch.
#pragma once

#include <span>
#include <string>

#include "render/device/compute_functions.h"
#include "render/gl/shader_stage.h"

namespace pabd {

class ComputeProgram {
 public:
  // The source is "#version 430 core", the `defines` (whole lines), and the parts. Throws Error(no_context).
  ComputeProgram(const ComputeFunctions& gl, const char* name, const std::string& defines,
                 std::span<const ShaderPart> parts);
  ~ComputeProgram();
  ComputeProgram(ComputeProgram&& other) noexcept;
  ComputeProgram& operator=(ComputeProgram&&) = delete;

  GLuint id() const { return id_; }
  void use() const { gl_->UseProgram(id_); }

 private:
  const ComputeFunctions* gl_;
  GLuint id_ = 0;
};

}  // namespace pabd
