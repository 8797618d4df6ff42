// SPDX-License-Identifier: MIT
// Bodies drawn from the memory of the GPU that moves them, without reading the state back.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/workbench/snapshot.h"
#include "render/context/context.h"
#include "render/gl/device_instances.h"
#include "render/gl/quality.h"
#include "render/gl/renderer.h"

namespace pabd {

class DevicePicture {
 public:
  // `context` is current in all calls, and outlives this.
  explicit DevicePicture(GlContext& context);
  ~DevicePicture();
  DevicePicture(const DevicePicture&) = delete;
  DevicePicture& operator=(const DevicePicture&) = delete;

  // Whether it can draw the bodies of the run, as far as it is known before.
  bool can_draw(const RunView& run) const;

  // The run's bodies and floor into the renderer's first view; `visual` has the camera and the theme. Precondition:
  // run.poses is not null. False where the GPU cannot; can_draw() is false from then on, and failure() says why.
  bool draw(const RunView& run, VisualScene& visual, int width, int height, const RenderQuality& quality,
            Renderer& renderer);

  const std::string& failure() const;  // empty: none

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
