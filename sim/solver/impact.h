// SPDX-License-Identifier: MIT
// The impacts of an island, with its bodies where they are (restitution.h). Internal to restitution.cpp.
#pragma once

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/math/symmetric3.h"
#include "sim/solver/friction.h"
#include "sim/solver/linear_bonds.h"
#include "sim/solver/recovery.h"
#include "sim/solver/restitution.h"

namespace pabd::impacts {

inline constexpr int kMostReflections = 1000, kMostSweeps = 500;
inline constexpr double kSettled = 1e-10;  // of the fastest approach
inline constexpr double kPressed = 1e-3;   // d̂: closer than before by less counts as nothing

// What comes slower rests; m/s.
inline double threshold(const Params& params) {
  const double least = 1e-3 * params.contact.d_hat / params.h;  // without gravity
  return std::max(2 * params.gravity.norm() * params.h, least);
}

// The barrier of a point pushes no more in this step; as if it had been far away at its start.
inline void release(ContactManifold& manifold, int k) {
  manifold.scale[k] = manifold.limit[k] = 0;
  manifold.start_d[k] = 1e30;
}

using Motion = Vec6;  // v, ω

struct TouchPoint {
  Index manifold;
  int point;
};

// A contact point between two bodies, at its place at the end of the step.
struct Touch : TouchPoint {
  Index a, b;
  Vec3 n, r_a, r_b, s_a, s_b;  // levers of the normal force and of friction
  double e, mu;
  double answer = 0, slide_answer = 0;  // change of speed by an impulse along n, across it at most; 1/kg
  double impulse = 0;                   // in all; N s
  double now = 0;                       // of this reflection
  Vec3 friction = Vec3::Zero();         // N s
};

// Bodies that joints make one: M + h² Σ Jᵀ K J.
struct Group {
  std::vector<Index> bodies;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;  // of more than one body
  bool moves = false;                                         // by an impulse
  bool hit = false;                                           // and comes as if nothing had touched it before
};

class Impact {
 public:
  // `points`: where bodies touch.
  Impact(const Problem& p, const Island& island, const std::vector<TouchPoint>& points, const Iterate& it)
      : p_(p), island_(island), it_(it), least_(threshold(*p.params)) {
    for (const TouchPoint& at : points) list_touch(at);
  }

  // `hits`: of each touch, whether bodies hit there; empty: who comes fast enough does.
  void find_velocities(const Velocities& velocities, std::vector<std::uint8_t>& hits) {
    if (hits.empty()) hits = find_hits();
    if (std::find(hits.begin(), hits.end(), 1) == hits.end()) return;
    begin(velocities);
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      if (hits[k] == 0) continue;
      strike(touches_[k].a);
      strike(touches_[k].b);
    }
    reflect();
    settle_all();
  }

  // Was body i hit? Without joints.
  bool flies_on(Index i) const {
    if (motion_.empty() || row(i) < 0) return false;
    const Group& group = groups_[group_of_[row(i)]];
    return group.moves && !is_jointed(group);
  }
  bool any_hit() const { return !motion_.empty(); }

  // Points that part are released, what was pressed comes apart slowly (recovery.h), and friction keeps the bound of
  // what presses then: its share of the impact it had.
  void take_over(Velocities& velocities, Iterate& it) const {
    for (std::size_t k = 0; k < motion_.size(); ++k) {
      if (!groups_[group_of_[k]].moves) continue;
      velocities.v[island_.bodies[k]] = motion_[k].head<3>();
      velocities.omega[island_.bodies[k]] = motion_[k].tail<3>();
    }
    for (const Touch& t : touches_) {
      if (!is_moved(t)) continue;
      ContactManifold& m = it.manifold[t.manifold];
      const Lanes d = state_of(it, m).d;
      if (d[t.point] < m.start_d[t.point] - kPressed * p_.law.barrier.d_hat) recover_from(p_, d, m);
    }
    for (const Touch& t : touches_) {
      if (t.impulse > 0 && -approach(t) > t.e * least_) release(it.manifold[t.manifold], t.point);
    }
    for (const Touch& t : touches_) {
      if (!is_moved(t)) continue;
      ContactManifold& m = it.manifold[t.manifold];
      const ContactForce f = normal_force(p_.law_of(m).barrier, m, state_of(it, m).d);
      m.limit = smaller(m.limit, -m.mu * f.first);
    }
  }

