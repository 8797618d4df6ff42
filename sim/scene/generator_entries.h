// SPDX-License-Identifier: MIT
// Entries of "generate". See field.h and body_entry.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/joint.h"
#include "sim/scene/body_entry.h"

namespace pabd::spec {

inline constexpr double kRestingGap = 0.95;  // of d̂: between levels, so that they start in light contact
inline constexpr std::string_view kNameHelp =
    "Start of the bodies' names, as in \"pile 17\", or \"pyramid 0.3\" for level 0 and brick 3, all counted "
    "from 0";
inline constexpr std::string_view kNameDefault =
    "the type, and from the second generator of a type on its number: \"pyramid2\"";

// Boxes, spheres and everything that may be a rod; "mixed" at the end, if wanted.
std::span<const std::string_view> generated_shape_words(bool mixed);

// What all generators of bricks share.
struct Bricks {
  std::string name = {};
  std::optional<Vec3> size = {};                  // m
  std::optional<Vec3> position = {};              // m
  std::optional<double> mass = {}, density = {};  // kg, kg/m³
  std::optional<double> gap = {};                 // m
  std::optional<SurfaceFriction> friction = {};
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};
  void fields(auto&& f) {
    f(may("name", kNameHelp).or_else(kNameDefault), name);
    f(may("size", "Edge lengths of a brick along x, y and z", kSizeRange), size, Vec3(Vec3::Ones()));
    f(may("position", "Centre of the bottom, on the ground", kPositionRange), position, Vec3(Vec3::Zero()));
    f(may("gap", "Vertical gap between levels, and between the lowest one and the ground", kGapRange)
          .or_else("0.95 times contact.d_hat, so that bricks start at rest with a little load on them"),
      gap, [](double d_hat) { return kRestingGap * d_hat; });
    mass_fields(f, mass, density);
  }
  void touch(auto&& f) { touch_fields(f, friction, restitution, groups); }
};

void spacing_field(auto&& f, std::optional<double>& spacing) {
  f(may("spacing", "Horizontal gap between bricks", kGapRange)
        .or_else("contact.d_hat, so that they do not touch sideways"),
    spacing, [](double d_hat) { return d_hat; });
}

struct Stack {
  static constexpr const char* type = "stack";
  static constexpr const char* help = "Boxes on top of each other";
  Bricks bricks = {};
  std::int64_t count = 1;
  std::vector<double> masses = {};    // kg
  std::optional<double> rotate = {};  // degrees
  void fields(auto&& f) {
    bricks.fields(f);
    f(need("count", "Number of boxes", kBodyCountRange), count);
    f(may("rotate", "Turn of each box against the one below, about y", kTurnRange), rotate, 0.0);
    f(may("masses", "Masses from the bottom up, repeated: [1, 100] alternates. In place of mass and density",
          kMassRange),
      masses);
    bricks.touch(f);
  }
};

struct Wall {
  static constexpr const char* type = "wall";
  static constexpr const char* help =
      "A brick wall along x in running bond: every odd row is shifted by half a brick";
  Bricks bricks = {};
  std::int64_t columns = 1, rows = 1;
  std::optional<double> spacing = {};  // m
  std::optional<bool> half_blocks = {};
  void fields(auto&& f) {
    bricks.fields(f);
    f(need("columns", "Bricks in an even row", kBodyCountRange), columns);
    f(need("rows", "Number of rows", kBodyCountRange), rows);
    spacing_field(f, spacing);
    f(may("half_blocks", "true: half bricks end the odd rows; false: these are one brick shorter"),
      half_blocks, true);
    bricks.touch(f);
  }
};

struct Pyramid {
  static constexpr const char* type = "pyramid";
  static constexpr const char* help =
      "A flat pyramid of bricks along x: each row has one brick less than the one below";
  Bricks bricks = {};
  std::int64_t base = 1;
  std::optional<double> spacing = {};  // m
  void fields(auto&& f) {
    bricks.fields(f);
    // 2827·2828/2 is just below the largest scene.
    f(need("base", "Bricks in the lowest row; n gives n(n+1)/2 bricks", {1, 2827}), base);
    spacing_field(f, spacing);
    bricks.touch(f);
  }
};

struct Pile {
  static constexpr const char* type = "pile";
  static constexpr const char* help =
      "Bodies on a jittered grid, turned at random, in layers above the ground: they fall";
  std::string name = {};
  std::int64_t count = 1;
  std::string shape = {};
  std::optional<Vec3> size = {};                  // m
  std::optional<Vec3> position = {};              // m
  std::optional<double> mass = {}, density = {};  // kg, kg/m³
  std::optional<double> vary = {};
  std::optional<std::int64_t> columns = {};
  std::optional<double> spacing = {};  // m
  std::optional<std::int64_t> seed = {};
  std::optional<SurfaceFriction> friction = {};
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};
  void fields(auto&& f) {
    f(may("name", kNameHelp).or_else(kNameDefault), name);
    f(need("count", "Number of bodies", kBodyCountRange), count);
    f(may("shape", "Shape of the bodies; mixed draws a box, a sphere or a capsule for each")
          .one_of(generated_shape_words(true)),
      shape, "box");
    f(may("size",
          "Edge lengths of a box. A sphere has the shortest edge as its diameter; the others three quarters "
          "of that, and the longest edge as their length, with caps",
          kSizeRange),
      size, Vec3(Vec3::Ones()));
    f(may("position", "Centre of the bottom of the grid", kPositionRange), position, Vec3(Vec3::Zero()));
    mass_fields(f, mass, density);
    f(may("vary", "Each body is larger or smaller by a random part up to this", {0, 0.9}), vary, 0.0);
    f(may("columns", "Bodies along x and along z in a layer", kBodyCountRange)
          .or_else("the rounded-up cube root of count"),
      columns, [this](double) { return usual_columns(); });
    f(may("spacing",
          "Distance of grid points; at least the largest diameter plus contact.d_hat. What it exceeds that "
          "by becomes jitter",
          {0, 1e6, "m"})
          .or_else("1.1 times the largest diameter plus contact.d_hat"),
      spacing, [this](double d_hat) { return 1.1 * widest() + d_hat; });
    f(may("seed", "Start of the random numbers: the same seed gives the same pile on every machine",
          {0, 9007199254740992.0}),  // 2^53: what every JSON writer can hold
      seed, std::int64_t{1});
    touch_fields(f, friction, restitution, groups);
  }
  std::int64_t usual_columns() const;
  double widest() const;  // the largest diameter of a body; m
};

