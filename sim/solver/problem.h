// SPDX-License-Identifier: MIT
// What a step minimises, and the iterate that its solvers move: plain arrays, numbered as bodies, manifolds and joints are. A copy
// of an iterate stands for itself.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/bond/turn_friction.h"
#include "sim/joint/action.h"
#include "sim/math/row_list.h"
#include "sim/solver/free_flight.h"
#include "sim/solver/inertia.h"
#include "sim/solver/params.h"

namespace pabd {

// One end of a contact manifold, in the list of its body.
struct ManifoldEnd {
  Index manifold;
  Index other;  // body at the other end
  bool is_a;
  bool owner;  // of the two ends that move, the one that moves the friction bound
};

using BodyPairs = std::vector<std::pair<Index, Index>>;

// The joints of a step by number: those of the model, then the pulls.
struct StepJoints {
  std::span<const Joint> model, pulls;
  std::size_t size() const { return model.size() + pulls.size(); }
  const Joint& operator[](Index k) const {
    const auto n = static_cast<std::size_t>(k);
    return n < model.size() ? model[n] : pulls[n - model.size()];
  }
};

// Constant while a step is solved.
struct Problem {
  const Model* model = nullptr;
  const Params* params = nullptr;
  const State* start = nullptr;
  const Flight* flight = nullptr;
  double time = 0;  // at the end of the step, for driven joints; s
  ContactLaw law{};
  bool is_half = false;             // StepOptions::is_half
  bool friction = false;            // may any contact have some?
  StepJoints joints;                // those of the model, then the pulls
  std::vector<double> joint_share;  // of the stiffness of each joint, see cap_stiffness
  RowList<ManifoldEnd> ends;        // per body: manifolds that end there
  RowList<Index> joints_at;         // per body: joints that end there
  BodyPairs joint_ends;             // of each joint: a joint itself takes some hundred bytes
  std::vector<std::uint8_t>
      works;                  // per joint: may it do work, by a drive or an action? Reading joints takes long
  std::vector<Index> acting;  // joints with an action
  std::vector<Index> action_at;     // per joint: place among them, or −1; empty where there are none
  std::vector<Index> followers;     // joints that follow others; the number of a coupling is its place here
  std::vector<Index> following;     // per joint: its coupling, or −1; empty where there are none
  RowList<Index> couplings_at;      // per body; not filled where there are none
  std::vector<std::uint8_t> rolls;  // per body: has it a manifold whose slip follows its roll?

  bool movable(Index i) const { return i != kWorld && !model->fixed[i]; }
  // Is the step of body i of second order (second_order.h)?
  bool second_order(Index i) const { return flight->h[i] != params->h; }
  // The same of what a joint joins.
  bool second_order(const Joint& joint) const {
    const Index moving = movable(joint.i) ? joint.i : joint.j;
    return movable(moving) && second_order(moving);
  }
  // The least value(i) of those of two bodies that move; infinite where none does.
  template <class Value>
  double least_of(Index a, Index b, const Value& value) const {
    double least = kInfinity;
    for (const Index i : {a, b})
      if (movable(i)) least = std::min(least, value(i));
    return least;
  }
  // Of a body or the world.
  Pose start_pose(Index i) const {
    return i == kWorld ? Pose{Vec3::Zero(), Mat3::Identity()} : Pose{start->c[i], start->R[i]};
  }

  Inertia inertia(Index i) const {
    const double h = flight->h[i];
    return {model->mass[i], model->J[i], flight->star[i], 1 / (h * h)};
  }

  // Laws of a contact manifold and of a joint in this step: `sissm` caps their stiffness.
  ContactLaw law_of(const ContactManifold& manifold) const { return scaled(law, manifold.share); }
  BondLaw law_of(Index joint) const {
    BondLaw out = joints[joint].law;
    out.kappa *= joint_share[joint];
    return out;
  }
};

// A coupling of two joints in a step; see couplings.h.
struct CouplingStep {
  Index follower;
  double error;                  // c at the start; rad or m
  double start, start_leader;    // coordinates there
  double coming, coming_leader;  // how far they go in free flight
  double stiffness;              // s; N m/rad or N/m
};

// Where a solve stands.
struct Iterate {
  std::vector<Pose> pose;          // of each body, and of the world at the end
  std::vector<double> moved;       // per body: way in the last iteration over d̂
  std::vector<Vec3> joint_force;   // of each joint of the model on its body j, as far as the solver knows; N
  std::vector<ActionStep> action;  // of Problem::acting
  std::vector<CouplingStep> coupling;     // of Problem::followers
  std::vector<ContactManifold> manifold;  // sorted by pair of bodies, then by feature
  std::vector<TurnFriction> turning;      // see ContactManifold::turning
  std::vector<Rolling> rolling;           // of the separate manifolds
  std::vector<Roll> roll;                 // per body, at its pose; kept where Problem::rolls

  Rolls rolls() const { return {roll.data(), rolling.data()}; }
  // Index of a body's pose.
  std::size_t slot(Index body) const { return body < 0 ? pose.size() - 1 : static_cast<std::size_t>(body); }
};

// Which bodies have bonds with which: what islands and colours follow from.
struct BondGraph {
  std::size_t bodies = 0, model_joints = 0;
  BodyPairs couplings;  // of joints
  std::vector<std::uint8_t> fixed;
  BodyPairs joints, manifolds;
};

// Fills p.joint_ends, p.acting, p.ends and p.joints_at from the joints and manifolds. False: `last`, the graph of the
// call before, is still that of the problem, and so are all that follows from it.
bool list_bonds(Problem& p, const Iterate& it, BondGraph& last);

// The frames of a joint at the iterate, and where the step starts.
inline PlacedFrames frames_of(const Joint& joint, const Iterate& it) {
  return place(joint, [&](Index body) -> const Pose& { return it.pose[it.slot(body)]; });
}
inline PlacedFrames frames_at_start(const Joint& joint, const Problem& p) {
  return place(joint, [&](Index body) { return p.start_pose(body); });
}

// A body's pose and its roll change together.
inline void set_pose(const Problem& p, Index i, const Pose& pose, Iterate& it) {
  it.pose[i] = pose;
  if (p.rolls[i]) it.roll[i] = roll_since_prediction(p.flight->star[i].R, pose.R);
}

[[gnu::always_inline]] inline ContactState state_of(const Iterate& it, const ContactManifold& manifold) {
  return contact_state(manifold, it.pose[manifold.a], it.pose[manifold.b], it.rolls());
}

}  // namespace pabd