 private:
  std::vector<std::uint8_t> find_hits() const {
    std::vector<std::uint8_t> out;
    for (const Touch& t : touches_) out.push_back(t.e > 0 && approach(t, coming(t.a), coming(t.b)) > least_);
    return out;
  }

  void begin(const Velocities& velocities) {
    motion_.resize(island_.bodies.size());
    for (std::size_t k = 0; k < motion_.size(); ++k)
      motion_[k] << velocities.v[island_.bodies[k]], velocities.omega[island_.bodies[k]];
    list_groups();
  }

  void reflect() {
    for (int i = 0; i < kMostReflections; ++i) {
      chosen_.clear();
      for (Touch& t : touches_) {
        if (!is_hit(t) || !(approach(t) > least_)) continue;
        strike(t.a);
        strike(t.b);
        if (approach(t) > least_) chosen_.push_back(&t);
      }
      if (chosen_.empty()) return;
      settle(false);
      for (Touch* t : chosen_) {
        push(*t, t->e * t->now * t->n);
        t->impulse += (1 + t->e) * t->now;
      }
    }
  }

  // Nothing approaches any more, and friction has its share.
  void settle_all() {
    chosen_.clear();
    for (Touch& t : touches_) {
      if (is_hit(t)) chosen_.push_back(&t);
    }
    settle(true);
  }

  Index row(Index body) const {
    return body == kWorld || !p_.movable(body) ? -1 : island_.row[it_.slot(body)];
  }
  Motion motion(Index body) const { return row(body) < 0 ? Motion(Motion::Zero()) : motion_[row(body)]; }

  static Vec3 at(const Motion& m, const Vec3& r) { return m.head<3>() + m.tail<3>().cross(r); }
  static double approach(const Touch& t, const Motion& a, const Motion& b) {
    return t.n.dot(at(a, t.r_a) - at(b, t.r_b));
  }
  double approach(const Touch& t) const { return approach(t, motion(t.a), motion(t.b)); }
  Vec3 slip(const Touch& t) const {
    const Vec3 v = at(motion(t.b), t.s_b) - at(motion(t.a), t.s_a) + surface_slide(p_, t.a, t.b);
    return v - v.dot(t.n) * t.n;
  }
  bool is_hit(const Touch& t) const { return any_end(t, &Group::hit); }
  bool is_moved(const Touch& t) const { return any_end(t, &Group::moves); }
  bool any_end(const Touch& t, bool Group::*flag) const {
    const auto has = [&](Index body) { return row(body) >= 0 && groups_[group_of_[row(body)]].*flag; };
    return has(t.a) || has(t.b);
  }

  // Of body i at the end of the step if nothing had touched it: v + t g, t when free flight is as high as it is; the spin
  // turns with the body. Where no flight leads so high, all of it is slower.
  Motion coming(Index i) const {
    if (row(i) < 0) return Motion::Zero();
    const Vec3 &v = p_.start->v[i], &g = p_.params->gravity;
    const Pose &end = it_.pose[i], &star = p_.flight->star[i];
    const double gg = g.squaredNorm(), b = v.dot(g), drop = g.dot(end.c - p_.start->c[i]);  // m²/s²
    double t = 0;
    if (gg > 0) {
      const double root = std::sqrt(std::max(0.0, b * b + 2 * gg * drop));
      t = std::clamp((-b - root >= 0 ? -b - root : -b + root) / gg, -p_.params->h, p_.params->h);
    }
    Motion out;
    out << v + t * g, end.R * (star.R.transpose() * p_.flight->omega[i]);
    const Mat3 I = spin_inertia(i);
    const double m = p_.model->mass[i], spin = 0.5 * out.tail<3>().dot(I * out.tail<3>());
    const double now = 0.5 * m * out.head<3>().squaredNorm() + spin;
    const double most = std::max(0.0, 0.5 * m * v.squaredNorm() + spin + m * drop);
    return now > most ? Motion(std::sqrt(most / now) * out) : out;
  }

