// SPDX-License-Identifier: MIT
#include "sim/solver/turn_friction.h"

#include <algorithm>

#include "sim/math/extremes.h"
#include "sim/solver/friction.h"

namespace pabd {
namespace {

// Behind all points of a pair: what is remembered of its turns.
constexpr std::uint32_t kTurnFeature = 0xffffffffu;

bool against_turns(const SurfaceFriction& friction) { return friction.torsional > 0 || friction.rolling > 0; }

// What turns it in units of length: the smaller one of the two that move; m.
double arm_of(const Problem& p, const ContactManifold& manifold) {
  return p.least_of(manifold.a, manifold.b, [&](Index i) { return p.flight->radius[i]; });
}

// Mean of its normals; world.
Vec3 normal_of(const ContactManifold& manifold, const Pose& a) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < manifold.count; ++k) sum += lane(manifold.n, k);
  const double length = sum.norm();
  const Vec3 n = length > 0.5 ? Vec3(sum / length) : lane(manifold.n, 0);
  return manifold.turns ? Vec3(a.R * n) : n;
}

// Of a manifold's owner, if it is flat: memory turns with it.
Mat3 frame_of(const ContactManifold& manifold, const Mat3& R_a) {
  return manifold.turns ? R_a : Mat3(Mat3::Identity());
}

const ContactMemory* remembered(const Problem& p, std::uint64_t pair) {
  const auto& contacts = p.start->contacts;
  // The last of the pair.
  const auto end = std::upper_bound(contacts.begin(), contacts.end(), pair,
                                    [](std::uint64_t key, const ContactMemory& c) { return key < c.pair; });
  if (end == contacts.begin()) return nullptr;
  const ContactMemory& last = *std::prev(end);
  return last.pair == pair && last.feature == kTurnFeature ? &last : nullptr;
}

Vec3 stretch_of_last_step(const Problem& p, const ContactManifold& manifold) {
  const ContactMemory* memory = remembered(p, pair_key(manifold.a, manifold.b));
  return memory ? Vec3(frame_of(manifold, p.start->R[manifold.a]) * memory->stretch) : Vec3(Vec3::Zero());
}

}  // namespace

bool has_turn_friction(const Model& model, const ContactParams& contact) {
  if (contact.torsional > 0 || contact.rolling > 0) return true;
  return std::any_of(model.friction.begin(), model.friction.end(),
                     [](const auto& own) { return own && against_turns(*own); });
}

void find_turn_friction(Problem& p, Iterate& it) {
  it.turning.clear();
  if (!has_turn_friction(*p.model, p.params->contact)) return;
  for (ContactManifold& manifold : it.manifold) {
    const Index a = manifold.a, b = manifold.b;
    const SurfaceFriction mu = friction_between(*p.model, p.params->contact, a, b);
    if (!against_turns(mu)) continue;
    manifold.turning = static_cast<Index>(it.turning.size());
    TurnFriction& turn = it.turning.emplace_back();
    const std::vector<Vec3>& turns = p.flight->turn;
    turn.a = a;
    turn.b = b;
    turn.n = normal_of(manifold, p.flight->star[a]);
    turn.before = turns[b] - turns[a] + stretch_of_last_step(p, manifold);
    const double arm = arm_of(p, manifold);
    turn.arm2 = arm * arm;
    turn.length[0] = mu.torsional;
    turn.length[1] = mu.rolling;
    p.rolls[a] = p.rolls[b] = 1;
  }
}

double turn_energy_at_start(const Problem& p, const ContactLaw& law, const ContactManifold& manifold,
                            const Iterate& it) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  return turn ? turn_energy(law, *turn, about_normal(*turn, stretch_of_last_step(p, manifold))) : 0;
}

TurnOnBody turn_on_body(const ContactLaw& law, const ContactManifold& manifold, double side,
                        const Iterate& it) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  if (!turn) return {};
  const TurnForce force = turn_force(law, *turn, stretch_of_turn(*turn, it.rolls()));
  const double slope = it.roll[side < 0 ? manifold.a : manifold.b].slope;
  return {force.energy, side * slope * force.torque, force.weight};
}

namespace {

// The largest of both lanes as a part of length × max(f_n, least).
double largest_part(const TurnFriction& turn, const Lanes& torque, const ContactForce& f, double least) {
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    if (turn.length[k] > 0)
      worst = larger(worst, torque[k] / (turn.length[k] * std::max(-sum(f.first), least)));
  }
  return worst;
}

}  // namespace

double turn_friction_error(const ContactLaw& law, const ContactManifold& manifold, const ContactForce& f,
                           double least, const Iterate& it) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  if (!turn) return 0;
  const Lanes way = length(stretch_of_turn(*turn, it.rolls()));
  return largest_part(*turn, friction_error(turning(law, *turn), *turn, most_torque(*turn, f), way), f,
                      least);
}

double turn_friction_excess(const ContactLaw& law, const ContactManifold& manifold, const ContactForce& f,
                            double least, const Iterate& it) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  if (!turn) return 0;
  const Lanes way = length(stretch_of_turn(*turn, it.rolls()));
  return largest_part(*turn, smaller(turning(law, *turn).k_t * way, turn->limit), f, least) - 1;
}

void store_turn_friction(const Problem& p, const ContactManifold& manifold, const Iterate& it,
                         std::vector<ContactMemory>& contacts) {
  const TurnFriction* turn = turn_friction_of(manifold, it);
  if (!turn) return;
  const ContactLaw law = turning(p.law_of(manifold), *turn);
  const Vec3x u = stretch_of_turn(*turn, it.rolls());
  const Lanes kept = friction_weight(law, turn->limit, length(u)) / law.k_t;  // 1 while it sticks
  const Vec3 kept_stretch = kept[0] * lane(u, 0) + kept[1] * lane(u, 1);
  if (kept_stretch.squaredNorm() == 0) return;
  const std::uint64_t pair = pair_key(manifold.a, manifold.b);
  const Vec3 stretch = frame_of(manifold, it.pose[manifold.a].R).transpose() * kept_stretch;
  if (!contacts.empty() && contacts.back().pair == pair && contacts.back().feature == kTurnFeature)
    contacts.pop_back();  // of several manifolds the last is as good as any: they see the same turn
  contacts.push_back({pair, kTurnFeature, stretch});
}

}  // namespace pabd
