// SPDX-License-Identifier: MIT
// See compute_program.h.
#include "render/device/compute_program.h"

#include <array>
#include <utility>
#include <vector>

namespace pabd {

ComputeProgram::ComputeProgram(const ComputeFunctions& gl, const char* name, const std::string& defines,
                               std::span<const ShaderPart> parts)
    : gl_(&gl) {
  std::vector<ShaderPart> all = {{"header", "#version 430 core\n"}, {"defines", defines.c_str()}};
  all.insert(all.end(), parts.begin(), parts.end());
  id_ = link_stages(gl, name, std::array{compile_stage(gl, name, GL_COMPUTE_SHADER, all)});
}

ComputeProgram::~ComputeProgram() {
  if (id_ != 0) gl_->DeleteProgram(id_);
}

ComputeProgram::ComputeProgram(ComputeProgram&& other) noexcept
    : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}

}  // namespace pabd
