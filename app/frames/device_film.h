// SPDX-License-Identifier: MIT
// Frames of a run that a GPU both simulates and draws, in one OpenGL context: no state is read back.
#pragma once

#include "app/frames/frame_painter.h"
#include "app/frames/frame_source.h"
#include "render/device/device_bodies.h"
#include "render/device/device_solver.h"
#include "render/device/device_sphere.h"

namespace pabd {

class DeviceFilm : public FrameSource {
 public:
  // Whether the GPU can draw all that the pictures show without reading back: opaque bodies, panels that need reports
  // only, glyphs of contacts, from a camera that follows no body.
  static bool shows_all(const Run& run, const OverlayChoice& overlay, const CameraOption& camera);

  // Goes on from where the run is. `context`: of the painter; current in all calls, and outlives this. Precondition:
  // shows_all(). `skipped`, `stepped`: as LiveSource. Throws Error(no_context) when the GPU lacks memory.
  DeviceFilm(GlContext& context, const Run& start, const FrameRange& range, bool contacts,
             LiveSource::Skipped skipped = {}, Stepped stepped = {});

  // Views of these frames have a time but no bodies; bodies() has them until the next frame is asked for.
  std::optional<Frame> next(const Stop& stop) override;
  BodiesOnDevice bodies();

  // The step that diverged, if any.
  const std::optional<StepSummary>& diverged() const { return diverged_; }

 private:
  DeviceFilm(GlContext& context, const Run& start, const FrameRange& range, bool contacts,
             LiveSource::Skipped skipped, Stepped stepped, const BodyParts& parts);
  bool advance_to(std::int64_t step, const Stop& stop);

  FrameView view_;  // of the last frame
  State now_;       // a step and a time
  const FrameRange range_;
  const bool contacts_;
  const LiveSource::Skipped skipped_;
  const Stepped stepped_;
  const std::int64_t first_step_;
  int next_ = 0;
  ReportList reports_;
  std::optional<StepSummary> diverged_;
  DeviceSolver solver_;
  DeviceBodies bodies_;
  DeviceSphere sphere_;
};

}  // namespace pabd
