// SPDX-License-Identifier: MIT
// See device_hiding.h.
#include "render/device/device_hiding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/device/draw_programs.h"
#include "render/device/shader_files.h"

namespace pabd::device {
namespace {

constexpr unsigned kUnit = 5;   // of textures: nobody else's
constexpr unsigned kLists = 2;  // whose bodies hide each other: bodies, casters

ComputeProgram reveals(const ComputeFunctions& gl, const char* name, std::size_t classes, const char* define,
                       const ShaderPart& main) {
  return compile_draw_program(gl, name, classes, std::string("#define REVEAL\n") + define,
                              std::array{shaders::device_draw_depths, main});
}

}  // namespace

DeviceHiding::DeviceHiding(const ComputeFunctions& gl, DrawBuffers& buffers, std::size_t bodies,
                           std::size_t classes)
    : gl_(gl),
      buffers_(buffers),
      bodies_(bodies),
      coarser_(
          compile_draw_program(gl, "coarser depths", classes, "",
                               std::array{shaders::device_draw_depths, shaders::device_draw_depths_comp})),
      count_(reveals(gl, "bodies to reveal", classes, "", shaders::device_draw_make_comp)),
      commands_(reveals(gl, "commands of revealed ones", classes, "", shaders::device_draw_commands_comp)),
      emit_(reveals(gl, "revealed instances", classes, "#define EMIT\n", shaders::device_draw_make_comp)),
      level_(gl.GetUniformLocation(coarser_.id(), "level")) {
  const std::vector<std::uint32_t> all_seen(4 + bodies, (1u << kLists) - 1);
  buffers.make(DrawSlot::seen, all_seen.size() * sizeof(all_seen[0]), all_seen.data());
}

const ComputeProgram& DeviceHiding::finest(int samples) {
  std::optional<Finest>& known = finest_[samples > 1 ? 1 : 0];
  if (!known || known->samples != samples) {
    const std::string defines = fmt::format("#define FINEST\n#define SAMPLES {}\n#define PICTURE_UNIT {}\n{}",
                                            samples, kUnit, samples > 1 ? "#define SEVERAL\n" : "");
    known.reset();
    known.emplace(Finest{samples, compile_draw_program(gl_, "finest depths", 0, defines,
                                                       std::array{shaders::device_draw_depths,
                                                                  shaders::device_draw_depths_comp})});
  }
  return known->program;
}

void DeviceHiding::find_depths(DeviceList list, const DepthPicture& depth, const Mat4f& to_clip) {
  DrawDepths head{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) head.to_clip[row][column] = to_clip(row, column);
  }
  const unsigned size[2] = {static_cast<unsigned>(depth.width), static_cast<unsigned>(depth.height)};
  for (int axis = 0; axis < 2; ++axis) {
    head.picture_size[axis] = size[axis];
    head.cells[axis] = (size[axis] + kDepthCell - 1) / kDepthCell;
  }
  head.list = static_cast<std::uint32_t>(list);
  const auto cells_of = [&](unsigned level) {
    const auto along = [&](int axis) { return (head.cells[axis] + (1u << level) - 1) >> level; };
    return std::size_t{along(0)} * along(1);
  };
  std::size_t cells = cells_of(0);
  unsigned levels = 1;
  for (; cells_of(levels - 1) > 1; ++levels) cells += cells_of(levels);
  if (cells > room_) {
    buffers_.make(DrawSlot::depths, sizeof(DrawDepths) + cells * sizeof(float));
    room_ = cells;
  }
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers_.id(DrawSlot::depths));
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof head, &head);
  buffers_.bind();

  const GLenum kind = depth.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);  // nobody reads what is drawn into
  gl_.ActiveTexture(GL_TEXTURE0 + kUnit);
  gl_.BindTexture(kind, depth.texture);
  run_draw_program(gl_, finest(depth.samples), cells_of(0));
  gl_.BindTexture(kind, 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  for (unsigned level = 1; level < levels; ++level) {
    coarser_.use();
    gl_.Uniform1ui(level_, level);
    run_draw_program(gl_, coarser_, cells_of(level));
  }
}

void DeviceHiding::reveal(DeviceList list, const DepthPicture& depth, const Mat4f& to_clip) {
  find_depths(list, depth, to_clip);
  buffers_.clear(DrawSlot::counts);
  run_draw_program(gl_, count_, bodies_);
  run_draw_program(gl_, commands_, 1);
  run_draw_program(gl_, emit_, bodies_);
  gl_.MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

}  // namespace pabd::device
