// Joints of the supplement's section 2: what joins two bodies, or a body and the world, as plain constant
// data. Each type is expanded to point bonds by a file of its own (expand.h).
//
// Frames: column 0 of F is the joint's axis n, columns 1 and 2 complete it to a right-handed frame. At the
// start pose the two frames coincide. Angle φ: right-hand rule about n, j relative to i, zero at the start
// pose. Offset λ: of j's anchor from i's along the axis, measured as S(15) does, zero at the start pose.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/body/rare.h"
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
template <class Value>
struct Keyed {
  std::vector<std::pair<double, Value>> keys;  // (s, value), rising times, at least one
  Value at(double time) const;
};
using Profile = Keyed<double>;    // rad or m
using TurnProfile = Keyed<Vec3>;  // rotation vector in the joint's frame on i; rad

// Anchor and frame in the frame of one body (of the world for kWorld).
struct JointFrame {
  Vec3 r;
  Mat3 F;
};

// What few joints have (limits, drives) is out of line, so that a million joints fit in 0.3 GB.
struct Joint {
  std::string name;  // may be empty
  JointType type = JointType::spherical;
  Twist twist = Twist::locked;  // slider
  std::uint8_t arms = 7;        // spherical with a turn: bit k, the points along column k of F are held
  bool symmetric = true;  // two bonds a rotational degree of freedom; false: one, as the supplement warns of
  Index i = kWorld, j = kWorld;
  float limit_scale = 1;  // stiffness of limits as part of κ
  JointFrame on_i, on_j;
  Rare<JointRange> limits;        // hinge: angle, rad, in [−π, π]; slider: offset, m
  Rare<Profile> drive;            // of the same quantity
  Rare<TurnProfile> turn;         // spherical: the rotation of j against i
  Rare<JointRange> twist_limits;  // slider with limited twist; rad, in [−π, π]
  double length = 0;              // distance joint: rest length; m
  double arm = 0.5;               // of the points beside the anchor; m
  BondLaw law;
};

}  // namespace pabd
