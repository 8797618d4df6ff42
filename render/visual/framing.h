// SPDX-License-Identifier: MIT
// Cameras that show all there is to see, in the part of a picture that is free for it.
#pragma once

#include <span>
#include <vector>

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// What has to be in the picture: the hull of balls, points among them.
struct Spot {
  Vec3 centre;        // m, world
  double radius = 0;  // m
};

// A part of a picture, from its top left corner, in parts of its width and height.
struct PicturePart {
  double x = 0, y = 0, w = 1, h = 1;
};

// Of the free part, in the direction in which it is tight: what is fitted fills this much, and is in the middle.
inline constexpr double kFill = 0.9;

// The hull of a body: exact, but for rims, which get up to half a percent of their radius. Nothing of a plane, and
// of a pose that is not finite.
void add_spots(const Shape& shape, const Pose& pose, std::vector<Spot>& out);

// Of what is to be seen (bounds.h says which bodies that are).
std::vector<Spot> body_spots(const Model& model, const State& state);
// These, and where they would fall to, when a floor is near.
std::vector<Spot> spots_of(const Model& model, const State& state);

// The camera that looks as `like` does (direction, up, field of view, projection), from where all spots fit into
// `part`. The distance is the least one, and their outline is in the middle of the part. Without spots: `like`.
Camera fit_camera(std::span<const Spot> spots, const Camera& like, double aspect,
                  const PicturePart& part = {});

// The same for a camera that turns about the vertical through its target: whatever its azimuth, they fit. The
// target is on the axis of the narrowest upright cylinder around the spots, and stays in the middle.
Camera fit_orbit(std::span<const Spot> spots, const Camera& like, double aspect,
                 const PicturePart& part = {});

// From the left front, a little from above, with a calm focal length.
Camera pleasing_side();

}  // namespace pabd
