// SPDX-License-Identifier: MIT
// --camera: where the picture is taken from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/visual/camera_path.h"
#include "render/visual/visual_scene.h"

namespace pabd {

// What was asked for; applied to the camera that the scene names or that frames the bodies.
struct CameraOption {
  enum class View { base, front, side, top, iso, orbit };
  View view = View::base;
  double orbit = 0;  // degrees a second about the vertical through the target, counter-clockwise from above
  std::optional<Vec3f> eye, target;
  std::optional<float> fov;  // degrees
  std::optional<Vec3f> up;
  std::vector<CameraKey> keys;  // not empty: the camera follows them, and nothing else counts
};

// "front", "side", "top", "iso", "orbit:20", or any of "eye=x,y,z,target=x,y,z,fov=degrees,up=x,y,z"; or a
// file of key frames, "….json" (camera_keys.h). Empty: the base camera. Throws Error(bad_input), Error(file).
CameraOption parse_camera(const std::string& text);

// The words for a camera, with every digit: parse_camera gives it back.
std::string camera_words(const Camera& camera);
// What a picture tells of its camera: the text as it was given, or the key frames themselves.
std::string camera_text(const CameraOption& option, const std::string& text);

// The camera at `time`: seconds since the first frame, or, for key frames, of the simulation. Named views
// keep the base camera's target and distance.
Camera apply_camera(const CameraOption& option, const Camera& base, double time);

}  // namespace pabd
