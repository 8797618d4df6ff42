// SPDX-License-Identifier: MIT
// Joints of the supplement's section 2 between two bodies, or a body and the world, as constant data. Each type has a file of its
// own with its equations and words (sim/joint/joint_traits.h).
//
// Frames: column 0 of F is the joint's axis n, columns 1 and 2 complete it to a right-handed frame. A
// second axis is column 1, on j. At the start pose the two frames coincide. Angle φ: right-hand rule about n,
// j relative to i, zero at the start pose. Offset λ: of j's anchor from i's along the axis, measured as S(15)
// does, zero at the start pose.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/force_table.h"
#include "sim/body/keyed.h"
#include "sim/body/rare.h"
#include "sim/math/types.h"

namespace pabd {

// Law of the bonds a joint is made of (bond/point_bond.h).
enum class BondPotential : std::uint8_t { soft, hard };

struct BondLaw {
  BondPotential potential = BondPotential::soft;
  int N = 4;            // hard only
  double kappa = 1;     // N/m for soft, J for hard
  double d_hat = 0.01;  // m; hard only
};

inline constexpr Index kWorld = -1;  // instead of a body number

// Every type of joint, one a line. A new one is a line at the end, for colours and bits go by order, and a file
// in sim/joint that defines joints::NAME.
#define PABD_JOINT_TYPES(X) \
  X(spherical)              \
  X(hinge)                  \
  X(slider)                 \
  X(fixed)                  \
  X(distance)               \
  X(universal)              \
  X(cylindrical)

enum class JointType : std::uint8_t {
#define PABD_TYPE(name) name,
  PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
};

inline constexpr std::array kJointTypes{
#define PABD_TYPE(name) JointType::name,
    PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
};

// The word of scene files, and back; empty for a word that is none.
const char* to_string(JointType type);
std::optional<JointType> joint_type(std::string_view word);

enum class Twist : std::uint8_t { free, locked, limited };

struct JointRange {
  double lo, hi;
};

using Profile = Keyed<double>;    // rad or m
using TurnProfile = Keyed<Vec3>;  // rotation vector in the joint's frame on i; rad

// Anchor and frame in the frame of one body (of the world for kWorld).
struct JointFrame {
  Vec3 r;
  Mat3 F;
};

// Turns or pushes j against i along the joint's angle or offset.
struct JointMotor {
  enum class Gives : std::uint8_t { force, speed };
  Gives gives = Gives::force;
  Profile profile;                                        // over time; force: N m or N; speed: rad/s or m/s
  double most = std::numeric_limits<double>::infinity();  // force with which a speed is held; N m or N
  double gain = 0;  // force per missing speed; N m s/rad or N s/m; 0: as stiff as steps can follow
};

// Pulls the angle or offset of a joint back to where it is at rest.
struct JointSpring {
  double stiffness = 0;   // N m/rad or N/m; 0: none
  double rest = 0;        // rad, in [−π, π], or m
  ForceTable table = {};  // in place of `stiffness`: what pulls back over the way from rest

  bool pulls() const { return stiffness > 0 || !table.points.empty(); }
};

// What acts along the angle, offset or length of a joint, or on the turn of a ball, beside what holds it
// (sim/joint/action.h). The same on both bodies, the other way round.
struct JointAction {
  std::optional<JointMotor> motor;
  double damping = 0;   // viscous; N m s/rad or N s/m
  double friction = 0;  // dry: holds up to so much, and brakes with it; N m or N
  JointSpring spring = {};
};

// What a joint leaves free follows what another one does: gears, a rack, a finger that closes with its neighbour.
//
//   x = ratio × x of the leader + offset      angles in rad, offsets in m
//
// A joint that leads itself is a screw: its offset follows its angle.
struct JointCoupling {
  Index leader = -1;  // number of the other joint
  double ratio = 1;   // rad, m per rad, m of the leader
  double offset = 0;  // rad or m
};

// What few joints have (limits, drives) is out of line, so that a million joints fit in 0.3 GB.
struct Joint {
  std::string name;  // may be empty
  JointType type = JointType::spherical;
  Twist twist = Twist::locked;  // of a joint that moves along its axis
  std::uint8_t arms = 7;        // spherical with a turn: bit k, the points along column k of F are held
  // Two bonds a rotational degree of freedom; false: one, as the supplement warns of.
  bool symmetric : 1 = true;
  bool collide : 1 = false;    // its two bodies may touch each other
  bool on_second : 1 = false;  // of one that moves along its axis: the points go with j, not with i
  bool usual_arm : 1 = false;  // nobody chose `arm`
  Index i = kWorld, j = kWorld;
  float limit_scale = 1;  // stiffness of limits as part of κ
  Rare<JointAction> action;
  Rare<JointCoupling> follows;
  JointFrame on_i, on_j;
  Rare<JointRange> limits;        // hinge: angle, rad, in [−π, π]; slider: offset, m
  Rare<Profile> drive;            // of the same quantity
  Rare<TurnProfile> turn;         // spherical: the rotation of j against i
  Rare<JointRange> twist_limits;  // limited twist; rad, in [−π, π]
  double length = 0;              // distance joint: rest length; m
  double arm = 0.5;               // of the points beside the anchor; m
  BondLaw law;
};

}  // namespace pabd
