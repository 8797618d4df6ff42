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

// Anything that turns packets into images, in order: one run, or two beside each other (ab_painter.h).
class FrameDrawer {
 public:
  virtual ~FrameDrawer() = default;
  virtual void draw(const FramePacket& packet) = 0;  // and starts copying it back
  virtual int queued() const = 0;
  virtual void fetch(Image& out) = 0;  // the oldest frame that was drawn; precondition: queued() > 0
};

// How a picture shows that there is another run of the same scene.
struct Comparison {
  std::string caption;               // in larger letters
  std::vector<std::string> details;  // lines below it
  std::string name, other_name;      // for plots: "A", "B"
  bool ghost = false;                // the other run's bodies too, translucent
  std::size_t lines = 0;             // room for so many details; the same for pictures side by side
  float back = 1;                    // how much farther away a scene's own camera is: half a frame sees less
};

class FramePainter : public FrameDrawer {
 public:
  // `context` is current and outlives this; `session` is only asked for what does not change: model and
  // parameters.
  FramePainter(GlContext& context, const Session& session, int width, int height,
               const OverlayChoice& overlay, const CameraOption& camera);

  // The session has other parameters or another model now.
  void refresh();

  // From now on with another run. Before the first frame: the camera makes room for the caption, and frames
  // the bodies where the session is now.
  void compare(const Comparison& comparison);

  void draw(const FramePacket& packet) override { draw(packet, nullptr, packet.state.time); }
  // With the other run, after compare(). `time`: where the camera is, the same for both; s.
  void draw(const FramePacket& packet, const FramePacket* other, double time);
  int queued() const override { return renderer_.queued(); }
  void fetch(Image& out) override;
  std::string gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  void set_camera(std::size_t caption_lines, float back);
  void add_other(const FramePacket& other, const std::vector<DistancePoint>& apart);

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
  bool ghost_ = false;
  History other_history_;
  std::vector<DistancePoint> distances_;
};

}  // namespace pabd
