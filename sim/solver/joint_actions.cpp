// SPDX-License-Identifier: MIT
#include "sim/solver/joint_actions.h"

#include <algorithm>

#include "sim/body/mass_properties.h"

namespace pabd {
namespace {

SmallMotion still() { return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; }

// Empty by Euler.
std::optional<Coasting> coasting(const Problem& p, const Joint& joint) {
  if (!p.second_order(joint)) return {};
  const double h = p.flight->h[p.movable(joint.i) ? joint.i : joint.j];
  const auto pose = [&](Index body) { return p.movable(body) ? p.flight->star[body] : p.start_pose(body); };
  const auto motion = [&](Index body) {
    if (!p.movable(body)) return still();
    return SmallMotion{p.flight->star[body].c, h * p.flight->v[body], h * p.flight->omega[body]};
  };
  const PlacedFrames at = place(joint, pose);
  return Coasting{h, at, motion(joint.i), motion(joint.j)};
}

SmallMotion in_step(const Iterate& it, const Island& island, const std::vector<Vec6>& step, Index body) {
  const std::size_t slot = it.slot(body);
  const Index row = island.row[slot];
  if (row < 0) return still();
  const Vec6& delta = step[row];
  return {it.pose[slot].c, delta.head<3>(), delta.tail<3>()};
}

// Its place among the joints that act, or −1.
Index place_of(const Problem& p, Index joint) { return p.action_at.empty() ? -1 : p.action_at[joint]; }

// Calls visit(joint, frames, action) for the joints of an island that have one.
template <class Visit>
void each_action(const Problem& p, const Island& island, Iterate& it, const Visit& visit) {
  if (p.acting.empty()) return;
  for (const Index k : island.joints) {
    const Index place = place_of(p, k);
    if (place < 0) continue;
    const Joint& joint = p.joints[k];
    visit(joint, frames_of(joint, it), it.action[place]);
  }
}

constexpr double kLeftOver = 0.1;  // of the way of an iteration

// m.
double last_move(const Problem& p, const Iterate& it, Index body) {
  return p.movable(body) ? it.moved[body] * p.law.barrier.d_hat : 0;
}

// So stiff that nothing is seen to creep, by F/k a step, however soft the joint is. `sissm` follows nothing stiffer than
// its joints (cap_stiffness); N/m.
double hold_stiffness(const Problem& p, Index k) {
  constexpr double kStiff = 1e5;  // of m/h² of the lighter body
  const Joint& joint = p.joints[k];
  const double lighter = p.least_of(joint.i, joint.j, [&](Index i) { return p.model->mass[i]; });
  const double h = p.params->h;
  const double stiff = kStiff * lighter / (h * h);
  if (p.params->solver.method != SolverMethod::sissm) return stiff;
  return std::min(evaluate(p.law_of(k), 0.0).second, stiff);
}

// About `axis`, of the body of joint k that turns more easily; kg m².
double turning_inertia(const Problem& p, Index k, const Vec3& axis) {
  return p.least_of(p.joints[k].i, p.joints[k].j, [&](Index i) {
    const Vec3 n = p.start->R[i].transpose() * axis;
    return n.dot(inertia_tensor(p.model->J[i]) * n);
  });
}

}  // namespace

SmallMotion in_flight(const Problem& p, Index i) {
  if (!p.movable(i)) return still();
  return {p.start->c[i], p.params->h * p.start->v[i], p.flight->turn[i]};
}

void start_actions(Problem& p, Iterate& it) {
  it.action.clear();
  p.action_at.clear();
  if (p.acting.empty()) return;
  p.action_at.assign(p.joints.size(), -1);
  for (const Index k : p.acting) {
    const Joint& joint = p.joints[k];
    const PlacedFrames at = frames_at_start(joint, p);
    p.action_at[k] = static_cast<Index>(it.action.size());
    it.action.push_back(
        start_action(joint, at,
                     {p.params->h, p.time, in_flight(p, joint.i), in_flight(p, joint.j), hold_stiffness(p, k),
                      turning_inertia(p, k, at.j.F.col(0)), coasting(p, joint)}));
  }
}

void foresee_actions(const Problem& p, const Island& island, const std::vector<Vec6>& step, Iterate& it) {
  each_action(p, island, it, [&](const Joint& joint, const PlacedFrames& at, ActionStep& action) {
    foresee_way(joint, at, in_step(it, island, step, joint.i), in_step(it, island, step, joint.j), action);
  });
}

bool switch_actions(const Problem& p, const Island& island, bool converged, Iterate& it) {
  bool settled = true;
  each_action(p, island, it, [&](const Joint& joint, const PlacedFrames& at, ActionStep& action) {
    if (island.solver != SolverMethod::newton) action.ahead.reset();
    const double doubt =
        converged ? 0 : kLeftOver * std::max(last_move(p, it, joint.i), last_move(p, it, joint.j));
    settled = settle_action(joint, at, doubt, action) && settled;
  });
  return !settled;
}

double spring_energy(const Problem& p, const Iterate& it, Index k) {
  const Joint& joint = p.joints[k];
  if (!joint.action) return 0;
  const PlacedFrames at = frames_of(joint, it);
  return spring_energy(joint, at);
}

double action_work(const Problem& p, const Iterate& it, Index k) {
  const Index place = place_of(p, k);
  if (place < 0) return 0;
  const PlacedFrames at = frames_of(p.joints[k], it);
  return work_of_action(p.joints[k], it.action[place], at);
}

}  // namespace pabd
