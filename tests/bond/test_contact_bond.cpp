// SPDX-License-Identifier: MIT
// Contact bonds: gap and stretch against plane geometry, forces and moments on both bodies against finite
// differences of the energy.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/bond/turn_friction.h"

namespace pabd::test_contact_bond {

namespace {

constexpr double kStep = 1e-7;

ContactLaw law_with(BarrierKind kind) {
  return {{kind, 3, 0.02, kind == BarrierKind::log ? 4e4 : 5.0, 0.2}, 2e4};
}

const Pose kA{Vec3(0.2, -0.1, 0.4), exp_so3(Vec3(0.3, -0.8, 0.5))};
const Pose kB{Vec3(0.25, 0.95, 0.3), exp_so3(Vec3(-0.6, 0.2, 0.9))};

// Flat bodies: two points at different gaps, one that sticks and one that slides.
ContactManifold flat_patch() {
  ContactManifold p{};
  p.a = 0;
  p.b = 1;
  p.count = 2;
  p.turns = true;
  const Vec3 n = Vec3(0.1, 1, -0.2).normalized();
  p.n = spread(kA.R.transpose() * n);
  const Vec3 touch[2] = {{0.1, 0.5, 0.2}, {0.4, 0.45, 0.1}};
  const double gap[2] = {0.013, 0.006}, slip[2] = {2e-5, 9e-4};
  const Vec3 aside = n.cross(Vec3(0.3, 0.1, 0.9)).normalized();
  for (int k = 0; k < 2; ++k) {
    set_lane(p.normal_a, k, kA.R.transpose() * (touch[k] - kA.c));
    set_lane(p.normal_b, k, kB.R.transpose() * (touch[k] + gap[k] * n + slip[k] * aside - kB.c));
    p.gap[k] = 0;
  }
  p.mu = 0.5;
  p.limit = lanes(3);
  p.limit[2] = p.limit[3] = 0;
  p.last_change = lanes(0);
  return p;
}

double energy_at(const ContactLaw& law, const ContactManifold& p, const Pose& a, const Pose& b) {
  const Lanes energy = contact_energy(law, p, contact_state(p, a, b, {}));
  return energy[0] + energy[1];
}

Pose moved(const Pose& pose, const Vec3& shift, const Vec3& turn) {
  return {pose.c + shift, exp_so3(turn) * pose.R};
}

// ∂E/∂c and the moment ∂E/∂θ of one body, by central differences.
struct Slopes {
  Vec3 force, moment;
};
template <class Energy>
Slopes slopes_of(const Energy& energy) {
  Slopes out;
  for (int k = 0; k < 3; ++k) {
    const Vec3 shift = kStep * Vec3::Unit(k);
    const Vec3 zero = Vec3::Zero();
    out.force[k] = (energy(shift, zero) - energy(Vec3(-shift), zero)) / (2 * kStep);
    out.moment[k] = (energy(zero, shift) - energy(zero, Vec3(-shift))) / (2 * kStep);
  }
  return out;
}

}  // namespace

TEST_CASE("the gap is the distance of b's point from a's plane, the stretch what it has slipped along it") {
  const ContactManifold p = flat_patch();
  const ContactState s = contact_state(p, kA, kB, {});
  CHECK(s.d[0] == Approx(0.013).epsilon(1e-12));
  CHECK(s.d[1] == Approx(0.006).epsilon(1e-12));
  CHECK(length(s.u)[0] == Approx(2e-5).epsilon(1e-9));
  CHECK(length(s.u)[1] == Approx(9e-4).epsilon(1e-9));
  CHECK(std::abs(lane(s.u, 1).dot(lane(s.n, 1))) < 1e-15);
}

TEST_CASE("force and moment of a contact between flat bodies are the slopes of its energy") {
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
    const ContactLaw law = law_with(kind);
    const ContactManifold p = flat_patch();
    const ContactState s = contact_state(p, kA, kB, {});
    const ContactForce f = normal_force(law.barrier, p, s.d);
    const Lanes weight = friction_weight(law, p.limit, length(s.u));
    const ContactLevers on_a = levers_on_a(p, s, kA), on_b = levers_on_b(s, kA, kB);
    Slopes a{Vec3::Zero(), Vec3::Zero()}, b = a;
    for (int k = 0; k < 2; ++k) {
      const Vec3 normal = f.first[k] * lane(s.n, k), friction = weight[k] * lane(s.u, k);
      b.force += normal + friction;
      b.moment += lane(on_b.normal, k).cross(normal) + lane(on_b.surface, k).cross(friction);
      a.force -= normal + friction;
      a.moment -= lane(on_a.normal, k).cross(normal) + lane(on_a.surface, k).cross(friction);
    }
    const Slopes of_b = slopes_of(
        [&](const Vec3& shift, const Vec3& turn) { return energy_at(law, p, kA, moved(kB, shift, turn)); });
    const Slopes of_a = slopes_of(
        [&](const Vec3& shift, const Vec3& turn) { return energy_at(law, p, moved(kA, shift, turn), kB); });
    INFO(to_string(kind));
    const double size = b.force.norm();
    CHECK(size > 1);
    CHECK((b.force - of_b.force).norm() < 1e-5 * size);
    CHECK((b.moment - of_b.moment).norm() < 1e-5 * size);
    CHECK((a.force - of_a.force).norm() < 1e-5 * size);
    CHECK((a.moment - of_a.moment).norm() < 1e-5 * size);
    // One line of action: no momentum and no spin from nowhere.
    CHECK((a.force + b.force).norm() < 1e-12 * size);
    CHECK((a.moment + kA.c.cross(a.force) + b.moment + kB.c.cross(b.force)).norm() < 1e-12 * size);
  }
}

