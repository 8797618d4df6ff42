// SPDX-License-Identifier: MIT
// A scene built in C++: what a scene file says, as types. The entries (namespace spec) are those of a file, with the
// same keys, units (SI, angles in degrees), defaults and ranges; build() hands them to the reader of files, so that
// each check and each message is there once.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim/scene/body_entry.h"
#include "sim/scene/generator_entries.h"
#include "sim/scene/joint_entry.h"
#include "sim/scene/scene.h"

namespace pabd {

// Collects entries; build() makes the scene that a file with the same entries would give, to the last bit.
// Listed bodies and joints come before those of generators, whatever the order of calls.
class SceneBuilder {
 public:
  // `name` is the scene's, and names it in messages. `folder`: what names of meshes and scenes are relative to.
  explicit SceneBuilder(std::string name, std::filesystem::path folder = {});
  ~SceneBuilder();
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;

  // Set at will before build().
  std::string description;
  Params params;
  spec::Law joint_law;               // of joints that say nothing of their own
  std::optional<CameraDesc> camera;  // empty: the viewer frames the scene
  std::optional<double> duration;    // to be shown; s

  // Nothing is checked before build().
  void add(const spec::Body& body);
  void add(const spec::Joint& joint);
  void add(const spec::Stack& stack);
  void add(const spec::Wall& wall);
  void add(const spec::Pyramid& pyramid);
  void add(const spec::Pile& pile);
  void add(const spec::Chain& chain);
  void add(const spec::Net& net);
  void add(const spec::NoCollide& pair);
  void add(const spec::Include& include);

  // The scene of all that was added, which stays: more may be added for another. Throws Error(bad_input) with
  // the text that a file would be refused with, the scene's name in place of the file's: "pyramid:
  // /bodies/3/mass: expected …".
  Scene build();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pabd
