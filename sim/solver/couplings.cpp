// SPDX-License-Identifier: MIT
#include "sim/solver/couplings.h"

#include <algorithm>
#include <cmath>

#include "sim/joint/action.h"
#include "sim/solver/joint_actions.h"

namespace pabd {
namespace {

// Coordinates that a coupling is between.
struct Coordinates {
  const Joint &follower, &leader;
  const JointMeasure &of_follower, &of_leader;
};
Coordinates coordinates_of(std::span<const Joint> joints, const Joint& follower) {
  const Joint& leader = joints[follower.follows->leader];
  return {follower, leader, *coupled_measure(follower), *leading_measure(follower, leader)};
}
Coordinates coordinates_of(const Problem& p, const CouplingStep& coupling) {
  return coordinates_of(p.joints.model, p.joints[coupling.follower]);
}

// How far it goes in free flight.
double coming(const Problem& p, const Joint& joint, const JointMeasure& measure) {
  const PlacedFrames f = frames_at_start(joint, p);
  return way_of_motion(measure.of, f, in_flight(p, joint.i), in_flight(p, joint.j));
}

double value_at_start(const Problem& p, const Joint& joint, const JointMeasure& measure) {
  const PlacedFrames f = frames_at_start(joint, p);
  return measure.value(f.i, f.j);
}

// Of a joint along its coordinate, where it is held; N/m, N m/rad.
double stiffness_along(const Problem& p, Index joint, const JointMeasure& measure) {
  const double arm = p.joints[joint].arm;
  return evaluate(p.law_of(joint), 0.0).second * (measure.of == JointMeasure::Of::angle ? 2 * arm * arm : 1);
}

}  // namespace

const JointMeasure* coupled_measure(const Joint& joint) { return moved_measure(traits_of(joint.type)); }

const JointMeasure* leading_measure(const Joint& follower, const Joint& leader) {
  const bool screw = &follower == &leader;
  return screw ? measure_with(traits_of(leader.type), &Joint::twist_limits) : coupled_measure(leader);
}

double coupling_error(const Model& model, const State& state, const Joint& follower) {
  const Coordinates x = coordinates_of(model.joints, follower);
  const auto value = [&](const Joint& joint, const JointMeasure& measure) {
    const PlacedFrames f = place(joint, state);
    return measure.value(f.i, f.j);
  };
  const JointCoupling& coupling = *follower.follows;
  const double error =
      value(follower, x.of_follower) - coupling.ratio * value(x.leader, x.of_leader) - coupling.offset;
  return x.of_follower.of == JointMeasure::Of::angle ? std::remainder(error, 2 * kPi) : error;
}

void start_couplings(Problem& p, Iterate& it) {
  it.coupling.clear();
  p.following.clear();
  if (p.followers.empty()) return;
  p.following.assign(p.joints.model.size(), -1);
  const std::vector<double>& known = p.start->coupling;
  for (const Index k : p.followers) {
    const Joint& joint = p.joints[k];
    const JointCoupling& follows = *joint.follows;
    p.following[k] = static_cast<Index>(it.coupling.size());
    const Coordinates x = coordinates_of(p.joints.model, joint);
    CouplingStep step;
    step.follower = k;
    step.error = known.size() == p.followers.size() ? known[it.coupling.size()]
                                                    : coupling_error(*p.model, *p.start, joint);
    step.start = value_at_start(p, joint, x.of_follower);
    step.start_leader = value_at_start(p, x.leader, x.of_leader);
    step.coming = coming(p, joint, x.of_follower);
    step.coming_leader = coming(p, x.leader, x.of_leader);
    step.stiffness =
        std::min(stiffness_along(p, k, x.of_follower),
                 stiffness_along(p, follows.leader, x.of_leader) / (follows.ratio * follows.ratio));
    it.coupling.push_back(step);
  }
}

double coupling_error(const Problem& p, const Iterate& it, Index n) {
  const CouplingStep& step = it.coupling[n];
  const Coordinates x = coordinates_of(p, step);
  const PlacedFrames f = frames_of(x.follower, it), l = frames_of(x.leader, it);
  return step.error + way_from(x.of_follower, step.start, step.coming, f) -
         x.follower.follows->ratio * way_from(x.of_leader, step.start_leader, step.coming_leader, l);
}

double coupling_energy(const Problem& p, const Iterate& it, Index n) {
  const double error = coupling_error(p, it, n);
  return 0.5 * it.coupling[n].stiffness * error * error;
}

double coupling_force(const Problem& p, const Iterate& it, Index n) {
  return -it.coupling[n].stiffness * coupling_error(p, it, n);
}

LinearCoupling linearize_coupling(const Problem& p, const Iterate& it, Index n) {
  const CouplingStep& step = it.coupling[n];
  const Coordinates x = coordinates_of(p, step);
  LinearCoupling out{coupling_error(p, it, n), step.stiffness, {}};
  const auto add = [&](Index body, const Vec6& gradient) {
    if (!p.movable(body)) return;
    const auto last = out.ends.begin() + out.count;
    const auto at = std::find_if(out.ends.begin(), last, [&](const auto& end) { return end.body == body; });
    if (at == last) {
      *at = {body, gradient};
      ++out.count;
    } else {
      at->gradient += gradient;
    }
  };
  const auto add_joint = [&](const Joint& joint, const JointMeasure& measure, double share) {
    const PlacedFrames f = frames_of(joint, it);
    const auto [of_i, of_j] =
        gradient_of_way(measure.of, f, it.pose[it.slot(joint.i)].c, it.pose[it.slot(joint.j)].c);
    add(joint.i, share * of_i);
    add(joint.j, share * of_j);
  };
  add_joint(x.follower, x.of_follower, 1);
  add_joint(x.leader, x.of_leader, -x.follower.follows->ratio);
  return out;
}

CoupledBody couple_body(const Problem& p, const Iterate& it, Index i) {
  CoupledBody out;
  if (p.followers.empty()) return out;
  for (const Index n : p.couplings_at[i]) {
    const LinearCoupling c = linearize_coupling(p, it, n);
    out.energy += 0.5 * c.stiffness * c.error * c.error;
    for (int k = 0; k < c.count; ++k) {
      const auto& [body, gradient] = c.ends[k];
      if (body != i) continue;
      out.g += c.stiffness * c.error * gradient;
      out.H += c.stiffness * gradient * gradient.transpose();
    }
  }
  return out;
}

double coupling_energy_of_body(const Problem& p, const Iterate& it, Index i) {
  double energy = 0;
  if (p.followers.empty()) return energy;
  for (const Index n : p.couplings_at[i]) energy += coupling_energy(p, it, n);
  return energy;
}

}  // namespace pabd
