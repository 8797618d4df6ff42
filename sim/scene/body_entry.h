// SPDX-License-Identifier: MIT
// Entries of "bodies", "includes" and "no_collide". What is empty is left to the default of scene files. Every member
// has an initialiser, so that those that a caller leaves out of { .name = … } raise no warning. See field.h.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "sim/body/compound.h"
#include "sim/body/keyed.h"
#include "sim/body/surface_friction.h"
#include "sim/scene/field.h"

namespace pabd::spec {

// ---- orientations ----

struct AxisAngle {
  static constexpr const char* object = "axis_angle";
  static constexpr const char* help = "A turn about an axis by the right-hand rule";
  Vec3 axis = Vec3::UnitY();  // of any length but 0
  double angle = 0;           // degrees
  void fields(auto&& f) {
    f(need("axis", "Direction of the axis, of any length but zero", kDirectionRange).as_direction(), axis);
    f(need("angle", "How far it turns", kTurnRange), angle);
  }
};

struct Euler {
  static constexpr const char* object = "euler";
  static constexpr const char* help =
      "Three turns one after the other, each about an axis of the body as it then stands";
  Vec3 angles = Vec3::Zero();  // degrees
  std::string order = "xyz";
  void fields(auto&& f) {
    f(need("euler", "The three angles, in the order of their turns", kTurnRange), angles);
    // Three axes, no two neighbours alike.
    f(may("order",
          "The axes in the order of the turns: xyz is R = Rx(a) Ry(b) Rz(c). Turns about axes that stay "
          "where they are, as roll, pitch and yaw of URDF, are those of the body in the opposite order: "
          "[yaw, pitch, roll] with zyx")
          .one_of({"xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"}),
      order, "xyz");
  }
};

// Body to world, in one of three ways.
struct Orientation : std::variant<std::array<double, 4>, AxisAngle, Euler> {
  using variant::variant;
  Orientation(double w, double x, double y, double z) : variant(std::array{w, x, y, z}) {}  // unit quaternion
};

inline constexpr Field kOrientation =
    may("orientation",
        "How it stands: a unit quaternion [w, x, y, z], normalised when its length is within 0.001 of 1; or "
        "an axis and an angle, or Euler angles, in degrees");

// ---- what bodies and generators have in common ----

void mass_fields(auto&& f, std::optional<double>& mass, std::optional<double>& density) {
  f(may("mass", "Mass of each body; not together with density", kMassRange), mass);
  f(may("density", "Density of each body; not together with mass", kDensityRange)
        .or_else("1000, without mass"),
    density, [&mass](double) { return mass ? std::nullopt : std::optional(1000.0); });
  f.not_both("mass", "density");
}

void touch_fields(auto&& f, std::optional<SurfaceFriction>& friction, std::optional<double>& restitution,
                  std::vector<std::string>& groups) {
  f(may("friction",
        "Coulomb friction of its surface; one number is static and dynamic, and none against turns. "
        "contact.friction_rule makes one of those of two that touch")
        .or_else("contact.friction"),
    friction);
  f(may("restitution",
        "Speed after a hit over that before it. contact.friction_rule makes one of those of two that touch",
        {0, 1})
        .or_else("contact.restitution"),
    restitution);
  f(may("group",
        "Group that it is of, or several: no_collide says which never touch each other. At most 64 groups in "
        "a scene"),
    groups);
}

// ---- bodies ----

// Convex hulls of the surfaces in files; each file is a convex part. Or parts by their corners, in place of files.
struct Mesh {
  static constexpr const char* object = "mesh";
  static constexpr const char* help =
      "The convex hull of a closed surface in a file, or several as one body. The body's origin, and so its "
      "position, is the centre of mass, wherever the file has its own origin; its axes are those of the file";
  std::vector<std::string> files = {};
  double scale = 1;
  std::vector<std::vector<Vec3>> parts = {};  // m
  void fields(auto&& f) {
    f(may("file",
          "OBJ, STL (text or binary) or PLY (text or binary) file, relative to the scene's folder; at most "
          "64 MiB and 200,000 faces, and 256 corners on the hull. A list of files: the convex parts of one "
          "body, in common coordinates. Where parts overlap, the matter counts once for each")
          .as_file("an OBJ, STL or PLY file"),
      files);
    f(may("scale", "Length of the file's unit in m", {1e-6, 1e6}), scale, 1.0);
    f(may("parts",
          "In place of file: the corners of each convex part, as pabd import writes them; at most 256 on the "
          "hull of a part. In a body with inertia the origin of these numbers is the centre of mass",
          kPositionRange),
      parts);
    f.either("file", "parts");
  }
};

// The keys of a Plane.
struct PlaneKeys {
  Vec3 normal = Vec3::UnitY();
  double offset = 0;  // m
  void fields(auto&& f) {
    f(may("normal", "Direction out of the ground, of any length but zero", kDirectionRange).as_direction(),
      normal, Vec3(Vec3::UnitY()));
    f(may("offset", "Distance of the plane from the origin along the normal", kPositionRange), offset, 0.0);
  }
};

struct Material {
  static constexpr const char* object = "material";
  static constexpr const char* help = "How a body is drawn. Not for a plane";
  double opacity = 1;
  bool checker = false;
  void fields(auto&& f) {
    f(may("opacity", "1: opaque; 0: invisible. Translucent bodies cast no shadow", {0, 1}), opacity, 1.0);
    f(may("checker", "true: with darker fields, so that it is seen how the body turns"), checker, false);
  }
};

// sRGB, each 0 … 1. In files also "#rrggbb".
struct Color {
  Vec3 rgb = Vec3::Zero();
};

struct Body {
  static constexpr const char* object = "body";
  static constexpr const char* help = "One body";
  std::string name = {};  // empty: "body 3" by its number
  // Cylinders and cones are made by make_shape (shape_kind.h), hulls and compounds as convex_hull.h and compound.h
  // say. A plane has neither mass nor place.
  std::variant<Shape, Mesh> shape = Box{Vec3::Constant(0.5)};
  std::optional<double> mass = {};     // kg; or density
  std::optional<double> density = {};  // kg/m³
  bool fixed = false;
  std::optional<Vec3> position = {};  // m
  std::optional<Orientation> orientation = {};
  std::optional<Vec3> center_of_mass = {};
  std::optional<Vec3> velocity = {};          // m/s
  std::optional<Vec3> angular_velocity = {};  // degrees/s
  std::optional<SurfaceFriction> friction = {};
  std::optional<double> restitution = {};
  std::optional<Vec3> surface_velocity = {};           // m/s
  std::optional<Keyed<Vec3>> force = {}, torque = {};  // over time in s; N, N m
  std::vector<std::string> groups = {};
  std::optional<std::array<double, 6>> inertia = {};  // kg m²
  std::optional<Color> color = {};
  std::optional<Material> material = {};

