// SPDX-License-Identifier: MIT
// Pictures of one run, of two beside each other, A as the scene says and B with a patch, or of a grid of runs.
//
//   side    A on the left half, B on the right; each half is a picture of its own, with its own panels
//   ghost   A, and the bodies of B as translucent ones over it
//   grid    a cell a run, each a picture of its own, with what it has of its own over it
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/frames/frame_painter.h"
#include "app/frames/run_grid.h"

namespace pabd {

enum class AbView { side, ghost };
AbView parse_ab_view(const std::string& text);  // throws Error(bad_input)

// Of runs that are more than one.
struct Arrangement {
  AbView view = AbView::side;
  RunGrid grid =
      RunGrid({});  // not empty: frames have a run for each of its cells, and `scenes` one for each
  // The scene that those of the grid are variants of.
  std::shared_ptr<const Scene> plain = {};
};

class RunsPainter {
 public:
  // As FramePainter. `scenes`: of each run of the frames; where there are fewer, those that follow have the first one.
  // `first` says what captions tell of the runs. Unless the camera is given it shows where the bodies go
  // (scene_framing.h), the same in all pictures whose scenes have as many bodies. `seconds`: from the first picture to the
  // last one; less than 5 s and the duration of the scene are taken for these. Throws Error(bad_input) when cells are too small.
  RunsPainter(GlContext& context, const std::vector<std::shared_ptr<const Scene>>& scenes, const Frame& first,
              const Arrangement& arrangement, int width, int height, const OverlayChoice& overlay,
              const CameraOption& camera, double seconds = 0);

  void set_quality(const RenderQuality& quality);  // of the pictures that follow
  // And starts copying it back. `on_device`: as FramePainter; not with several runs.
  void draw(const Frame& frame, const BodiesOnDevice* on_device = nullptr);
  void look_at(const Frame& frame);  // one that is not drawn; as FramePainter
  int queued() const { return cells_.front().painter->queued(); }
  void fetch(Image& out);  // the oldest picture that was drawn; precondition: queued() > 0
  std::string gl_renderer() const { return cells_.front().painter->gl_renderer(); }

 private:
  struct Cell {
    std::unique_ptr<FramePainter> painter;
    int left = 0, top = 0;  // px
  };

  std::vector<Cell> cells_;
  int width_, height_;
  Image cell_;  // the one that is put in its place
};

}  // namespace pabd
