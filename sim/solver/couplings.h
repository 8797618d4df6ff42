// SPDX-License-Identifier: MIT
// Joints that follow others (JointCoupling): what each adds to E, with the two coordinates x, x′ of follower and leader:
//
//   c = x − ratio x′ − offset          unwound: an angle counts its turns                   rad or m
//   E = s/2 c²                         s as stiff as the joints themselves are along x      J
//
// c is carried from step to step (State::coupling): an angle alone does not know its whole turns.
#pragma once

#include <array>

#include "sim/solver/problem.h"

namespace pabd {

// What may move along with it: the coordinate that a joint is coupled by. Null where its type has none.
const JointMeasure* coupled_measure(const Joint& joint);
// Of the leader: of a screw its angle.
const JointMeasure* leading_measure(const Joint& follower, const Joint& leader);

// c where the bodies stand, whole turns left out; rad or m.
double coupling_error(const Model& model, const State& state, const Joint& follower);

// Fills it.coupling and p.following for the joints of p.followers.
void start_couplings(Problem& p, Iterate& it);

// Its place in it.coupling; −1 for a joint that follows none.
inline Index coupling_of(const Problem& p, Index joint) {
  return p.following.empty() || static_cast<std::size_t>(joint) >= p.following.size() ? -1
                                                                                      : p.following[joint];
}

// c of coupling n at the iterate.
double coupling_error(const Problem& p, const Iterate& it, Index n);
// What it adds to E; J.
double coupling_energy(const Problem& p, const Iterate& it, Index n);
// −s c: force or torque along the follower's coordinate; the leader has −ratio times that. N or N m.
double coupling_force(const Problem& p, const Iterate& it, Index n);

// c and its gradient with respect to the moves (δc, δω) of its bodies.
struct LinearCoupling {
  struct End {
    Index body;
    Vec6 gradient;
  };
  double error, stiffness;
  std::array<End, 4> ends;  // of movable bodies
  int count = 0;
};
LinearCoupling linearize_coupling(const Problem& p, const Iterate& it, Index n);

// Energy, gradient and weight of the couplings of body i at the iterate.
struct CoupledBody {
  double energy = 0;
  Vec6 g = Vec6::Zero();
  Mat6 H = Mat6::Zero();
};
CoupledBody couple_body(const Problem& p, const Iterate& it, Index i);
double coupling_energy_of_body(const Problem& p, const Iterate& it, Index i);

}  // namespace pabd
