// Arrays that one step fills and the next reuses. Nothing here influences a result from one step to the next.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "sim/body/joint.h"
#include "sim/body/state.h"
#include "sim/bond/contact_bond.h"
#include "sim/collision/detect.h"
#include "sim/math/elimination.h"
#include "sim/math/stop.h"
#include "sim/solver/time_step.h"

namespace pabd {

// Bodies or contacts that a thread takes at a time: some ten microseconds of work.
inline constexpr std::size_t kBlock = 64;

// One end of a contact patch, in the list of its body.
struct BondEnd {
  Index patch;
  Index other;  // body at the other end
  bool is_a;
  bool owner;  // of the two ends that move, the one that moves the friction bound
};

// Last step of a body in `descent`, before it was stretched.
struct LastStep {
  Vec3 dc, dw;
  double squared;  // ‖dc‖² + (radius ‖dw‖)²; m²
  double stretch;
};

// The joints of a step by number: those of the model, then the pulls.
struct StepJoints {
  std::span<const Joint> model, pulls;
  std::size_t size() const { return model.size() + pulls.size(); }
  const Joint& operator[](std::size_t k) const {
    return k < model.size() ? model[k] : pulls[k - model.size()];
  }
};

enum class IslandSolver : std::uint8_t { descent, newton };

// What a factorisation of the islands without joints would cost.
struct IslandChoice {
  std::vector<Index> row;      // body to row of `graph`, −1: not in question
  std::vector<Index> patches;  // of each island
  struct Cost {
    double products = 0;  // of blocks
    double lightest = std::numeric_limits<double>::infinity(), heaviest = 0;
    double way = 0;  // longest of a body in a step; m
  };
  std::vector<Cost> cost;  // of each island
  Elimination::Pairs pairs;
  Elimination graph;
};

// Of each island, at its root in `parent`; see energy_bound.h.
struct EnergyBound {
  std::vector<double> budget, energy;   // J
  std::vector<double> part, low, high;  // of the way
  std::vector<Index> held;
  std::vector<Pose> end;  // of the solve, one a body
};

struct NewtonSystem;

// Bodies that felt each other in a step and that nothing outside held (momentum.h).
struct FreeGroup {
  Index count = 0;
  double mass = 0;
  Vec3 origin = Vec3::Zero();               // of moments; world, m
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();  // what its momentum should be
  Vec3 missing_P, missing_L;                // of that
  Vec3 centre;                              // of mass, from the origin; m
  Mat3 I;                                   // about it; kg m²
  Vec3 v, omega;                            // rigid motion that is missing
  Mat3 turn;                                // its rotation in a step
};
struct FreeGroups {
  std::vector<Index> parent, number;
  std::vector<std::uint8_t> held;
  std::vector<FreeGroup> group;
  std::vector<std::pair<Index, Index>> bodies;  // and their groups
};

struct StepWorkspace::Impl {
  // Predicted poses Q* and current iterate, one entry a body, and the identity for the world.
  std::vector<Pose> star, pose;
  std::vector<Vec3> v, omega;  // velocities of free flight
  std::vector<Vec3> turn;      // rotation vectors of free flight, of any length

  Stop stop;  // of the step

  // Contacts of the step.
  CollisionWorkspace collision;
  std::vector<Vec3> c_detect;  // where bodies are looked at
  std::vector<Mat3> R_detect;
  std::vector<double> reach;
  std::vector<ContactPoint> points;
  std::vector<ContactPatch> patches;
  std::vector<Rolling> rolling;     // of the separate ones
  std::vector<Roll> roll;           // per body, at its pose; kept for those that have such a patch
  std::vector<std::uint8_t> rolls;  // per body: has it one?
  std::vector<std::uint8_t> off;    // per patch: did its friction break the law in the last iterate?
  ContactLaw law;

  // Which patches end at which body: ends[first_end[i]] … ends[first_end[i + 1] − 1].
  std::vector<Index> first_end;
  std::vector<BondEnd> ends;

  std::vector<Joint> pulls;  // of this step, from the world to a movable body
  StepJoints all_joints;

  std::vector<double> joint_share;  // of the stiffness of each joint of the step, see stiffness_cap.h

  // Joints of each body: joints[first_joint[i]] … joints[first_joint[i + 1] − 1].
  std::vector<Index> first_joint, joints;
  std::vector<Index> cursor, parent;  // scratch

  // The solver of each island, at its root in `parent`.
  std::vector<IslandSolver> solver_of;
  IslandChoice choice;

  // Bodies that `newton` solves; the others with bonds are coloured.
  std::vector<Index> newton;
  std::vector<std::uint8_t> is_newton;  // per body, and 0 for the world
  std::unique_ptr<NewtonSystem> system;
  std::vector<Index> solved;  // all bodies that have bonds

  // Bodies that have bonds, grouped by colour: no two of one colour share a bond.
  std::vector<Index> color;    // per body, −1: nothing to solve
  std::vector<Index> colored;  // body numbers, colour by colour
  std::vector<Index> first_of_color;

  // sissm: affine iterate before the projection.
  std::vector<Mat3> A;
  std::vector<Vec3> affine_c;
  std::vector<Pose> next;
  std::vector<double> radius;  // bounding radius; m
  std::vector<double> moved;   // per body: displacement in this iteration over d̂
  std::vector<LastStep> last_step;
  std::vector<std::uint8_t> rests;  // per body: left alone in the last sweep of descent
  std::vector<double> projected;    // per body: ‖A − R‖
  EnergyBound energy_bound;
  std::vector<double> flight;  // per body: kinetic energy after free flight; J
  std::vector<Pose> start;     // where the step starts, for runaway.cpp

  FreeGroups groups;

  Impl();
  ~Impl();

  // To be called when w.pose[i].R has changed, or is about to be tried.
  void set_roll(Index i, const Mat3& R) {
    if (rolls[i]) roll[i] = roll_since_prediction(star[i].R, R);
  }

  // Index of a body's pose; the world has the last one.
  std::size_t slot(Index body) const { return body < 0 ? pose.size() - 1 : static_cast<std::size_t>(body); }

  std::span<const Index> joints_of(Index body) const {
    const auto i = static_cast<std::size_t>(body);
    return {joints.data() + first_joint[i], static_cast<std::size_t>(first_joint[i + 1] - first_joint[i])};
  }

  std::span<const BondEnd> ends_of(Index body) const {
    const auto i = static_cast<std::size_t>(body);
    return {ends.data() + first_end[i], static_cast<std::size_t>(first_end[i + 1] - first_end[i])};
  }
};

}  // namespace pabd
