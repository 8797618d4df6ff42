// SPDX-License-Identifier: MIT
// Turns what a frame shows of one of its runs into pixels.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/frames/camera_option.h"
#include "app/frames/frame.h"
#include "app/frames/outlook.h"
#include "app/overlay/overlay.h"
#include "app/session/frame_view.h"
#include "render/gl/renderer.h"
#include "render/visual/bounds.h"
#include "render/visual/build_visual.h"
#include "render/visual/picture_marks.h"
#include "sim/scene/scene.h"

namespace pabd {

// What --overlay asked for.
struct OverlayChoice {
  OverlayOptions panels;
  bool bonds = false;
  bool contacts = false;  // with the legend of their colours
  PictureMarks marks;
  ColorQuantity color = ColorQuantity::body;
  ContactQuantity contacts_by = ContactQuantity::gap;
  const PictureTheme* theme = &kStudioTheme;  // never null
  std::string caption = {};                   // of every picture; "{time}", "{step}": of that one

  bool needs_iterations() const { return panels.needing(&OverlayPanel::iterations) != nullptr; }
  bool needs_contacts() const {
    return bonds || contacts || panels.needing(&OverlayPanel::contacts) != nullptr;
  }
  bool needs_bodies() const { return needs_body_reports(color); }
  // Colours mean what they meant in all frames before: these must have been seen.
  bool remembers() const { return color != ColorQuantity::body || contacts_by == ContactQuantity::force; }
  void color_by(ColorQuantity quantity);            // bodies, with a legend
  void show_contacts_by(ContactQuantity quantity);  // by another than gap: shows them
};

// Comma-separated names of panels, "bonds", "contacts", "plots", "all" or "none". Throws Error(bad_input).
OverlayChoice parse_overlay(const std::string& text);
// What it takes, for help.
std::string overlay_help();

// The theme of that name. Throws Error(bad_input) with the list.
const PictureTheme& find_theme(const std::string& name);
std::string theme_help();  // "studio (light grey), …"

// How a picture shows that there are other runs of the same scene.
struct Comparison {
  std::string caption = {};               // in larger letters; empty: there is none
  std::vector<std::string> details = {};  // lines below it
  bool ghost = false;                     // the other run's bodies too, translucent
  std::size_t lines = 0;                  // room for so many details; the same for pictures side by side
};

// Bodies of a frame whose poses lie on the GPU (DeviceFilm): the view has none.
struct BodiesOnDevice {
  DeviceInstances* bodies;               // not null
  std::optional<BoundingSphere> around;  // what is to be seen of them
};

class FramePainter {
 public:
  // Of one of the runs of frames. `context` is current and outlives this. Unless the camera says where it is, it shows all of
  // `outlook` in the area that panels and caption leave free. `seconds`: from the first picture to the end of the last one;
  // 0: not known. Throws Error(bad_input) when it follows a body that does not exist.
  FramePainter(GlContext& context, std::shared_ptr<const Scene> scene, const Frame& first, std::size_t run,
               const Outlook& outlook, int width, int height, const OverlayChoice& overlay,
               const CameraOption& camera, double seconds, const Comparison& comparison = {});

  // Draws, and starts copying the picture back. `on_device`: where the bodies are, if not in the view; marks that need their
  // places are not drawn then.
  void draw(const Frame& frame, const BodiesOnDevice* on_device = nullptr);
  // A frame that is not drawn: colours take its values into their range, as draw() does.
  void look_at(const Frame& frame);
  // Of later pictures.
  void set_quality(const RenderQuality& quality) { quality_ = quality; }
  int queued() const { return renderer_.queued() + static_cast<int>(mattes_.size()); }
  void fetch(Image& out);  // the oldest picture that was drawn; precondition: queued() > 0
  std::string gl_renderer() const { return renderer_.gl_renderer(); }

 private:
  void set_extent(const FrameView& view);
  void set_camera(const FrameView& first, const Outlook& outlook, std::optional<std::size_t> caption);

  std::shared_ptr<const Scene> scene_;
  std::size_t run_;
  int width_, height_;
  Renderer renderer_;
  Overlay overlay_;
  OverlayChoice choice_;
  CameraOption camera_option_;
  EasedCamera base_camera_;
  std::vector<std::uint8_t> far_;       // see Outlook
  std::vector<std::uint8_t> at_start_;  // bodies_in_picture() of the start
  std::optional<Index> followed_;
  Vec3 follow_from_ = Vec3::Zero();  // where that body was in the first frame; m
  double start_time_;                // s
  bool ghost_;
  std::string caption_;  // of a comparison
  RenderQuality quality_;
  BodyColors colors_;
  double largest_force_ = 0;  // of the frames so far; N
  OverlayData data_;          // what all frames have in common
  VisualScene visual_;
  std::deque<Image> mattes_;  // of a transparent theme: drawn twice and put together at once
};

}  // namespace pabd
