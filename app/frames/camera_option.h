// --camera: where the picture is taken from.
#pragma once

#include <optional>
#include <string>

#include "render/visual/visual_scene.h"

namespace pabd {

// What was asked for; applied to the camera that the scene names or that frames the bodies.
struct CameraOption {
  enum class View { base, front, side, top, iso, orbit };
  View view = View::base;
  double orbit = 0;  // degrees a second about the vertical through the target, counter-clockwise from above
  std::optional<Vec3f> eye, target;
  std::optional<float> fov;  // degrees
};

// "front", "side", "top", "iso", "orbit:20", or any of "eye=x,y,z,target=x,y,z,fov=degrees". Empty: the base
// camera. Throws Error(bad_input).
CameraOption parse_camera(const std::string& text);

// The camera at `time` seconds. Named views keep the base camera's target and distance.
Camera apply_camera(const CameraOption& option, const Camera& base, double time);

}  // namespace pabd
