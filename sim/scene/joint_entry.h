// SPDX-License-Identifier: MIT
// Entries of "joints" and what stands in them. See field.h and body_entry.h. What a type has follows from its traits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/body/joint.h"
#include "sim/potential/barrier.h"
#include "sim/scene/body_entry.h"

namespace pabd {

// As κ of a joint: what suits its masses ("auto").
inline constexpr double kAutoKappa = 0;

// Which keys entries of a type have, as its traits say.
struct JointKeys {
  bool points, moves, angle, twists, twist_free, screw, turn, damped, torque;
  int axes;
};
JointKeys joint_keys(JointType type);

namespace spec {

// The law of a joint's bonds.
struct Law {
  static constexpr const char* object = "joints_default";
  static constexpr const char* help = "Law of joints that say nothing of their own";
  std::optional<BondPotential> potential = {};
  std::optional<double> kappa = {};  // N/m for soft, J for hard; or kAutoKappa
  std::optional<int> N = {};         // hard only
  std::optional<double> d_hat = {};  // hard only; m

  // `otherwise`: what holds where the entry says nothing, when that is no constant.
  void potential_field(auto&& f, std::string_view otherwise = {}) {
    f(may("potential",
          "soft: ½ κ d². hard: the even terms of the polynomial, κ Σ (d/d_hat)^(2m)/(2m) for m = 1 … N/2")
          .or_else(otherwise),
      potential, BondPotential::soft);
  }
  void number_fields(auto&& f, std::string_view otherwise = {}) {
    const bool soft = potential.value_or(BondPotential::soft) == BondPotential::soft;
    f(may("kappa",
          "Stiffness in N/m (soft) or J (hard). auto: the weight of all movable bodies stretches a bond by "
          "1e-8 of the thickness of the thinnest",
          {1e-12, 1e18, soft ? "N/m" : "J"})
          .or_auto()
          .or_else(otherwise),
      kappa, kAutoKappa);
    f(may("N", "Highest order of the hard potential; of an odd N only the even terms count", {2, kMaxOrder})
          .or_else(otherwise),
      N, BondLaw{}.N);
    f(may("d_hat", "Length scale of the hard potential", {1e-9, 1e3, "m"}).or_else(otherwise), d_hat,
      BondLaw{}.d_hat);
  }
  void fields(auto&& f) {
    potential_field(f);
    number_fields(f);
  }
};

// A range of an angle or an offset: lowest and highest; degrees or m. Includes where the joint starts.
using Limits = std::pair<double, double>;

// A motor along the angle of a hinge or the offset of a slider: a torque or force, or a speed.
struct Motor {
  static constexpr const char* help = "A motor: a torque or force, or a speed that it holds";
  std::optional<Profile> force = {};  // over time in s; N m or N
  std::optional<Profile> speed = {};  // degrees/s or m/s
  std::optional<double> most = {};    // force with which the speed is held; N m or N
  std::optional<double> gain = {};    // force per missing speed; N m s/rad or N s/m
  void fields(auto&& f, bool turns) {
    const std::string_view unit = turns ? "N m" : "N";
    const std::string_view named = turns ? "torque" : "force";
    f(may(named, "What it gives: a number, or over time as a drive has it", {-kMostForce, kMostForce, unit})
          .or_value(),
      force);
    f(may("speed", "Speed of j against i that it holds: a number, or over time as a drive has it",
          turns ? kSpinRange : kVelocityRange)
          .or_value(),
      speed);
    f(may(turns ? "max_torque" : "max_force", "The most with which it holds the speed", {0, kMostForce, unit})
          .or_else("as much as it takes"),
      most);
    f(may("gain", "Torque or force for each missing unit of speed",
          {1e-12, kMostForce, turns ? "N m s/rad" : "N s/m"})
          .or_else("as stiff as steps can follow, 1e5 m/h² of the lighter body"),
      gain);
    f.either(named, "speed");
  }
};

// A spring along the angle of a hinge or the offset of a slider.
struct Spring {
  static constexpr const char* help =
      "A spring: the torque or force -stiffness (x - rest), or one by a table. That of an angle takes the "
      "shorter way round";
  std::optional<double> stiffness = {};  // N m/rad or N/m
  std::optional<double> rest = {};       // where it gives nothing; degrees or m
  // In place of `stiffness`: (way from rest, what pulls back); degrees and N m, or m and N.
  std::vector<std::pair<double, double>> table = {};
  void fields(auto&& f, bool turns) {
    f(may("stiffness", "Stiffness", {0, kMostForce, turns ? "N m/rad" : "N/m"}), stiffness);
    f(may("table",
          turns ? "Pairs [angle from rest in degrees, torque that pulls back in N m], in place of stiffness: "
                  "straight between them, and on beyond the first and the last"
                : "Pairs [offset from rest in m, force that pulls back in N], in place of stiffness: "
                  "straight between them, and on beyond the first and the last",
          turns ? kAngleRange : kPositionRange)
          .turning(turns),
      table);
    f(may("rest", "Angle or offset at which it gives nothing", turns ? kAngleRange : kPositionRange), rest,
      0.0);
    f.either("stiffness", "table");
  }
};

// x = ratio × x of the other joint + offset; angles count in rad for the ratio.
struct Follows {
  static constexpr const char* help =
      "Makes the angle or offset ratio × that of another joint + offset: gears, a rack and its pinion, "
      "fingers that close together";
  std::string joint;                  // name of the other one
  double ratio = 1;                   // rad, m per rad, m
  std::optional<double> offset = {};  // degrees or m; empty: as both stand at the start
  void fields(auto&& f, bool turns) {
    f(need("joint", "Name of the other joint, a hinge, slider or cylindrical joint (its offset)"), joint);
    f(need("ratio",
           "Not 0. Angles count in rad, offsets in m: minus the ratio of the teeth for two gears, the radius "
           "of the pinion for a rack",
           {-1e6, 1e6}),
      ratio);
    f(may("offset", "What is added", {-1e6, 1e6, turns ? "degrees" : "m"})
          .or_else("as the two joints stand at the start"),
      offset);
  }
};

inline constexpr Field kCollide = may("collide", "true: the two bodies also collide with each other");

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
  bool collide = false;                  // may the two touch each other?
  std::optional<Vec3> second_axis = {};  // universal: that on j; as axis
  std::vector<Vec3> anchors = {};        // of a scene that was saved in mid-run
  std::vector<Orientation> frames = {};

