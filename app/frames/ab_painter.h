// SPDX-License-Identifier: MIT
// Pictures of one run, or of two beside each other: A as the scene says, B with a patch.
//
//   side    A on the left half, B on the right; each half is a picture of its own, with its own panels
//   ghost   A, and the bodies of B as translucent ones over it
#pragma once

#include <memory>

#include "app/frames/frame_painter.h"
#include "app/frames/frame_source.h"

namespace pabd {

enum class AbView { side, ghost };
AbView parse_ab_view(const std::string& text);  // throws Error(bad_input)

class AbPainter {
 public:
  // As FramePainter. `first` says whether there are two runs, and what the caption tells of them. Unless the camera
  // is given it shows where the scene's bodies go (scene_framing.h). `scene_b`: that of B where its
  // joints have other laws; null: the same. `seconds`: from the first picture to the last one; less than 5 s and the
  // duration of the scene are taken for these.
  AbPainter(GlContext& context, const std::shared_ptr<const Scene>& scene, const Frame& first, AbView view,
            int width, int height, const OverlayChoice& overlay, const CameraOption& camera,
            const std::shared_ptr<const Scene>& scene_b = nullptr, double seconds = 0);

  void set_quality(const RenderQuality& quality);  // of the pictures that follow
  // And starts copying it back. `on_device`: as FramePainter; not with two runs.
  void draw(const Frame& frame, const BodiesOnDevice* on_device = nullptr);
  void look_at(const Frame& frame);  // one that is not drawn; as FramePainter
  int queued() const { return left_->queued(); }
  void fetch(Image& out);  // the oldest picture that was drawn; precondition: queued() > 0
  std::string gl_renderer() const { return left_->gl_renderer(); }

 private:
  std::unique_ptr<FramePainter> left_;
  std::unique_ptr<FramePainter> right_;  // null: the left one fills the frame
  Image left_half_, right_half_;
};

}  // namespace pabd
