// SPDX-License-Identifier: MIT
// What acts along a joint: motors, dampers, springs, dry friction (Deviation D22). A potential of the way Δ that its angle, offset
// or length goes in a step of length h, and so a part of E like any bond:
//
//   W = −F Δ                      a motor that gives the force (or torque) F
//     + c/(2h′) (Δ − Δ₀)²         a damper; of a ball c/(2h′) ‖θ‖², θ the rotation vector of j against i
//     + s/2 (x + Δ)²              a spring, x from its rest at the start, of an angle the shorter way round; with a table ∫ F
//     + P(Δ − h v; k, f)          a motor that gives the speed v; friction, with v = 0
//
//   (Δ − Δ₀)/h′ is the speed at the end of the step: Δ/h by Euler; solver/second_order.h gives h′ and Δ₀ otherwise.
//
//   P(u; k, f) = ½ k u² where k |u| ≤ f, else f (|u| − f/2k): a force of at most f. Without a gain k is 1e5 m/h² of the lighter
//   body, for `sissm` at most the joint's own stiffness: what holds creeps by F/k a step. A gain (force per missing speed)
//   makes it gain/h′, with Δ − Δ₀ − h′ v.
//
// v is one that the step can reach: it may change the spin of what turns by less than 1/h (D8). The force −W' is that of the end of
// the step, so that it brakes at most to the speed it wants, for every h. Both bodies feel it at the same point of the world.
//
// P has a corner at each end, and a solver that sees both turns back and forth between them. So a hold has a state, with a smooth
// potential: it holds without bound, or gives way with ±f. What stands against that changes the state (settle_action). A
// corner is only f/k wide, some 1e-7 rad, less than an iterate is off: the force that a solver foresees by its linear model decides.
#pragma once

#include <optional>
#include <utility>

#include "sim/joint/joint_traits.h"

namespace pabd {

// A part P of W.
struct ActionHold {
  enum class State : std::uint8_t { holds, gives_way_up, gives_way_down, undecided };
  double way = 0;        // that it wants in the step; rad or m
  double stiffness = 0;  // k; N m/rad or N/m
  double most = 0;       // f; N m or N
  bool follows = false;  // a speed, by a gain: u = Δ − Δ₀ − h′ v
  State state = State::holds;
  int changes = 0;
};

// W of one joint in a step.
struct ActionStep {
  double start = 0;                   // angle, offset or length at the start of the step; rad or m
  std::optional<double> ahead;        // Δ that a solver foresees; rad or m
  double expected = 0;                // Δ in free flight, which decides whole turns; rad
  double coasts = 0;                  // Δ₀; rad or m
  double part = 1;                    // h′/h
  Mat3 turned = Mat3::Identity();     // of a ball: j against i at the start
  Mat3 coasted = Mat3::Identity();    // of a ball: the same where θ = 0
  double force = 0;                   // F
  double damping = 0;                 // c/h′; N m/rad or N/m
  double spring = 0, away = 0;        // s and x; N m/rad or N/m, rad or m
  const ForceTable* table = nullptr;  // of the joint's spring, in place of s
  std::array<ActionHold, 2> hold{};   // the motor's and the friction's; f = 0: none
};

// A small motion of a body.
struct SmallMotion {
  Vec3 c;         // its centre; world, m
  Vec3 go, turn;  // of the centre, m; about it, rad

  Vec3 at(const Vec3& y) const { return go + turn.cross(y - c); }
};

// Where bodies are predicted to be, and how they move there in h′: the speed at the end of a step of second order is that
// one, and what they go beside it over h′.
struct Coasting {
  double h;  // h′; s
  PlacedFrames at;
  SmallMotion i, j;
};

// How far an angle, offset or length goes by small motions of its bodies, to first order; and how fast with moves (δc, δω)
// of i and of j, which have their centres there.
double way_of_motion(JointMeasure::Of of, const PlacedFrames& at, const SmallMotion& i, const SmallMotion& j);
std::pair<Vec6, Vec6> gradient_of_way(JointMeasure::Of of, const PlacedFrames& at, const Vec3& c_i,
                                      const Vec3& c_j);

// From `start` to where the frames stand. An angle is known up to whole turns: the one nearest to `expected`.
double way_from(const JointMeasure& measure, double start, double expected, const PlacedFrames& at);

// A step of length h that ends at `time`.
struct ActionStart {
  double h, time;                    // s
  SmallMotion i, j;                  // of the bodies in free flight
  double stiffness;                  // of what holds; N/m
  double inertia;                    // about the joint's axis, of the body that turns more easily; kg m²
  std::optional<Coasting> coasting;  // empty: by Euler
};
// When it begins, with the frames where they stand. Precondition: the joint has an action, of which its type allows all
// (may_be_damped, moved_measure).
ActionStep start_action(const Joint& joint, const PlacedFrames& at, const ActionStart& start);

// Adds the bonds that W makes at the place of the frames. Their gradients are exact; their weights together are W''
// along the way, and nothing for moves along which W stays.
void add_action(const Joint& joint, const ActionStep& action, const PlacedFrames& at, BondList& out);

// Energy of its spring with the frames there; J.
double spring_energy(const Joint& joint, const PlacedFrames& at);

// Work of the force that W gives there on the way to there, but for that of the spring, which keeps it, and for what follows
// the speed in a step of second order with its force at the mean speed, Δ/h; J.
double work_of_action(const Joint& joint, const ActionStep& action, const PlacedFrames& at);

// Fills action.ahead: the bodies are about to move so.
void foresee_way(const Joint& joint, const PlacedFrames& at, const SmallMotion& i, const SmallMotion& j,
                 ActionStep& action);

// Do its holds stand as they should where it was foreseen to go, or else there? Changes those that do not; false if any
// did. `doubt`: by how much the place of j may still be off, so that what is no further from the corner is left as it
// is; m. Nothing that was foreseen is in doubt.
bool settle_action(const Joint& joint, const PlacedFrames& at, double doubt, ActionStep& action);

}  // namespace pabd