TEST_CASE("the torque of friction against turns is the slope of its energy, its weight that of the torque") {
  const ContactLaw law = law_with(BarrierKind::polynomial);
  TurnFriction f{};
  f.n = Vec3(0.2, 1, -0.4).normalized();
  f.arm2 = 0.04;
  const auto at = [&](const Vec3& turn) { return about_normal(f, turn); };
  const Vec3 turn = Vec3(3e-3, 1e-3, -4e-3);
  const auto torque = [&](const Vec3& v) { return turn_force(law, f, at(v)).torque; };
  const double stuck = turning(law, f).k_t * turn.norm();
  for (const double torsional : {0.2 * stuck, 5 * stuck}) {
    for (const double rolling : {0.1 * stuck, 5 * stuck}) {
      f.limit[0] = torsional;
      f.limit[1] = rolling;
      f.along = lanes(0);  // the true curvature of what slides
      Mat3 weight;
      Vec3 slope;
      constexpr double kTurn = 1e-8;
      for (int k = 0; k < 3; ++k) {
        const Vec3 more = turn + kTurn * Vec3::Unit(k), less = turn - kTurn * Vec3::Unit(k);
        slope[k] = (turn_energy(law, f, at(more)) - turn_energy(law, f, at(less))) / (2 * kTurn);
        weight.col(k) = (torque(more) - torque(less)) / (2 * kTurn);
      }
      const TurnForce found = turn_force(law, f, at(turn));
      CAPTURE(torsional, rolling);
      CHECK(found.energy == turn_energy(law, f, at(turn)));
      CHECK((found.torque - slope).norm() < 1e-5 * slope.norm());
      CHECK((found.weight - weight).norm() < 1e-5 * weight.norm());
      CHECK(std::abs(found.torque.dot(f.n)) <= torsional * (1 + 1e-12));
    }
  }
}

TEST_CASE("friction sticks with k_t ‖u‖ up to its limit and slides with the limit") {
  const ContactLaw law = law_with(BarrierKind::polynomial);
  const Lanes limit = lanes(3), u{2e-5, 1.5e-4, 9e-4, 0};
  const Lanes weight = friction_weight(law, limit, u);
  CHECK(weight[0] * u[0] == Approx(2e4 * 2e-5));
  CHECK(weight[1] * u[1] == Approx(3));
  CHECK(weight[2] * u[2] == Approx(3));
  CHECK(weight[3] * u[3] == 0);
  const Lanes energy = friction_energy(law, limit, u);
  CHECK(energy[0] == Approx(0.5 * 2e4 * 4e-10));
  CHECK(energy[2] - energy[1] == Approx(3 * (9e-4 - 1.5e-4)));
  CHECK(friction_weight(law, lanes(0), u)[2] == 0);
}

}  // namespace pabd::test_contact_bond
