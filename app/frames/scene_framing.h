// SPDX-License-Identifier: MIT
// Where cameras are so that a picture shows what a scene has to show.
#pragma once

#include <span>
#include <vector>

#include "app/frames/camera_option.h"
#include "app/frames/outlook.h"
#include "app/overlay/panel_layout.h"
#include "render/visual/bounds.h"
#include "render/visual/framing.h"
#include "sim/scene/scene.h"

namespace pabd {

// From which side the scene wants to be seen, and with which field of view; how far away is for framing to say.
Camera side_of(const Scene& scene);

// What panels, and a caption with so many details, leave free of a frame of so many pixels; all of it when that would be
// too little for a picture.
PicturePart free_part(const PanelLayout& layout, std::optional<std::size_t> caption, int width, int height);

// The camera of the first frame: from the side that the option names, or else as `side` looks, all spots are seen in
// `part`, at every time while it orbits. What the option says of eye and target is not looked at.
Camera frame_view(const CameraOption& option, const Camera& side, std::span<const Spot> spots, double aspect,
                  const PicturePart& part);
// Goes along with what the outlook shows where a camera that stands still would make it too small to be seen.
EasedCamera frame_view(const CameraOption& option, const Camera& side, const Outlook& outlook, double aspect,
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
// And for pictures of how it ended: shows both, of bodies that do not matter (outlook.h) only the start.
Camera scene_camera(const Scene& scene, const State& end, double aspect);

}  // namespace pabd
