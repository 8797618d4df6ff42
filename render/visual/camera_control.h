// SPDX-License-Identifier: MIT
// Moving a camera by hand: pure functions from a camera to a camera, and between pixels and the world.
//
// In double precision, so that what is under the pointer stays under it through thousands of small moves;
// `rounded` gives the Camera that is drawn with.
#pragma once

#include "render/visual/bounds.h"
#include "render/visual/visual_scene.h"
#include "sim/math/types.h"

namespace pabd {

// A camera in double precision. `up` need not be unit, nor square to the line of sight.
struct CameraPose {
  Vec3 eye{6, 4, 8};     // m
  Vec3 target{0, 1, 0};  // m; what orbit() turns about and zoom() comes near to
  Vec3 up{0, 1, 0};
  double fov = 45;  // vertical, degrees
  bool orthographic = false;

  double distance() const { return (eye - target).norm(); }
};
// The same camera in the other precision.
CameraPose precise(const Camera& camera);
Camera rounded(const CameraPose& pose);

// Axes of the picture in the world, unit: to the right, up, and towards the eye. As view_matrix has them.
struct CameraAxes {
  Vec3 right, up, back;
};
CameraAxes axes_of(const CameraPose& pose);

// The part of a window that shows the scene; sizes in pixels, > 0. Pixels count from its top left corner, y
// down.
struct Viewport {
  double width = 1280, height = 720;
};

// What a pixel looks along; (x, y) in pixels.
struct ViewRay {
  Vec3 origin;     // the eye, or beside it for parallel rays; m
  Vec3 direction;  // unit
};
ViewRay ray_through(const CameraPose& pose, const Viewport& port, double x, double y);

// Where a point of the world appears.
struct PixelPoint {
  double x, y;   // pixels
  double depth;  // m in front of the eye, along the line of sight; x and y mean nothing where it is not > 0
};
PixelPoint to_pixel(const CameraPose& pose, const Viewport& port, const Vec3& p);

// Turns the eye about the target: to its right by `azimuth`, upwards by `elevation` (rad), no further than
// straight above or below. The horizon becomes level; the distance stays.
CameraPose orbit(const CameraPose& pose, double azimuth, double elevation);

// Moves so that what is `depth` m in front of the eye follows the pointer by (dx, dy) pixels. Depth 0: that
// of the target.
CameraPose pan(const CameraPose& pose, const Viewport& port, double dx, double dy, double depth = 0);

// Comes nearer by `factor` (> 1: nearer, > 0), towards what pixel (x, y) shows at `depth` m; it stays at that
// pixel. Depth 0: that of the target. The distance to the target stays between 1e-4 and 1e7 m.
CameraPose zoom(const CameraPose& pose, const Viewport& port, double factor, double x, double y,
                double depth = 0);

// Looks at the sphere from the present side, from as far as shows all of it with some air.
CameraPose frame_sphere(const CameraPose& pose, const Viewport& port, const BoundingSphere& sphere);

enum class AxisView { front, back, right, left, top, bottom, iso };  // from +z, −z, +x, −x, +y, −y, (1, 1, 1)
// The target and the distance stay.
CameraPose look_from(const CameraPose& pose, AxisView side);

// Where the eye is, seen from the target: about y from +z towards +x, and above the horizon; rad.
struct CameraAngles {
  double azimuth = 0, elevation = 0;
};
CameraAngles angles_of(const CameraPose& pose);
// The pose at these angles; target, distance and field of view as in `like`.
CameraPose at_angles(const CameraPose& like, const CameraAngles& angles, double distance);

}  // namespace pabd
