// SPDX-License-Identifier: MIT
#include "sim/solver/second_order.h"

#include <algorithm>

#include "sim/body/mass_properties.h"
#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"
#include "sim/solver/halving.h"

namespace pabd {
namespace {

// `frames()`: of the joint; most have no limits, and need none.
template <class Frames>
bool is_past_a_limit(const Joint& joint, const Frames& frames) {
  if (!joint.limits && !joint.twist_limits) return false;
  const PlacedFrames at = frames();
  return is_past_a_limit(joint, at.i, at.j);
}

// Has the joint no friction, and no key within the step? Times are sums of steps: one that is just before the step may
// count with it.
bool is_smooth(const Problem& p, const Joint& joint) {
  const double from = p.time - (1 + 1e-6) * p.params->h;
  const auto has_key = [&](const auto& profile) { return profile && profile->turns_within(from, p.time); };
  if (has_key(joint.drive) || has_key(joint.turn)) return false;
  if (!joint.action) return true;
  if (joint.action->friction > 0) return false;
  return !joint.action->motor || !joint.action->motor->profile.turns_within(from, p.time);
}

// Of body i from where its step started; kg m²/s.
Vec3 spin_at_start(const Problem& p, Index i) {
  return turned(p.start->R[i], inertia_tensor(p.model->J[i])) * p.start->omega[i];
}

bool pushes_at_start(const Problem& p, const ContactManifold& manifold) {
  return smallest_start_d(manifold) < p.law.barrier.d_hat;
}

// Is there a contact that pushes, or may push where the step ends, and that would not be made again in halves? What no
// joint holds flies along its parabola by Euler, too.
bool is_touched(const Problem& p, const Island& island, const Iterate& it) {
  if (island.joints.empty() || !may_halve(p.params->solver)) return !island.manifolds.empty();
  return std::any_of(island.manifolds.begin(), island.manifolds.end(),
                     [&](Index k) { return pushes_at_start(p, it.manifold[k]); });
}

bool ends_pushed(const Problem& p, const Island& island, const Iterate& it) {
  return std::any_of(island.manifolds.begin(), island.manifolds.end(), [&](Index m) {
    const ContactManifold& manifold = it.manifold[m];
    const ContactState s = state_of(it, manifold);
    for (int k = 0; k < manifold.count; ++k)
      if (s.d[k] < p.law.barrier.d_hat) return true;
    return false;
  });
}

// Does a body that a joint holds by its axis turn so far that free rotation bends what the joint does across that axis?
// Errors there grow for discs above Ω h = 0.55, for bars across their length above 0.75; tr J is about the largest moment
// of inertia of either.
bool turns_far(const Problem& p, const Island& island) {
  constexpr double kTurn = 0.4;  // rad
  return std::any_of(island.joints.begin(), island.joints.end(), [&](Index k) {
    const Joint& joint = p.joints[k];
    if ((joint.type == JointType::spherical && !joint.turn) || joint.type == JointType::distance)
      return false;
    for (const Index i : {joint.i, joint.j})
      if (p.movable(i) && p.params->h * spin_at_start(p, i).norm() > kTurn * p.model->J[i].trace())
        return true;
    return false;
  });
}

// Do the velocities where a run starts go along the joint? It takes up those that do not.
bool fits(const Problem& p, const Joint& joint) {
  if (traits_of(joint.type).points && joint.law.potential == BondPotential::soft) return true;  // a spring
  constexpr double kStep = 1e-3, kAside = 0.01;  // of h; of the way of the bodies
  const double dt = kStep * p.params->h, from = p.time - p.params->h;
  const auto moved = [&](Index i) {
    const Pose pose = p.start_pose(i);
    return p.movable(i) ? Pose{pose.c + dt * p.start->v[i], exp_so3(dt * p.start->omega[i]) * pose.R} : pose;
  };
  BondList before, after;
  expand(joint, p.start_pose(joint.i), p.start_pose(joint.j), from, before);
  expand(joint, moved(joint.i), moved(joint.j), from + dt, after);
  double way = 0, opened = 0;
  for (const Index i : {joint.i, joint.j})
    if (p.movable(i))
      way = std::max({way, dt * p.start->v[i].norm(), joint.arm * dt * p.start->omega[i].norm()});
  for (int b = 0; b < std::min(before.count, after.count); ++b) {
    const double was = evaluate(joint.law, before.bond[b]).stretch;
    opened = std::max(opened, std::abs(evaluate(joint.law, after.bond[b]).stretch - was));
  }
  return opened <= kAside * way;
}

// Does nothing break in on the island, so that what it remembers is worth something?
bool is_smooth(const Problem& p, const Island& island, const Iterate& it) {
  return !is_touched(p, island, it) && !turns_far(p, island) &&
         std::all_of(island.joints.begin(), island.joints.end(), [&](Index k) {
           if (static_cast<std::size_t>(k) >= p.joints.model.size()) return false;
           const Joint& joint = p.joints[k];
           return is_smooth(p, joint) && (p.start->step > 0 || fits(p, joint)) &&
                  !is_past_a_limit(joint, [&] { return frames_at_start(joint, p); });
         });
}

// Free flight without what acts from outside, which comes with another h.
void fly_alone(const Problem& p, Index i, Flight& flight) {
  flight.star[i] = p.start_pose(i);
  flight.v[i] = p.start->v[i];
  flight.omega[i] = p.start->omega[i];
  flight.turn[i] = free_flight(p.model->J[i], p.params->gravity, p.params->h, flight.star[i], flight.v[i],
                               flight.omega[i]);
}

void predict_body(const Problem& p, Index i, const StepChange& last, Flight& flight) {
  const Vec3 &v = p.start->v[i], &g = p.params->gravity;
  const double h = p.params->h;
  const bool pushed = has_external(*p.model, i);
  if (pushed) fly_alone(p, i, flight);
  Pose& star = flight.star[i];
  star.c = p.start->c[i] + h * (v + 0.5 * h * g) + h / 18 * last.velocity;
  flight.v[i] = v + h * g + last.velocity / 3;
  flight.h[i] = 2 * h / 3;
  if (!last.spin.isZero(0)) {  // free rotation is exact
    const Mat3 I = inertia_tensor(p.model->J[i]), inverse = symmetric_inverse(I);
    star.R = reorthonormalized(exp_so3(h / 18 * (turned(star.R, inverse) * last.spin)) * star.R);
    flight.omega[i] = turned(star.R, inverse) * (spin_at_start(p, i) + last.spin / 3);
  }
  if (pushed) add_external(*p.model, i, p.time, flight.h[i], flight);
}

// What a force that goes from F₀ to F₁ does to a body alone, in place of what Euler has it do:
// h (F₀ + F₁)/2m to its velocity, h² (2F₀ + F₁)/6m to its place. The same of a torque.
void let_fly_pushed(const Problem& p, Index i, Iterate& it, Velocities& velocities) {
  const double h = p.params->h, from = p.time - h;
  const ExternalForce& external = *p.model->external[i];
  const Vec3 F0 = external.force_at(from), F1 = external.force_at(p.time);
  Pose pose = it.pose[i];
  pose.c -= h * h / (6 * p.model->mass[i]) * (5 * F1 - 2 * F0);
  velocities.v[i] -= 0.5 * h / p.model->mass[i] * (F1 - F0);
  const Vec3 t0 = external.torque_at(from), t1 = external.torque_at(p.time);
  if (!t0.isZero(0) || !t1.isZero(0)) {
    const Mat3 I = inertia_tensor(p.model->J[i]), inverse = symmetric_inverse(I);
    const Vec3 L = turned(pose.R, I) * velocities.omega[i] - 0.5 * h * (t1 - t0);
    pose.R = reorthonormalized(exp_so3(-h * h / 6 * (turned(pose.R, inverse) * (5 * t1 - 2 * t0))) * pose.R);
    velocities.omega[i] = turned(pose.R, inverse) * L;
  }
  set_pose(p, i, pose, it);
}

}  // namespace

void predict(const Problem& p, const Islands& islands, const Iterate& it, Flight& flight,
             SecondOrder& memory) {
  const std::vector<StepChange>& last = p.start->change;
  const auto knows = [&](Index i) { return !last.empty() && last[i].h == p.params->h; };
  memory.smooth.resize(islands.list.size());
  for (std::size_t k = 0; k < islands.list.size(); ++k) {
    const Island& island = islands.list[k];
    memory.smooth[k] = is_smooth(p, island, it);
    if (!memory.smooth[k] || !std::all_of(island.bodies.begin(), island.bodies.end(), knows)) continue;
    for (const Index i : island.bodies) predict_body(p, i, last[i], flight);
  }
}

void let_fly(const Problem& p, Iterate& it, Velocities& velocities) {
  const double h = p.params->h;
  const Vec3 fall = h * h * p.params->gravity;
  for (Index i = 0; i < p.model->size(); ++i) {
    if (!p.movable(i) || !p.joints_at[i].empty() || p.second_order(i)) continue;
    const Pose& star = p.flight->star[i];
    const double least = kFelt * kFelt * (star.c - p.start->c[i] - h * p.start->v[i]).squaredNorm();
    if (!((it.pose[i].c - star.c).squaredNorm() <= least)) continue;
    const auto ends = p.ends[i];
    if (std::any_of(ends.begin(), ends.end(),
                    [&](const ManifoldEnd& end) { return pushes_at_start(p, it.manifold[end.manifold]); }))
      continue;
    it.pose[i].c -= 0.5 * fall;
    if (has_external(*p.model, i)) let_fly_pushed(p, i, it, velocities);
  }
}

bool ends_broken_in(const Problem& p, const Island& island, const Iterate& it) {
  if (!p.second_order(island.bodies.front())) return false;
  return ends_pushed(p, island, it) || std::any_of(island.joints.begin(), island.joints.end(), [&](Index k) {
           const Joint& joint = p.joints[k];
           return is_past_a_limit(joint, [&] { return frames_of(joint, it); });
         });
}

void remember(const Problem& p, const Islands& islands, const SecondOrder& memory,
              const std::vector<std::uint8_t>& again, const Iterate& it, const Velocities& velocities,
              std::vector<StepChange>& out) {
  const double h = p.params->h;
  if (std::find(memory.smooth.begin(), memory.smooth.end(), 1) == memory.smooth.end()) return out.clear();
  out.assign(p.model->shape.size(), {});
  const auto keep = [&](Index i) {
    const Pose& end = it.pose[i];
    StepChange& now = out[i];
    const Vec3 &v = p.start->v[i], &g = p.params->gravity;
    now.h = h;
    now.velocity = velocities.v[i] - (v + h * g);
    const bool remembered = p.second_order(i) && !p.start->change[i].spin.isZero(0);
    if (!remembered && !has_external(*p.model, i) && end.R == p.flight->star[i].R) return;  // turned freely
    now.spin = turned(end.R, inertia_tensor(p.model->J[i])) * velocities.omega[i] - spin_at_start(p, i);
  };
  for (std::size_t k = 0; k < islands.list.size(); ++k) {
    const Island& island = islands.list[k];
    if (!memory.smooth[k]) continue;
    for (const Index i : island.bodies) {
      out[i].gained = memory.gained[k];
      if (!again[i]) keep(i);
    }
  }
}

}  // namespace pabd