  void fields(auto&& f) {
    place_fields(f);
    motion_fields(f);
    law_fields(f);
    coupling_fields(f);
  }

  // In the order in which they are read: each part needs the one before.
  void place_fields(auto&& f) {
    const JointKeys has = joint_keys(type);
    f(may("name", "Unique name").or_else("\"joint 3\" for the entry with index 3, counted from 0"), name);
    f(need("bodies",
           "The two bodies i and j by name; null is the world. At least one of them must be movable"),
      i, j);
    f(may("points", "Point a on i and point b on j at the start, world frame", kPositionRange)
          .only(has.points),
      points);
    f(may("anchors",
          "In place of anchor, with frames: where the anchors on i and j stand at the start, world frame. "
          "Scenes that were saved in mid-run have it: there a joint is not at 0",
          kPositionRange)
          .only(!has.points),
      anchors);
    f(may("frames",
          "In place of axis, with anchors: how the frames on i and j stand at the start, as orientations of "
          "bodies; x is the axis. Angle and offset are 0 where the frames coincide")
          .only(!has.points),
      frames);
    f(may("anchor", "Place of the joint at the start, world frame", kPositionRange).only(!has.points),
      anchor);
    f(may("axis", "Direction of the axis at the start, world frame, of any length but zero", kDirectionRange)
          .only(has.axes > 0)
          .as_direction(),
      axis);
    f(may("second_axis",
          "Direction of the axis on j at the start, square to axis, which is that on i; world frame",
          kDirectionRange)
          .only(has.axes > 1)
          .as_direction(),
      second_axis);
  }

  void motion_fields(auto&& f) {
    const JointKeys has = joint_keys(type);
    const Range range = has.angle ? kAngleRange : kPositionRange;
    const std::string_view force_unit = has.torque ? "N m" : "N";
    f(may("length", "Distance at rest", {0, 1e6, "m"}).only(has.points).or_else("the distance at the start"),
      length);
    f(may("arm", "Distance of the points beside the anchor that hold the rotation", kSizeRange)
          .only(!has.points)
          .or_else("half the bounding radius of the smaller body, of a slider or cylindrical joint at least "
                   "as far as the centre of mass of the body that hangs on it"),
      arm);
    f(may("symmetric",
          "true: points on both sides of the anchor for every rotation that is held; false: on one side "
          "only, which moves bodies asymmetrically")
          .only(!has.points),
      symmetric, true);
    f(may("start",
          "Angle or offset at which the joint starts. Bodies, anchors and axes are told at 0; what hangs on "
          "the far side is moved with it. Limits include it in place of 0",
          range)
          .only(has.moves),
      start);
    f(may("limits", "Lowest and highest angle or offset; 0, or start, lies between. Not together with drive",
          range)
          .only(has.moves),
      limits);
    f(may("drive", has.angle ? "Angle; may go round many times" : "Offset",
          has.angle ? kManyTurnsRange : kPositionRange)
          .only(has.moves),
      drive);
    f(may("twist", "Whether j may turn about the axis", kAngleRange).only(has.twists), twist, twist_limits,
      has.twist_free ? Twist::free : Twist::locked);
    f(may("drive",
          "Rotation vector [rx, ry, rz] of j against i, about axes that are the world's at the start and "
          "turn with i",
          kManyTurnsRange)
          .only(has.turn),
      turn);
    f(may("axes",
          "Along which of those axes points of j are held by the drive: one leaves j free to turn about it, "
          "two or three hold it entirely")
          .only(has.turn)
          .one_of({"x", "y", "z", "xy", "xz", "yz", "xyz"})
          .or_else("xyz"),
      axes, [this](double) { return std::string_view(turn ? "xyz" : ""); });
    f(may("motor", "What moves j against i. Not together with drive").only(has.moves).turning(has.angle),
      motor);
    f(may("damping", "Viscous damping. Not together with drive",
          {0, kMostForce, has.torque ? "N m s/rad" : "N s/m"})
          .only(has.damped),
      damping);
    f(may("friction", "Dry friction: holds up to so much, and brakes with it", {0, kMostForce, force_unit})
          .only(has.moves),
      friction);
    f(may("spring", "What pulls j back. Not together with drive").only(has.moves).turning(has.angle), spring);
  }

  void law_fields(auto&& f) {
    law.potential_field(f, "that of joints_default");
    law.number_fields(f, "that of joints_default, or auto where the potential is another");
    f(kCollide, collide, false);
  }

  void coupling_fields(auto&& f) {
    const JointKeys has = joint_keys(type);
    f(may("follows", "The joint that it goes along with. Not together with drive")
          .only(has.moves)
          .turning(has.angle),
      follows);
    f(may("lead",
          "Of a screw: how far j moves along the axis in a turn, in m; below 0, left-handed. Not together "
          "with follows or drive",
          {-1e6, 1e6})
          .only(has.screw),
      lead);
  }
};

}  // namespace spec
}  // namespace pabd