struct Chain {
  static constexpr const char* type = "chain";
  static constexpr const char* help = "Links one behind the other along a line, each joined to the next";
  std::string name = {};
  std::int64_t links = 1;
  std::string shape = {};
  std::optional<Vec3> size = {};       // along the chain first; m
  std::optional<Vec3> position = {};   // m
  std::optional<double> gap = {};      // m
  std::optional<Vec3> direction = {};  // of any length but 0
  std::optional<JointType> joint = {};
  std::optional<Vec3> axis = {};
  std::string fixed = {};
  std::optional<double> mass = {}, density = {};  // kg, kg/m³
  std::optional<double> end_mass = {};            // kg
  std::optional<bool> collide = {};
  std::optional<SurfaceFriction> friction = {};
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};
  void fields(auto&& f) {
    f(may("name", kNameHelp).or_else(kNameDefault), name);
    f(need("links", "Number of links", kBodyCountRange), links);
    f(may("shape", "Shape of a link").one_of(generated_shape_words(false)), shape, "box");
    f(may("size",
          "Length, height and width of a link. A sphere takes the length as its diameter; the others as "
          "their length, with caps, and the height as their diameter",
          kSizeRange),
      size, Vec3(1, 0.1, 0.1));
    f(may("position", "Start of the chain", kPositionRange), position, Vec3(Vec3::Zero()));
    f(may("gap", "Distance between links; the joint is in its middle", kGapRange), gap, 0.0);
    f(may("direction", "Where the chain goes, of any length but zero", kDirectionRange).as_direction(),
      direction, Vec3(Vec3::UnitX()));
    f(may("joint", "Type of the joints, with the law of joints_default")
          .one_of({"spherical", "hinge", "fixed"}),
      joint, JointType::spherical);
    f(may("axis", "Axis of hinges, of any length but zero", kDirectionRange).as_direction(), axis,
      Vec3(Vec3::UnitZ()));
    f(may("fixed", "Which ends are joined to the world").one_of({"none", "first", "both"}), fixed, "first");
    mass_fields(f, mass, density);
    f(may("end_mass", "Mass of the last link", kMassRange), end_mass);
    f(may("collide", "true: neighbours also collide with each other"), collide, false);
    touch_fields(f, friction, restitution, groups);
  }
};

struct Net {
  static constexpr const char* type = "net";
  static constexpr const char* help =
      "Rows and columns of bodies, each joined to its neighbours. A flat net held on two sides can only sag "
      "where its joints give: joints_default with a kappa makes it elastic";
  std::string name = {};
  std::int64_t rows = 1, columns = 1;
  std::string shape = {};
  std::optional<Vec3> size = {};      // m
  std::optional<Vec3> position = {};  // m
  std::optional<double> gap = {};     // m
  std::optional<bool> upright = {};
  std::optional<JointType> joint = {};
  std::string fixed = {};
  std::optional<double> mass = {}, density = {};  // kg, kg/m³
  std::optional<bool> collide = {};
  std::optional<SurfaceFriction> friction = {};
  std::optional<double> restitution = {};
  std::vector<std::string> groups = {};
  void fields(auto&& f) {
    f(may("name", kNameHelp).or_else(kNameDefault), name);
    f(need("rows", "Number of rows, along z, or downwards in an upright net", kBodyCountRange), rows);
    f(need("columns", "Number of columns, along x", kBodyCountRange), columns);
    f(may("shape", "Shape of the bodies; a sphere has the shortest edge as its diameter")
          .one_of({"box", "sphere"}),
      shape, "box");
    f(may("size", "Edge lengths of a box", kSizeRange), size, Vec3(Vec3::Ones()));
    f(may("position", "Centre of the net", kPositionRange), position, Vec3(Vec3::Zero()));
    f(may("gap", "Distance between the boxes that bodies fill", kGapRange).or_else("contact.d_hat"), gap,
      [](double d_hat) { return d_hat; });
    f(may("upright", "true: the net stands in the xy plane; false: it lies in the xz plane"), upright, false);
    f(may("joint",
          "spherical: a ball in the middle between neighbours. distance: a rod between their centres")
          .one_of({"spherical", "distance"}),
      joint, JointType::spherical);
    f(may("fixed", "Which bodies are fixed; top is the first row")
          .one_of({"none", "corners", "edges", "top"}),
      fixed, "corners");
    mass_fields(f, mass, density);
    f(may("collide", "true: neighbours also collide with each other"), collide, false);
    touch_fields(f, friction, restitution, groups);
  }
};

}  // namespace pabd::spec
