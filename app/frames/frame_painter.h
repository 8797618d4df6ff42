// Second stage of the render pipeline: turns what a frame shows into pixels.
#pragma once

#include <string>

#include "app/frames/camera_option.h"
#include "app/frames/frame_producer.h"
#include "app/overlay/overlay.h"
#include "render/gl/renderer.h"
#include "render/visual/build_visual.h"

namespace pabd {

// What --overlay asked for.
struct OverlayChoice {
  OverlayOptions panels;
  bool bonds = false;
  bool contacts = false;  // with the legend of their colours

  bool needs_iterations() const { return panels.convergence; }
  bool needs_contacts() const { return bonds || contacts || panels.barrier; }
};

// Comma-separated names of panels, "bonds", "contacts", "plots", "all" or "none". Throws Error(bad_input).
OverlayChoice parse_overlay(const std::string& text);

class FramePainter {
 public:
  // `context` is current and outlives this; `session` is only asked for what never changes.
  FramePainter(GlContext& context, const Session& session, int width, int height,
               const OverlayChoice& overlay, const CameraOption& camera);

  void draw(const FramePacket& packet);  // and starts copying it back
  int queued() const { return renderer_.queued(); }
  void fetch(Image& out);  // the oldest frame that was drawn; precondition: queued() > 0
  std::string gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  const Session& session_;
  int width_, height_;
  Renderer renderer_;
  Overlay overlay_;
  OverlayChoice choice_;
  VisualOptions visual_options_;
  CameraOption camera_option_;
  Camera base_camera_;
  double start_time_;  // s
  OverlayData data_;   // what all frames have in common
  VisualScene visual_;
  History history_;
};

}  // namespace pabd
