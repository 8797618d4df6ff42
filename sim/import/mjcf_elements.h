// SPDX-License-Identifier: MIT
// Elements of MJCF one by one: poses, geoms, joints. Internal to sim/import.
#pragma once

#include <map>
#include <string>

#include "sim/import/mjcf_defaults.h"
#include "sim/import/robot.h"
#include "sim/import/robot_meshes.h"

namespace pabd {

// What <compiler> says.
struct MjcfCompiler {
  double angle = kPi / 180;  // of the file's unit; rad
  std::string eulerseq = "xyz";
  std::filesystem::path mesh_folder;
  bool autolimits = true, strippath = false;
  bool global = false;    // poses are told in the world
  double total_mass = 0;  // kg, if it is more than 0
  enum class Inertia { never, always, where_missing } from_geoms = Inertia::where_missing;
};

// What <asset> says.
struct MjcfAssets {
  struct Mesh {
    std::string file;            // or
    std::vector<Vec3> vertices;  // scaled
    Vec3 scale = Vec3::Ones();
    LinkPose reference;  // undone: points become R⁻¹ (x − t)
    std::optional<XmlElement> element;
  };
  std::map<std::string, Mesh> meshes;
  std::map<std::string, Vec3> colors;  // of materials

  void read(const MjcfElement& mesh_or_material, const MjcfCompiler& compiler, ImportNotes& notes);
};

// What reading an element needs.
struct MjcfContext {
  MjcfCompiler compiler;
  MjcfAssets assets;
  MjcfDefaults defaults;
  RobotMeshes* meshes = nullptr;
  ImportNotes* notes = nullptr;
  std::optional<double> control;  // of the actuator that is read, in a keyframe
};

// pos and quat, axisangle, euler, xyaxes or zaxis.
Mat3 mjcf_rotation(const XmlElement& element, const MjcfCompiler& compiler);
LinkPose mjcf_pose(const MjcfElement& element, const MjcfCompiler& compiler);

// In the body's frame. Empty, with a note, for what is not taken.
std::optional<RobotGeom> mjcf_geom(const MjcfElement& element, const MjcfContext& context);
RobotInertia mjcf_inertial(const XmlElement& element, const MjcfContext& context);
// Empty for a free joint.
std::optional<RobotJoint> mjcf_joint(const MjcfElement& element, const MjcfContext& context);

// The control at which an actuator stands: that of the keyframe, or 0; or what of its range is nearest.
double mjcf_control(const MjcfElement& element, const MjcfContext& context);
// <motor>: a torque or force; <velocity>: kv (control − speed). At its control, at the joint: times gear.
void mjcf_motor(const MjcfElement& element, const MjcfContext& context, RobotAction& out);

}  // namespace pabd
