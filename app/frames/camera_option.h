// SPDX-License-Identifier: MIT
// --camera: where the picture is taken from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/visual/camera_path.h"
#include "render/visual/visual_scene.h"
#include "sim/body/model.h"

namespace pabd {

// What was asked for; applied to the camera that the scene names or that frames the bodies.
struct CameraOption {
  enum class View { base, front, side, top, iso, orbit };
  View view = View::base;
  double orbit = 0;  // degrees a second about the vertical through the target, counter-clockwise from above
  std::optional<Vec3f> eye, target;
  std::optional<float> fov;  // degrees
  std::optional<Vec3f> up;
  bool orthographic = false;
  bool whole_turn = false;  // an orbit that takes as long as the video
  std::vector<std::string>
      fit;             // names or numbers of the bodies to be seen, "leg*" for all that begin so; empty: all
  std::string follow;  // name or number of the body that the camera goes along with; empty: none
  std::vector<CameraKey> keys;  // not empty: the camera follows them, and nothing else counts

  bool frames() const { return !eye && !target && keys.empty(); }  // its distance is for us to find
};

// Comma-separated: "front", "side", "top", "iso", "orbit" (once around in a video), "orbit:20" (degrees a second) or
// "orbit:8s" (a turn in 8 s, with − clockwise); "ortho"; "follow:NAME"; "fit:NAME", as often as wanted; any of "eye=x,y,z",
// "target=x,y,z", "fov=degrees", "up=x,y,z". Or alone a file of key frames, "….json" (camera_keys.h). Empty: the
// base camera. Throws Error(bad_input), Error(file).
CameraOption parse_camera(const std::string& text);
// What it takes, for help.
std::string camera_help();

// The words for a camera, with every digit: parse_camera gives it back. Its shift is no part of them.
std::string camera_words(const Camera& camera);
// What a picture tells of its camera: the text as it was given, or the key frames themselves.
std::string camera_text(const CameraOption& option, const std::string& text);

// The body that the option follows; none without one. Throws Error(bad_input) when the model has none of that name
// or number.
std::optional<Index> followed_body(const CameraOption& option, const Model& model);

// The bodies that the option fits, each once. Throws Error(bad_input) when the model has none of a name or number.
std::vector<Index> bodies_to_fit(const CameraOption& option, const Model& model);

// The camera at `time`: seconds since the first frame, or, for key frames, of the simulation. Named views
// keep the base camera's target and distance. `way`: how far the body that is followed has come since then; m.
Camera apply_camera(const CameraOption& option, const Camera& base, double time,
                    const Vec3& way = Vec3::Zero());

}  // namespace pabd
