// SPDX-License-Identifier: MIT
// Draws panels and labels over a frame as Dear ImGui draw data. No window and no GL in here: the data is for
// Renderer::draw and Renderer::compose, the font atlas goes through a callback.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/overlay/body_colors.h"
#include "app/overlay/panel_layout.h"
#include "app/plots/canvas.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/difference.h"
#include "app/session/frame_view.h"
#include "render/visual/build_visual.h"
#include "sim/body/joint.h"

struct ImDrawData;

namespace pabd {

// What the panels show. Pointers may be null: their panels say so. Everything must live until the call
// returns.
struct OverlayData {
  std::string scene_name;
  const FrameView* view = nullptr;     // its report has records and contacts if the panels need them
  const BondLaw* joint_law = nullptr;  // of joints that say nothing of their own, κ resolved

  const BodyColors* colors = nullptr;  // of the bodies
  ContactQuantity contacts_by = ContactQuantity::gap;
  ValueRange force_range{};                   // of the contacts, N
  bool axes = false, scale = false;           // view_marks.h
  const PictureTheme* theme = &kStudioTheme;  // of the picture; never null

  // What is known of the whole video: its time, s, and its iterations. Nothing: axes fit what they show.
  double from = 0, to = 0;
  const ConvergenceSpan* span = nullptr;

  // Of two runs beside each other. The caption is one line in larger letters, the details follow below it.
  std::string caption{};
  std::vector<std::string> details{};
  const FrameView* other = nullptr;            // the run that `view` is compared with
  std::span<const DistancePoint> distances{};  // oldest first
};

class Overlay {
 public:
  // Takes the atlas as RGBA, returns the texture's id: Renderer::upload_font_atlas. Called again when the
  // sizes of the texts change (another frame size); the old texture is not used any more then.
  using UploadAtlas = std::function<void*(const unsigned char* rgba, int width, int height)>;

  explicit Overlay(UploadAtlas upload);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  // Panels and the labels of `scene` (null: none) for a frame of width × height pixels. The result is valid
  // until the next call on this object.
  const ImDrawData* frame(const OverlayOptions& options, const OverlayData& data, const VisualScene* scene,
                          int width, int height);

  // A picture painted as panels of a window are.
  const ImDrawData* paint(const Picture& picture, int width, int height);

  // Code points that some text asked for and the font does not have, for tests and diagnostics.
  std::u32string unknown_characters() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
