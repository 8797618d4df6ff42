// SPDX-License-Identifier: MIT
// A scene built in C++: what a scene file says, as types. The entries below are those of a file, with the same
// keys, units (SI, angles in degrees), defaults and ranges; build() hands them to the reader of files, so that
// each check and each message is there once. assets/pabd-scene.schema.json says what every key means.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/body/compound.h"
#include "sim/scene/scene.h"

namespace pabd {

// As κ of a joint: what suits its masses ("auto").
inline constexpr double kAutoKappa = 0;

// Entries of a scene. What is empty is left to the default of scene files. Every member has an initialiser, so that
// those that a caller leaves out of { .name = … } raise no warning.
namespace spec {

// The law of a joint's bonds.
struct Law {
  std::optional<BondPotential> potential = {};  // soft
  std::optional<double> kappa = {};  // N/m for soft, J for hard; or kAutoKappa, which is the default
  std::optional<int> N = {};         // hard only
  std::optional<double> d_hat = {};  // hard only; m
};

// OBJ, STL or PLY files, relative to the builder's folder; each is a convex part.
struct Mesh {
  std::vector<std::string> files = {};
  double scale = 1;
};

// A turn about an axis of any length but 0, by the right-hand rule.
struct AxisAngle {
  Vec3 axis = Vec3::UnitY();
  double angle = 0;  // degrees
};

// Turns about three of the body's own axes, one after the other.
struct Euler {
  Vec3 angles = Vec3::Zero();  // degrees
  std::string order = "xyz";   // any of the twelve
};

// Body to world, in one of three ways.
struct Orientation : std::variant<std::array<double, 4>, AxisAngle, Euler> {
  using variant::variant;
  Orientation(double w, double x, double y, double z) : variant(std::array{w, x, y, z}) {}  // unit quaternion
};

struct Body {
  std::string name = {};  // empty: "body 3" by its number
  // Cylinders and cones are made by make_shape (shape_kind.h), hulls and compounds as convex_hull.h and compound.h
  // say. A plane has neither mass nor place.
  std::variant<Shape, Mesh> shape = Box{Vec3::Constant(0.5)};
  std::optional<double> mass = {};               // kg; or density
  std::optional<double> density = {};            // kg/m³; 1000
  bool fixed = false;                            // never moves
  std::optional<Vec3> position = {};             // of the shape's centre, world; m
  std::optional<Orientation> orientation = {};   // body to world
  std::optional<Vec3> center_of_mass = {};       // from there, along the body's axes; m. Empty: there
  std::optional<Vec3> velocity = {};             // m/s
  std::optional<Vec3> angular_velocity = {};     // world; degrees/s
  std::optional<SurfaceFriction> friction = {};  // of its own; else contact.friction
  std::optional<double> restitution = {};
  std::optional<Vec3> surface_velocity = {};           // of itself, as of a belt; body frame; m/s
  std::optional<Keyed<Vec3>> force = {}, torque = {};  // from outside, over time in s; world; N, N m
  std::vector<std::string> groups = {};                // that it is of
};

// The name of a group where that of a body may stand.
struct Group {
  std::string name = {};
};
using BodyOrGroup = std::variant<std::string, Group>;

// Never touch each other. A group may stand on both sides.
struct NoCollide {
  BodyOrGroup i = {}, j = {};
};

// The bodies and joints of another scene, each name with `prefix` before it.
struct Include {
  std::string scene = {};                       // its file, relative to the builder's folder
  std::string prefix = {};                      // may be empty
  std::optional<Vec3> position = {};            // where its origin goes; m
  std::optional<Orientation> orientation = {};  // how its axes stand
};

// A range of an angle or an offset: lowest and highest; degrees or m. Includes where the joint starts.
using Limits = std::pair<double, double>;

// A motor along the angle of a hinge or the offset of a slider: a torque or force, or a speed.
struct Motor {
  std::optional<Profile> force = {};  // over time in s; N m or N
  std::optional<Profile> speed = {};  // degrees/s or m/s
  std::optional<double> most = {};    // force with which the speed is held; N m or N
  std::optional<double> gain = {};    // force per missing speed; N m s/rad or N s/m
};

// A spring along the angle of a hinge or the offset of a slider.
struct Spring {
  double stiffness = 0;             // N m/rad or N/m
  std::optional<double> rest = {};  // where it gives nothing; degrees or m
  // In place of `stiffness`: (way from rest, what pulls back); degrees and N m, or m and N.
  std::vector<std::pair<double, double>> table = {};
};

// x = ratio × x of the other joint + offset; angles count in rad for the ratio.
struct Follows {
  std::string joint;                  // name of the other one
  double ratio = 1;                   // rad, m per rad, m
  std::optional<double> offset = {};  // degrees or m; empty: as both stand at the start
};

// Joins two bodies, or one and the world. Entries that the type does not have are refused.
struct Joint {
  JointType type = JointType::spherical;
  std::string i = {}, j = {};            // names of the two bodies; empty: the world
  std::string name = {};                 // empty: "joint 3" by its number
  std::optional<Vec3> anchor = {};       // world, at the start; m
  std::optional<Vec3> axis = {};         // world, at the start; of any length but 0
  std::vector<Vec3> points = {};         // distance: on i and on j; world, m
  std::optional<double> length = {};     // distance: at rest; m
  std::optional<double> arm = {};        // of the points beside the anchor; m
  std::optional<bool> symmetric = {};    // two bonds a rotational degree of freedom
  std::optional<Limits> limits = {};     // hinge: degrees; slider: m
  std::optional<Profile> drive = {};     // of the same quantity and unit, over time in s
  std::optional<TurnProfile> turn = {};  // spherical: rotation vectors of j against i; degrees
  std::string axes = {};                 // spherical with a turn: arms that are held, "x" … "xyz"
  std::optional<double> start = {};      // hinge, slider: where it starts, bodies being told at 0; degrees, m
  std::optional<Motor> motor = {};       // hinge, slider
  std::optional<double> damping = {};    // N m s/rad or N s/m
  std::optional<double> friction = {};   // hinge, slider: dry; N m or N
  std::optional<Spring> spring = {};     // hinge, slider
  std::optional<Follows> follows = {};   // hinge, slider, cylindrical
  std::optional<double> lead = {};       // cylindrical: a screw; m a turn
  std::optional<Twist> twist = {};       // slider
  std::optional<Limits> twist_limits = {};  // slider with limited twist; degrees
  Law law = {};
  bool collide = false;  // may the two touch each other?
};

// What all generators of bricks share.
struct Bricks {
  std::string name = {};                          // begins the name of every brick
  std::optional<Vec3> size = {};                  // edge lengths; m
  std::optional<Vec3> position = {};              // centre of the bottom; m
  std::optional<double> mass = {}, density = {};  // of each; kg, kg/m³
  std::optional<double> gap = {};                 // between levels; m
  std::optional<SurfaceFriction> friction = {};   // as of a body
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};  // that all are of
};

// Bricks one on the other.
struct Stack {
  Bricks bricks = {};
  std::int64_t count = 1;
  std::vector<double> masses = {};    // from the bottom up, repeated; in place of bricks.mass; kg
  std::optional<double> rotate = {};  // of each level against the one below; degrees
};

// Rows of bricks, every other one shifted by half a brick.
struct Wall {
  Bricks bricks = {};
  std::int64_t columns = 1, rows = 1;
  std::optional<double> spacing = {};    // sideways; m
  std::optional<bool> half_blocks = {};  // at the ends of shifted rows
};

// Rows of bricks, each with one fewer than the row below.
struct Pyramid {
  Bricks bricks = {};
  std::int64_t base = 1;               // bricks in the lowest row
  std::optional<double> spacing = {};  // sideways; m
};

// Bodies on a jittered grid, turned at random, ready to fall.
struct Pile {
  std::string name = {};
  std::int64_t count = 1;
  std::string shape = {};                         // "box", "sphere", "capsule" or "mixed"
  std::optional<Vec3> size = {};                  // m
  std::optional<Vec3> position = {};              // centre of the bottom; m
  std::optional<double> mass = {}, density = {};  // of each; kg, kg/m³
  std::optional<double> vary = {};                // of sizes, 0 … 0.9
  std::optional<std::int64_t> columns = {};       // of the grid
  std::optional<double> spacing = {};             // of the grid; m
  std::optional<std::int64_t> seed = {};
  std::optional<SurfaceFriction> friction = {};  // as of a body
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};  // that all are of
};

