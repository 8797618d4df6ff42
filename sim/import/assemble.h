// SPDX-License-Identifier: MIT
// From a robot's tree to the bodies and joints of a scene. Internal to sim/import.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/import/robot.h"

namespace pabd {

// As a scene has them, but with z up.
struct BodyPlan {
  std::string name;  // unique, fit for a scene
  bool fixed = false;
  bool ghost = false;     // touches nothing
  bool hidden = false;    // not drawn
  double mass = 0;        // kg
  double lifted = 0;      // of it, what gravity does not pull; kg
  Mat3 I = Mat3::Zero();  // about c, along the body's axes; kg m²
  Vec3 c = Vec3::Zero();  // centre of mass, world; m
  Mat3 R = Mat3::Identity();
  // One primitive about the centre of mass, or convex parts by their corners in the body's frame.
  GeomKind kind = GeomKind::mesh;
  Vec3 size = Vec3::Zero();    // as RobotGeom
  Vec3 centre = Vec3::Zero();  // of a primitive, from c along the body's axes; m
  std::vector<std::vector<Vec3>> parts;
  bool even = false;  // I is that of even matter in the shape
  std::optional<Vec3> color;
  int type = 1, affinity = 1;
  int tree = kNoTree;                       // the robot that it is a part of
  std::optional<SurfaceFriction> friction;  // of what touches
};

inline constexpr int kNoBody = -1;                                    // the world
inline constexpr const char* kGroundName = "ground under the robot";  // of no body here

struct FollowPlan {
  int leader;  // number of the joint
  double ratio, offset;
};

struct JointPlan {
  RobotJointKind kind = RobotJointKind::hinge;
  bool weld = false;  // in place of the kind
  std::string name;
  int i = kNoBody, j = kNoBody;
  Vec3 anchor = Vec3::Zero();  // world, at the start; m
  Vec3 axis = Vec3::UnitZ();   // the same
  double start = 0;            // angle or offset at the start; rad or m
  std::optional<std::pair<double, double>> range;
  std::optional<double> target;
  RobotAction action;
  std::optional<FollowPlan> follows;
  double arm = 0;  // m
  Place place;
};

struct ScenePlan {
  std::vector<BodyPlan> bodies;
  std::vector<JointPlan> joints;
  std::vector<std::pair<int, int>> apart;  // a < b, sorted, each once
  double lowest = 0;                       // of what moves; m
  double smallest = 0;                     // radius of the smallest body that touches; m
  double heaviest = 0;                     // mass of the heaviest tree of bodies; kg
};

// Jointless links become part of what they stand on: exact, and cheaper than bonds. A link with several joints gets
// light bodies between them. Joints begin in their range. Throws Error(bad_input) for a robot without bodies.
ScenePlan assemble(const Robot& robot, ImportNotes& notes);

}  // namespace pabd