  Mat3 spin_inertia(Index i) const {
    const Mat3& R = it_.pose[i].R;
    return R * inertia_tensor(p_.model->J[i]) * R.transpose();
  }

  void list_groups() {
    const std::size_t n = motion_.size();
    group_of_.resize(n);
    std::vector<Index> parent(n);
    for (std::size_t k = 0; k < n; ++k) parent[k] = static_cast<Index>(k);
    for (const Index j : island_.joints) {
      const Index a = row(p_.joints[j].i), b = row(p_.joints[j].j);
      if (a >= 0 && b >= 0) parent[root(parent, std::max(a, b))] = root(parent, std::min(a, b));
    }
    std::vector<Index> number(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
      Index& g = number[root(parent, static_cast<Index>(k))];
      if (g < 0) {
        g = static_cast<Index>(groups_.size());
        groups_.emplace_back();
      }
      group_of_[k] = g;
      groups_[g].bodies.push_back(static_cast<Index>(k));
    }
  }

  void list_touch(const TouchPoint& at) {
    const ContactManifold& m = it_.manifold[at.manifold];
    const ContactState s = state_of(it_, m);
    const Pose &a = it_.pose[it_.slot(m.a)], &b = it_.pose[it_.slot(m.b)];
    const ContactLevers on_a = levers_on_a(m, s, a), on_b = levers_on_b(s, a, b);
    const int k = at.point;
    touches_.push_back({at, m.a, m.b, lane(s.n, k), lane(on_a.normal, k), lane(on_b.normal, k),
                        lane(on_a.surface, k), lane(on_b.surface, k),
                        restitution_between(*p_.model, p_.params->contact, m.a, m.b), m.mu});
  }

  Group* group_of(Index body) { return row(body) < 0 ? nullptr : &groups_[group_of_[row(body)]]; }

  // The body comes as it would have, with all that it is joined to.
  void strike(Index body) {
    Group* group = group_of(body);
    if (!group || std::exchange(group->hit, true)) return;
    for (const Index k : group->bodies) motion_[k] = coming(island_.bodies[k]);
    let_move(body);
    if (!is_jointed(*group)) return;
    Eigen::VectorXd momentum(6 * group->bodies.size());
    for (std::size_t k = 0; k < group->bodies.size(); ++k) {
      const Index i = island_.bodies[group->bodies[k]];
      const Motion& m = motion_[group->bodies[k]];
      momentum.segment<6>(6 * k) << p_.model->mass[i] * m.head<3>(), spin_inertia(i) * m.tail<3>();
    }
    const Eigen::VectorXd held = group->factor.solve(momentum);
    for (std::size_t k = 0; k < group->bodies.size(); ++k) motion_[group->bodies[k]] = held.segment<6>(6 * k);
  }

  void let_move(Index body) {
    Group* group = group_of(body);
    if (group && !std::exchange(group->moves, true) && is_jointed(*group)) factor(*group);
  }

  bool is_jointed(const Group& group) const {
    return !p_.joints_at[island_.bodies[group.bodies.front()]].empty();
  }