// Links one behind the other, each joined to the next.
struct Chain {
  std::string name = {};
  std::int64_t links = 1;
  std::string shape = {};                         // "box", "capsule" or "sphere"
  std::optional<Vec3> size = {};                  // of a link, along the chain first; m
  std::optional<Vec3> position = {};              // of the start; m
  std::optional<double> gap = {};                 // between links; m
  std::optional<Vec3> direction = {};             // of any length but 0
  std::optional<JointType> joint = {};            // spherical, hinge or fixed
  std::optional<Vec3> axis = {};                  // of hinges
  std::string fixed = {};                         // ends held by the world: "none", "first" or "both"
  std::optional<double> mass = {}, density = {};  // of a link; kg, kg/m³
  std::optional<double> end_mass = {};            // of the last link; kg
  std::optional<bool> collide = {};               // may neighbours touch each other?
  std::optional<SurfaceFriction> friction = {};   // as of a body
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};  // that all are of
};

// Rows and columns of bodies, each joined to its four neighbours.
struct Net {
  std::string name = {};
  std::int64_t rows = 1, columns = 1;
  std::string shape = {};                         // "box" or "sphere"
  std::optional<Vec3> size = {};                  // m
  std::optional<Vec3> position = {};              // of the middle; m
  std::optional<double> gap = {};                 // between bodies; m
  std::optional<bool> upright = {};               // hangs, or lies level
  std::optional<JointType> joint = {};            // spherical or distance
  std::string fixed = {};                         // "none", "corners", "edges" or "top"
  std::optional<double> mass = {}, density = {};  // of a body; kg, kg/m³
  std::optional<bool> collide = {};               // may neighbours touch each other?
  std::optional<SurfaceFriction> friction = {};   // as of a body
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};  // that all are of
};

}  // namespace spec

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
