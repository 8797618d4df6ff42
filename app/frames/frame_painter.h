// SPDX-License-Identifier: MIT
// Turns what a frame shows of a run into pixels.
#pragma once

#include <memory>
#include <string>

#include "app/frames/camera_option.h"
#include "app/overlay/overlay.h"
#include "app/session/frame_view.h"
#include "render/gl/renderer.h"
#include "render/visual/build_visual.h"
#include "sim/scene/scene.h"

namespace pabd {

// What --overlay asked for.
struct OverlayChoice {
  OverlayOptions panels;
  bool bonds = false;
  bool contacts = false;  // with the legend of their colours

  bool needs_iterations() const { return panels.needing(&OverlayPanel::iterations) != nullptr; }
  bool needs_contacts() const {
    return bonds || contacts || panels.needing(&OverlayPanel::contacts) != nullptr;
  }
};

// Comma-separated names of panels, "bonds", "contacts", "plots", "all" or "none". Throws Error(bad_input).
OverlayChoice parse_overlay(const std::string& text);
// What it takes, for help.
std::string overlay_help();

// How a picture shows that there is another run of the same scene.
struct Comparison {
  std::string caption = {};               // in larger letters; empty: there is none
  std::vector<std::string> details = {};  // lines below it
  bool ghost = false;                     // the other run's bodies too, translucent
  std::size_t lines = 0;                  // room for so many details; the same for pictures side by side
  float back = 1;  // how much farther away a scene's own camera is: half a frame sees less
};

class FramePainter {
 public:
  // `context` is current and outlives this. The camera makes room for panels and caption, and unless it is
  // given frames the bodies as `first` has them.
  FramePainter(GlContext& context, std::shared_ptr<const Scene> scene, const FrameView& first, int width,
               int height, const OverlayChoice& overlay, const CameraOption& camera,
               const Comparison& comparison = {});

  // Draws, and starts copying it back. `other`: the other run, or null; `apart`: how far the two are from
  // each other. `time`: where the camera is; s.
  void draw(const FrameView& view, const FrameView* other, std::span<const DistancePoint> apart, double time);
  int queued() const { return renderer_.queued(); }
  void fetch(Image& out);  // the oldest picture that was drawn; precondition: queued() > 0
  std::string gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  void set_camera(const FrameView& first, std::size_t caption_lines, float back);

  std::shared_ptr<const Scene> scene_;
  int width_, height_;
  Renderer renderer_;
  Overlay overlay_;
  OverlayChoice choice_;
  CameraOption camera_option_;
  Camera base_camera_;
  double start_time_;  // s
  bool ghost_;
  OverlayData data_;  // what all frames have in common
  VisualScene visual_;
};

}  // namespace pabd
