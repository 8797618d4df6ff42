// SPDX-License-Identifier: MIT
// A robot as its file tells it, before it becomes bodies and joints: a tree of links, z up, in SI units and radians.
// What both formats are read into. Internal to sim/import.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/surface_friction.h"
#include "sim/import/notes.h"
#include "sim/math/types.h"

namespace pabd {

// Maps points of a frame into its parent's: x → R x + t.
struct LinkPose {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();  // m

  Vec3 operator*(const Vec3& x) const { return R * x + t; }
  LinkPose operator*(const LinkPose& inner) const { return {R * inner.R, R * inner.t + t}; }
};

// Where in a file something stands.
struct Place {
  std::string file;
  int line = 0;
};

// About its own centre of mass.
struct RobotInertia {
  double mass = 0;          // kg
  Vec3 com = Vec3::Zero();  // in the link's frame; m
  Mat3 I = Mat3::Zero();    // about the centre of mass, along the link's axes; kg m²
  double lifted = 0;        // of the mass, what gravity does not pull; kg
};

inline constexpr int kNoTree = -1;

enum class GeomKind { box, sphere, capsule, cylinder, ellipsoid, plane, mesh };

struct RobotGeom {
  GeomKind kind = GeomKind::sphere;
  Vec3 size = Vec3::
      Zero();  // box, ellipsoid: half lengths; sphere: radius; capsule, cylinder: radius, half length of the straight part, along z
  std::vector<Vec3> points;  // mesh: corners of its hull in the geom's frame; m
  RobotInertia solid;  // mesh: of the surface at 1 kg/m³, where it is closed, else of the hull; geom's frame
  LinkPose at;         // in the link's frame
  bool visual = false;         // touches nothing
  bool alone = false;          // visual, of a link that has nothing that touches
  int type = 1, affinity = 1;  // two collide if a type of one meets an affinity of the other; bits
  std::optional<double> mass;  // kg; or density
  double density = 0;          // kg/m³; 0: counts for nothing
  std::optional<SurfaceFriction> friction;
  std::optional<Vec3> color;  // sRGB, 0 … 1
  int tree = kNoTree;         // of the link that it belongs to
  Place place;
};

enum class RobotJointKind { hinge, slide, ball };

// What acts along a joint.
struct RobotAction {
  double damping = 0;           // N m s/rad or N s/m
  double friction = 0;          // dry; N m or N
  std::optional<double> force;  // of a motor; N m or N
  std::optional<double> speed;  // of a motor; rad/s or m/s
  double gain = 0;              // force per missing speed; N m s/rad or N s/m
  std::optional<double> most;   // force with which the speed is held; N m or N
  double stiffness = 0;         // of a spring; N m/rad or N/m
  double rest = 0;              // where it gives nothing, measured from the pose of the file; rad or m

  bool motor() const { return force || speed; }
  bool any() const { return motor() || damping > 0 || friction > 0 || stiffness > 0; }
};

// Its angle or offset is ratio × that of the other joint + offset, both measured from the pose of the file.
struct RobotFollow {
  std::string joint;
  double ratio = 1, offset = 0;  // rad, m
  Place place;
};

struct RobotJoint {
  RobotJointKind kind = RobotJointKind::hinge;
  std::string name;
  Vec3 anchor = Vec3::Zero();                      // in the link's frame, all joints of the link at 0; m
  Vec3 axis = Vec3::UnitZ();                       // the same; unit
  double ref = 0;                                  // what the file calls its pose; rad or m
  std::optional<std::pair<double, double>> range;  // rad or m, measured from the pose of the file
  double start = 0;                                // where it begins, if its range has that; the same
  std::optional<double> target;                    // held there by an equality; the same
  RobotAction action;
  std::optional<RobotFollow> follows;
  Place place;
};

inline constexpr int kNoLink = -1;

struct RobotLink {
  std::string name;
  int parent = kNoLink;            // comes before it; none: the world
  LinkPose at;                     // in the parent's frame, joints at 0
  std::vector<RobotJoint> joints;  // from the parent outwards; empty: one with the parent
  bool free = false;               // floats; has no parent but the world
  std::optional<RobotInertia> inertia;
  double lifted = 0;  // part of its weight that is taken from it
  std::vector<RobotGeom> geoms;
  Place place;
};

// Two points, or frames, that are held together besides the tree.
struct RobotLoop {
  bool weld = false;  // else a ball
  int i = kNoLink, j = kNoLink;
  Vec3 anchor = Vec3::Zero();  // in i's frame; m
  Place place;
};

struct Robot {
  std::string name;
  std::string base;  // how the root stands, and why
  std::vector<RobotLink> links;
  std::vector<std::pair<int, int>> excludes;
  std::vector<RobotLoop> loops;
  Vec3 gravity{0, 0, -9.81};        // m/s²
  std::optional<double> time_step;  // s
  bool contacts = true;             // does anything touch?
  bool has_world = false;  // the first link is the world: of no robot, and touches those that hang on it
};

// Geometry within these is taken.
inline constexpr double kLeastSize = 1e-6, kMostSize = 1e6;  // m
inline constexpr const char* kNoSize = "its size is 0, or not from 1e-06 to 1000000 m: left out";
inline constexpr const char* kReversed =
    "range of a joint whose lower bound is above the upper one: not held";

inline constexpr std::size_t kMostLinks = 5000, kMostGeoms = 20000;

}  // namespace pabd
