// Joints of the supplement's section 2: what joins two bodies, or a body and the world, as plain constant
// data. Each type is expanded to point bonds by a file of its own (expand.h).
//
// Frames: column 0 of F is the joint's axis n, columns 1 and 2 complete it to a right-handed frame. At the
// start pose the two frames coincide. Angle φ: right-hand rule about n, j relative to i, zero at the start
// pose. Offset λ: of j's anchor from i's along the axis, measured as S(15) does, zero at the start pose.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

// Law of the bonds a joint is made of (bond/point_bond.h).
enum class BondPotential : std::uint8_t { soft, hard };

struct BondLaw {
  BondPotential potential = BondPotential::soft;
  double kappa = 1;     // N/m for soft, J for hard
  double d_hat = 0.01;  // m; hard only
  int N = 4;            // hard only
};

inline constexpr Index kWorld = -1;  // instead of a body number

enum class JointType : std::uint8_t { spherical, hinge, slider, fixed, distance };
const char* to_string(JointType type);

enum class Twist : std::uint8_t { free, locked, limited };

struct JointRange {
  double lo, hi;
};

// Piecewise linear in time; constant before the first and after the last key.
struct Profile {
  std::vector<std::pair<double, double>> keys;  // (s, rad or m), rising times, at least one
  double at(double time) const;
};

// Anchor and frame in the frame of one body (of the world for kWorld).
struct JointFrame {
  Vec3 r;
  Mat3 F;
};

struct Joint {
  std::string name;
  JointType type = JointType::spherical;
  Index i = kWorld, j = kWorld;
  JointFrame on_i, on_j;
  std::optional<JointRange> limits;  // hinge: angle, rad; slider: offset, m
  std::optional<Profile> drive;      // of the same quantity
  Twist twist = Twist::locked;       // slider
  JointRange twist_limits{0, 0};     // rad
  double length = 0;                 // distance joint: rest length; m
  double arm = 0.5;                  // of the points beside the anchor; m
  bool symmetric = true;  // two bonds a rotational degree of freedom; false: one, as the supplement warns of
  BondLaw law;
};

}  // namespace pabd
