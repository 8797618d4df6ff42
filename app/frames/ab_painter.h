// Pictures of one run, or of two beside each other: A as the scene says, B with a patch.
//
//   side    A on the left half, B on the right; each half is a picture of its own, with its own panels
//   ghost   A, and the bodies of B as translucent ones over it
#pragma once

#include <memory>

#include "app/frames/frame_painter.h"

namespace pabd {

enum class AbView { side, ghost };
AbView parse_ab_view(const std::string& text);  // throws Error(bad_input)

class AbPainter : public FrameDrawer {
 public:
  // As FramePainter; `b` may be null: one run.
  AbPainter(GlContext& context, const Session& a, const Session* b, AbView view, int width, int height,
            const OverlayChoice& overlay, const CameraOption& camera);

  void refresh();  // as FramePainter; of both
  void draw(const FramePacket& packet) override;
  int queued() const override { return left_.queued(); }
  void fetch(Image& out) override;
  std::string gl_renderer() const { return left_.gl_renderer(); }

 private:
  FramePainter left_;
  std::unique_ptr<FramePainter> right_;  // null: the left one fills the frame
  Image left_half_, right_half_;
};

}  // namespace pabd
