// SPDX-License-Identifier: MIT
// See joint_actions.h.
#include "sim/solver/joint_actions.h"

#include <algorithm>
#include <limits>

#include "sim/body/mass_properties.h"

namespace pabd {
namespace {

SmallMotion still() { return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; }

// As fast as the body is now: what is at rest has not begun to fall.
SmallMotion in_flight(const Problem& p, Index body) {
  if (!p.movable(body)) return still();
  const auto k = static_cast<std::size_t>(body);
  return {p.start->c[k], p.params->h * p.start->v[k], p.flight->turn[k]};
}

// Empty by Euler.
std::optional<Coasting> coasting(const Problem& p, const Joint& joint) {
  if (!p.second_order(joint)) return {};
  const double h = p.flight->h[static_cast<std::size_t>(p.movable(joint.i) ? joint.i : joint.j)];
  const auto pose = [&](Index body) {
    return p.movable(body) ? p.flight->star[static_cast<std::size_t>(body)] : p.start_pose(body);
  };
  const auto motion = [&](Index body) {
    if (!p.movable(body)) return still();
    const auto k = static_cast<std::size_t>(body);
    return SmallMotion{p.flight->star[k].c, h * p.flight->v[k], h * p.flight->omega[k]};
  };
  return Coasting{h, place(joint.on_i, pose(joint.i)), place(joint.on_j, pose(joint.j)), motion(joint.i),
                  motion(joint.j)};
}

SmallMotion in_step(const Iterate& it, const Island& island, const std::vector<Vec6>& step, Index body) {
  const std::size_t slot = it.slot(body);
  const Index row = island.row[slot];
  if (row < 0) return still();
  const Vec6& delta = step[static_cast<std::size_t>(row)];
  return {it.pose[slot].c, delta.head<3>(), delta.tail<3>()};
}

// Its place among the joints that act, or −1.
Index place_of(const Problem& p, Index joint) {
  return p.action_at.empty() ? -1 : p.action_at[static_cast<std::size_t>(joint)];
}

struct PlacedFrames {
  PlacedFrame i, j;
};
PlacedFrames frames_at(const Iterate& it, const Joint& joint) {
  return {place(joint.on_i, it.pose[it.slot(joint.i)]), place(joint.on_j, it.pose[it.slot(joint.j)])};
}

constexpr double kLeftOver = 0.1;  // of the way of an iteration

// m.
double last_move(const Problem& p, const Iterate& it, Index body) {
  return p.movable(body) ? it.moved[static_cast<std::size_t>(body)] * p.law.barrier.d_hat : 0;
}

// So stiff that nothing is seen to creep, by F/k a step, however soft the joint is. `sissm` follows nothing stiffer than
// its joints (stiffness_cap.h); N/m.
double hold_stiffness(const Problem& p, Index k) {
  constexpr double kStiff = 1e5;  // of m/h² of the lighter body
  double lighter = std::numeric_limits<double>::infinity();
  for (const Index body : {p.joints[k].i, p.joints[k].j})
    if (p.movable(body)) lighter = std::min(lighter, p.model->mass[static_cast<std::size_t>(body)]);
  const double h = p.params->h;
  const double stiff = kStiff * lighter / (h * h);
  if (p.params->solver.method != SolverMethod::sissm) return stiff;
  return std::min(evaluate(p.law_of(k), 0.0).second, stiff);
}

// About `axis`, of the body of joint k that turns more easily; kg m².
double turning_inertia(const Problem& p, Index k, const Vec3& axis) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index body : {p.joints[k].i, p.joints[k].j}) {
    if (!p.movable(body)) continue;
    const auto b = static_cast<std::size_t>(body);
    const Vec3 n = p.start->R[b].transpose() * axis;
    least = std::min(least, n.dot(inertia_tensor(p.model->J[b]) * n));
  }
  return least;
}

}  // namespace

void start_actions(Problem& p, Iterate& it) {
  it.action.clear();
  p.action_at.clear();
  if (p.acting.empty()) return;
  p.action_at.assign(p.joints.size(), -1);
  for (const Index k : p.acting) {
    const Joint& joint = p.joints[k];
    const PlacedFrame fi = place(joint.on_i, p.start_pose(joint.i)),
                      fj = place(joint.on_j, p.start_pose(joint.j));
    p.action_at[static_cast<std::size_t>(k)] = static_cast<Index>(it.action.size());
    it.action.push_back(
        start_action(joint, fi, fj,
                     {p.params->h, p.time, in_flight(p, joint.i), in_flight(p, joint.j), hold_stiffness(p, k),
                      turning_inertia(p, k, fj.F.col(0)), coasting(p, joint)}));
  }
}

void foresee_actions(const Problem& p, const Island& island, const std::vector<Vec6>& step, Iterate& it) {
  if (p.acting.empty()) return;
  for (const Index k : island.joints) {
    const Index place = place_of(p, k);
    if (place < 0) continue;
    const Joint& joint = p.joints[k];
    const PlacedFrames at = frames_at(it, joint);
    foresee_way(joint, at.i, at.j, in_step(it, island, step, joint.i), in_step(it, island, step, joint.j),
                it.action[static_cast<std::size_t>(place)]);
  }
}

bool switch_actions(const Problem& p, const Island& island, bool converged, Iterate& it) {
  if (p.acting.empty()) return false;
  bool settled = true;
  for (const Index k : island.joints) {
    const Index place = place_of(p, k);
    if (place < 0) continue;
    const Joint& joint = p.joints[k];
    const PlacedFrames at = frames_at(it, joint);
    ActionStep& action = it.action[static_cast<std::size_t>(place)];
    if (island.solver != SolverMethod::newton) action.ahead.reset();
    const double doubt =
        converged ? 0 : kLeftOver * std::max(last_move(p, it, joint.i), last_move(p, it, joint.j));
    settled = settle_action(joint, at.i, at.j, doubt, action) && settled;
  }
  return !settled;
}

double spring_energy(const Problem& p, const Iterate& it, Index k) {
  const Joint& joint = p.joints[k];
  if (!joint.action) return 0;
  const PlacedFrames at = frames_at(it, joint);
  return spring_energy(joint, at.i, at.j);
}

double action_work(const Problem& p, const Iterate& it, Index k) {
  const Index place = place_of(p, k);
  if (place < 0) return 0;
  const PlacedFrames at = frames_at(it, p.joints[k]);
  return work_of_action(p.joints[k], it.action[static_cast<std::size_t>(place)], at.i, at.j);
}

}  // namespace pabd
