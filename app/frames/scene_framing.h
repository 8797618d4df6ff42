// SPDX-License-Identifier: MIT
// What a picture of a scene has to show: its bodies, and where they go.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "app/frames/camera_option.h"
#include "app/overlay/panel_layout.h"
#include "app/session/frame_view.h"
#include "render/visual/bounds.h"
#include "render/visual/framing.h"
#include "sim/scene/scene.h"

namespace pabd {

// Time that is looked ahead where nobody says how long a run is to be; s.
inline constexpr double kLookAhead = 5;

// From which side the scene wants to be seen, and with which field of view; how far away is for framing to say.
Camera side_of(const Scene& scene);

// What is to be seen of `start` and of `seconds` after it, found by simulating ahead, with longer steps if there would be
// too many. With many bodies that ends early; bodies that still fall then are shown by the floor below them. Bodies that
// leave for good count only where they start.
std::vector<Spot> spots_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start,
                              double seconds);

// The same of the start of a scene, so that all runs of it are seen from the same place.
std::vector<Spot> scene_spots(const std::shared_ptr<const Scene>& scene, double seconds);
inline double look_ahead_time(const Scene& scene) { return scene.duration.value_or(kLookAhead); }

// What panels, and a caption of so many lines, leave free of a frame of so many pixels; all of it when that would be
// too little for a picture.
PicturePart free_part(const PanelLayout& layout, std::size_t caption_lines, int width, int height);

// The camera of the first frame: from the side that the option names, or else as `side` looks, all spots are seen in
// `part`, at every time while it orbits. What the option says of eye and target is not looked at.
Camera frame_view(const CameraOption& option, const Camera& side, std::span<const Spot> spots, double aspect,
                  const PicturePart& part);
// The same direction, but so near that a body and some of its surroundings fill the part.
Camera come_near(const CameraOption& option, const Camera& framed, const Spot& body, double aspect,
                 const PicturePart& part);

// How the scene wants its bodies to be drawn, by number in `model`, which may have been edited; empty: it says nothing.
std::vector<BodyLook> looks_of(const Scene& scene, const Model& model);
bool all_opaque(const std::vector<BodyLook>& looks);

// Fills `visual` with all but the bodies, whose poses are on a GPU; camera and theme stay. `around`: their extent.
void show_on_device(const Model& model, const std::optional<BoundingSphere>& around, VisualScene& visual);

// The camera of a scene at its start, for pictures without a run.
Camera scene_camera(const Scene& scene, double aspect);
// And for pictures of how it ended: shows both. Bodies that left for good count only where they started.
Camera scene_camera(const Scene& scene, const State& end, double aspect);

}  // namespace pabd
