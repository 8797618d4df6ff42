// SPDX-License-Identifier: MIT
// Pictures of stored states: what is drawn does not depend on the solver, so that a change of it does not
// break them. Contacts come from the geometry at the state, curves from formulas.
#pragma once

#include <string>

#include "app/overlay/overlay.h"
#include "render/context/context.h"
#include "render/gl/renderer.h"
#include "render/visual/build_visual.h"
#include "sim/scene/scene.h"

namespace pabd {

// The initial state of a shipped scene with the report of an invented step.
struct StoredStep {
  explicit StoredStep(const std::string& scene_name);
  Scene scene;
  StepReport report;  // contacts of the state, and the records of a solve that halves its error
  std::vector<StepSummary> history;  // two seconds of a damped bounce
};

class Studio {
 public:
  Studio(int width, int height);

  Image frame(const VisualScene& scene, const OverlayOptions& panels = {}, const OverlayData& data = {});
  Image panels(const Picture& picture);  // as a window paints them
  std::string gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  Image read();

  int width_, height_;
  std::vector<ContextAttempt> attempts_;
  std::unique_ptr<GlContext> context_;
  Renderer renderer_;
  Overlay overlay_;
};

FrameView view_of(const StoredStep& stored);
VisualScene visual_of(const StoredStep& stored, bool contacts_and_bonds);
// `view` must live as long as the result.
OverlayData overlay_of(const StoredStep& stored, const FrameView& view);

// Records of a solve: E falls by half each iteration, the penetration settles at 1 mm.
std::vector<IterationRecord> invented_records(int count, double rate);

}  // namespace pabd