  void fields(auto&& f) {
    f(may("name", "Unique name").or_else("\"body 3\" for the entry with index 3, counted from 0"), name);
    f(need("shape", "Shape, with the origin at the centre of mass"), shape);
    f(may("fixed", "true: the body never moves").or_else("false; a plane is always fixed"), fixed,
      [this](double) { return is_ground(); });
    mass_fields(f, mass, density);
    f(may("inertia",
          "Moments of inertia [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] about the centre of mass, along the body's "
          "axes; with mass. No principal moment is more than the other two together; laminas and rods, where "
          "it is as much, get a millionth across. Not for a plane",
          {-1e18, 1e18, "kg m²"})
          .or_else("that of matter spread evenly over the shape"),
      inertia);
    f(may("position", "Centre of mass. Not for a plane", kPositionRange), position, Vec3(Vec3::Zero()));
    f(kOrientation, orientation);
    f(may("center_of_mass",
          "Where it is, from the centre of the shape and along the body's axes. position stays that of the "
          "shape. Not for a plane",
          kPositionRange)
          .or_else("[0, 0, 0]"),
      center_of_mass);
    f(may("velocity", "Velocity of the centre of mass; zero for a fixed body", kVelocityRange), velocity,
      Vec3(Vec3::Zero()));
    f(may("angular_velocity", "Angular velocity about the world's axes; zero for a fixed body", kSpinRange),
      angular_velocity, Vec3(Vec3::Zero()));
    f(may("surface_velocity",
          "How fast its surface goes on of itself, as a belt does, along the body's own axes: friction takes "
          "along what touches it",
          kVelocityRange),
      surface_velocity);
    f(may("force",
          "Force from outside at the centre of mass, along the axes of the world: a vector, or vectors at "
          "given times with straight lines between them. Not on a fixed body",
          {-kMostForce, kMostForce, "N"})
          .or_value(),
      force);
    f(may("torque", "Torque from outside, along the axes of the world; as force",
          {-kMostForce, kMostForce, "N m"})
          .or_value(),
      torque);
    f(may("color",
          "Colour in pictures: \"#rrggbb\", or [r, g, b] with numbers from 0 to 1 (sRGB). Not for a plane",
          {0, 1})
          .or_else("one of a palette; grey for a fixed body"),
      color);
    f(may("material", "How it is drawn. Not for a plane"), material);
    touch_fields(f, friction, restitution, groups);
  }

  bool is_ground() const {
    const Shape* own = std::get_if<Shape>(&shape);
    return own && is_plane(*own);
  }
};

// ---- pairs that never touch ----

// The name of a group where that of a body may stand.
struct Group {
  static constexpr const char* object = "group";
  static constexpr const char* help = "All bodies of a group";
  std::string name = {};
  void fields(auto&& f) { f(need("group", "Its name, which a body says in \"group\""), name); }
};
using BodyOrGroup = std::variant<std::string, Group>;

// Never touch each other. A group may stand on both sides.
struct NoCollide {
  BodyOrGroup i = {}, j = {};
};

// ---- other scenes ----

struct Include {
  static constexpr const char* object = "include";
  static constexpr const char* help =
      "The bodies, generators, joints, groups, pairs that never touch and colours of another scene, and of "
      "those that it includes. Its planes are left out, and what they hold is held by the world; so are its "
      "parameters, camera, duration and what contacts remember. joints_default of its own holds for its own "
      "joints";
  std::string scene = {};
  std::string prefix = {};            // may be empty
  std::optional<Vec3> position = {};  // m
  std::optional<Orientation> orientation = {};
  void fields(auto&& f) {
    f(need("scene",
           "A scene file, named relative to the folder of the file that includes it; the program takes a "
           "robot (.urdf, .xml) as well")
          .as_file("a scene file"),
      scene);
    f(may("prefix", "Begins every name of a body, joint and group that comes from there").or_else("nothing"),
      prefix);
    f(may("position", "Where its origin comes to be", kPositionRange), position, Vec3(Vec3::Zero()));
    f(kOrientation, orientation);
  }
};

}  // namespace pabd::spec
