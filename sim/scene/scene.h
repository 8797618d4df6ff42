// SPDX-License-Identifier: MIT
// A scene file, validated and expanded: everything a run needs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body_look.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/scene/field.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// Where a scene wants to be seen from; y is up.
struct CameraDesc {
  Vec3 eye{6, 4, 8};     // world; m
  Vec3 target{0, 1, 0};  // world; m
  double fov = 45;       // vertical, degrees

  static constexpr const char* object = "camera";
  static constexpr const char* help =
      "From which side the picture is taken: how far away, and what is in the middle, follows from the "
      "bodies";
  void fields(auto&& f) {
    f(need("eye", "Position of the camera", kPositionRange), eye);
    f(need("target", "Point in the middle of the picture; not the eye itself", kPositionRange), target);
    f(may("fov", "Vertical field of view", {1, 170, "degrees", true}), fov, 45.0);
  }
};

struct ThinBody {
  Index body;
  double thickness;  // m
};

// Everything a run needs.
struct Scene {
  std::string name;         // the file's stem when it gives none
  std::string description;  // one line for lists of scenes; may be empty
  Params params;
  // Whose thickness contact.d_hat follows, where the scene states none and it is small.
  std::optional<ThinBody> d_hat_of;
  Model model;
  State initial;
  BondLaw joint_law;                 // of joints that say nothing of their own, κ resolved
  std::optional<CameraDesc> camera;  // from which side it wants to be seen; absent: the viewer's choice
  BodyLooks looks;                   // of bodies that say how they are drawn
  std::optional<double> duration;    // that its author means to be shown; s
  std::vector<std::filesystem::path> files;  // that it was read from: itself, if it came from one, and meshes
  std::string hash;  // 16 hex digits over the resolved scene (after --set), platform independent
};

// Reads, validates and expands a scene. `overrides` are "key.path=value" strings as given to --set; a value
// is JSON, or a bare word taken as a string. Throws Error(bad_input) naming file, JSON pointer or line, what
// was expected and the remedy; Error(file) when the file cannot be read.
Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

// The text of a scene file. Throws Error(file).
std::string read_scene_text(const std::filesystem::path& file);

// The same from text; `source` names it in messages, `folder` is what paths in it are relative to.
Scene parse_scene(const std::string& text, const std::string& source, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides = {}, ParameterTable table = parameter_table());

}  // namespace pabd