  void factor(Group& group) {
    place_.assign(motion_.size(), -1);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Index r, Index c, const Mat6& block) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) entries.emplace_back(6 * r + i, 6 * c + j, block(i, j));
    };
    for (std::size_t k = 0; k < group.bodies.size(); ++k) {
      const Index i = island_.bodies[group.bodies[k]];
      place_[group.bodies[k]] = static_cast<Index>(k);
      Mat6 M = Mat6::Zero();
      M.topLeftCorner<3, 3>() = p_.model->mass[i] * Mat3::Identity();
      M.bottomRightCorner<3, 3>() = spin_inertia(i);
      add(static_cast<Index>(k), static_cast<Index>(k), M);
    }
    const double h2 = p_.params->h * p_.params->h;
    each_joint_bond(p_, island_, it_, [&](const LinearBond& bond) {
      const auto place = [&](Index slot) { return island_.row[slot] < 0 ? -1 : place_[island_.row[slot]]; };
      const Index a = place(bond.a), b = place(bond.b);
      Eigen::Matrix<double, 3, 6> A, B;
      A << Mat3::Identity(), -skew(bond.r_a);
      B << Mat3::Identity(), -skew(bond.r_b);
      const Mat3 K = h2 * bond.K;
      if (a >= 0) add(a, a, A.transpose() * K * A);
      if (b >= 0) add(b, b, B.transpose() * K * B);
      if (a < 0 || b < 0) return;
      add(a, b, -A.transpose() * K * B);
      add(b, a, -B.transpose() * K * A);
    });
    const auto n = static_cast<Index>(6 * group.bodies.size());
    Eigen::SparseMatrix<double> H(n, n);
    H.setFromTriplets(entries.begin(), entries.end());
    group.factor.compute(H);
  }

  // An impulse on a body at a lever.
  void push(Index body, const Vec3& r, const Vec3& impulse) {
    if (row(body) < 0) return;
    Group& group = groups_[group_of_[row(body)]];
    const Index i = body;
    if (!is_jointed(group)) {
      Motion& m = motion_[row(body)];
      const Mat3& R = it_.pose[i].R;
      m.head<3>() += impulse / p_.model->mass[i];
      m.tail<3>() +=
          R * (symmetric_inverse(inertia_tensor(p_.model->J[i])) * (R.transpose() * r.cross(impulse)));
      return;
    }
    Eigen::VectorXd f = Eigen::VectorXd::Zero(6 * group.bodies.size());
    const auto place =
        std::lower_bound(group.bodies.begin(), group.bodies.end(), row(body)) - group.bodies.begin();
    f.segment<6>(6 * place) << impulse, r.cross(impulse);
    const Eigen::VectorXd change = group.factor.solve(f);
    for (std::size_t k = 0; k < group.bodies.size(); ++k)
      motion_[group.bodies[k]] += change.segment<6>(6 * k);
  }
  void push(const Touch& t, const Vec3& impulse) {
    push(t.a, t.r_a, -impulse);
    push(t.b, t.r_b, impulse);
  }
  void rub(const Touch& t, const Vec3& impulse) {
    push(t.a, t.s_a, -impulse);
    push(t.b, t.s_b, impulse);
  }

  // What unit impulses change.
  void find_answers(Touch& t) {
    if (t.answer > 0) return;
    const double before = approach(t);
    push(t, t.n);
    t.answer = before - approach(t);
    push(t, -t.n);
    const Vec3 side = t.n.unitOrthogonal();
    for (const Vec3& across : {side, Vec3(t.n.cross(side))}) {
      const Vec3 slid = slip(t);
      rub(t, across);
      t.slide_answer += across.dot(slip(t) - slid);
      rub(t, -across);
    }
  }

  // Impulses of the chosen contacts until none approaches, by projected Gauss–Seidel.
  void settle(bool with_friction) {
    for (Touch* t : chosen_) {
      let_move(t->a);
      let_move(t->b);
      find_answers(*t);
      t->now = 0;
    }
    double fastest = 0;
    for (const Touch* t : chosen_) fastest = std::max(fastest, std::abs(approach(*t)));
    for (int i = 0; i < kMostSweeps; ++i) {
      double change = 0;
      for (Touch* t : chosen_) {
        const double next = std::max(0.0, t->now + approach(*t) / t->answer);
        change = std::max(change, std::abs(next - t->now) * t->answer);
        push(*t, (next - t->now) * t->n);
        t->now = next;
        if (!with_friction || t->mu == 0) continue;
        Vec3 friction = t->friction - slip(*t) / t->slide_answer;
        const double most = t->mu * (t->impulse + t->now), size = friction.norm();
        if (size > most) friction *= most / size;
        change = std::max(change, (friction - t->friction).norm() * t->slide_answer);
        rub(*t, friction - t->friction);
        t->friction = friction;
      }
      if (change <= kSettled * fastest) return;
    }
  }

  const Problem& p_;
  const Island& island_;
  const Iterate& it_;
  double least_;
  std::vector<Motion> motion_;  // of the bodies of the island
  std::vector<Index> group_of_, place_;
  std::deque<Group> groups_;  // a factor cannot be moved
  std::vector<Touch> touches_;
  std::vector<Touch*> chosen_;
};

}  // namespace pabd::impacts
