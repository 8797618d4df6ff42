// SPDX-License-Identifier: MIT
// The picture of a snapshot in a view; drawn again only when one of them changed.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "app/gui/device_picture.h"
#include "app/gui/gui_layout.h"
#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/gl/renderer.h"
#include "render/visual/build_visual.h"
#include "render/visual/camera_control.h"
#include "sim/scene/scene.h"

namespace pabd {

class SceneView {
 public:
  // Into the renderer's views, `scale` times as large as their places; true when something was drawn. `trails`: of A.
  // `device` draws bodies that are on the GPU only.
  bool draw(const Snapshot& sim, const UiState& ui, const std::vector<Trail>& trails, const GuiLayout& layout,
            const RenderQuality& quality, double scale, Renderer& renderer, DevicePicture& device);

 private:
  // What a picture depends on beside the camera.
  using Key = std::tuple<std::uint64_t, int, int, bool, bool, bool, ColorQuantity, ContactQuantity, Selection,
                         bool, Quality, PictureMarks, const PictureTheme*, std::vector<TrailPoint>>;

  std::optional<Key> key_;  // of the last picture; none: there is none
  Camera camera_;
  VisualScene visual_[2];
};

// Of the forces of contacts in both simulations.
ValueRange shown_forces(const Snapshot& sim);
// Of its bodies, in a range for both runs.
BodyColors shown_colors(const Snapshot& sim, const FrameView& run, ColorQuantity quantity);

// Points the camera so that all spots are seen as `like` looks; until somebody moves it, reframe() keeps it so.
void frame_spots(std::shared_ptr<const std::vector<Spot>> spots, const CameraPose& like, const Viewport& port,
                 UiState& ui);
// For a picture of another shape. Nothing when the camera was moved by hand.
void reframe(const Viewport& port, UiState& ui);

// The scene's own view of all that is to be seen from its start on.
void look_as_scene(const Scene& scene, const Viewport& port, UiState& ui);

// The same of a scene that was just loaded: what is to be seen of it is found first.
void frame_ahead(const std::shared_ptr<const Scene>& scene, const Viewport& port, UiState& ui);

}  // namespace pabd
