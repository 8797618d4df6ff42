// SPDX-License-Identifier: MIT
// Bodies that others hide are not drawn: those that were seen in the frame before come first, then those that their depths
// do not hide. Nothing that can be seen is left out, wherever bodies and camera jumped to.
#pragma once

#include <optional>

#include "render/device/compute_program.h"
#include "render/device/draw_buffers.h"
#include "render/gl/device_instances.h"

namespace pabd::device {

class DeviceHiding {
 public:
  // In a first picture all count as seen before.
  DeviceHiding(const ComputeFunctions& gl, DrawBuffers& buffers, std::size_t bodies, std::size_t classes);

  // Of bodies or casters. `to_clip`: world to the clip space of `depth`. All else is as the first passes left it.
  void reveal(DeviceList list, const DepthPicture& depth, const Mat4f& to_clip);

 private:
  void find_depths(DeviceList list, const DepthPicture& depth, const Mat4f& to_clip);
  const ComputeProgram& finest(int samples);

  const ComputeFunctions& gl_;
  DrawBuffers& buffers_;
  std::size_t bodies_;
  std::size_t room_ = 0;  // cells
  struct Finest {
    int samples;
    ComputeProgram program;
  };
  std::optional<Finest> finest_[2];  // of one sample, of several
  ComputeProgram coarser_, count_, commands_, emit_;
  GLint level_;
};

}  // namespace pabd::device
