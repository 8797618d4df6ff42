// SPDX-License-Identifier: MIT
#include "sim/solver/model_parts.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "sim/body/shape.h"
#include "sim/collision/broad_phase.h"
#include "sim/math/team.h"
#include "sim/solver/step_numbers.h"

namespace pabd {
namespace {

// All that a body may touch in a step, wherever its contacts are looked for (place_for_detection of contact_setup.cpp):
// at its start or at the end of its flight, as far around as it flies and turns.
double reach(const Model& model, const Params& params, const State& state, Index i) {
  const Vec3 way = params.h * (state.v[i] + params.h * params.gravity);
  const double turn = params.h * state.omega[i].norm() * bounding_radius(model.shape[i]);
  return params.contact.d_hat + 2 * (way.norm() + turn);
}

Aabb reached(const Model& model, const Params& params, const State& state, Index i) {
  Aabb box = bounds(model.shape[i], state.c[i], state.R[i]);
  const Vec3 around = Vec3::Constant(reach(model, params, state, i));
  box.lo -= around;
  box.hi += around;
  return box;
}

bool meet(const Aabb& a, const Aabb& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

// The entries of those numbers; nothing of an empty list.
template <class Entry>
void pick(const std::vector<Entry>& from, const std::vector<Index>& numbers, std::vector<Entry>& to) {
  to.resize(from.empty() ? 0 : numbers.size());
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[numbers[k]];
}

// Bodies whose mark is `mark`. Joints of fixed bodies alone belong to those that are marked.
void fill_part(const Model& model, const std::vector<std::uint8_t>& marks, bool mark, ModelPart& out) {
  const auto belongs = [&](Index i) { return (marks[i] != 0) == mark; };
  const auto moves = [&](Index i) { return i != kWorld && !model.fixed[i]; };
  out.place.assign(model.shape.size(), -1);
  out.bodies.clear();
  for (Index i = 0; i < model.size(); ++i) {
    if (moves(i) && !belongs(i)) continue;
    out.place[i] = static_cast<Index>(out.bodies.size());
    out.bodies.push_back(i);
  }
  each_body_list([&](const auto& whole, auto& part) { pick(whole, out.bodies, part); }, model, out.model);
  out.model.groups.name = model.groups.name;
  out.model.groups.apart = model.groups.apart;
  find_avoided(out.model.groups);
  out.model.no_collide.clear();
  for (const auto& [a, b] : model.no_collide)
    if (out.holds(a) && out.holds(b)) out.model.no_collide.emplace_back(out.place[a], out.place[b]);
  out.joints.clear();
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    const Index moving = moves(joint.i) ? joint.i : joint.j;
    if (moves(moving) ? belongs(moving) : mark) out.joints.push_back(static_cast<Index>(k));
  }
  out.model.joints.resize(out.joints.size());
  for (std::size_t k = 0; k < out.joints.size(); ++k) {
    Joint& joint = out.model.joints[k];
    joint = model.joints[out.joints[k]];
    if (joint.i != kWorld) joint.i = out.place[joint.i];
    if (joint.j != kWorld) joint.j = out.place[joint.j];
    if (!joint.follows) continue;
    const auto leader = std::lower_bound(out.joints.begin(), out.joints.end(), joint.follows->leader);
    joint.follows->leader = static_cast<Index>(leader - out.joints.begin());
  }
  out.couplings.clear();
  Index coupling = 0;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (!model.joints[k].follows) continue;
    if (std::binary_search(out.joints.begin(), out.joints.end(), static_cast<Index>(k)))
      out.couplings.push_back(coupling);
    ++coupling;
  }
}

// A contact of two bodies that are in the part; those of two fixed ones there are none.
bool belongs(const ModelPart& part, std::uint64_t pair) {
  const auto [a, b] = bodies_of_pair(pair);
  return part.holds(a) && part.holds(b);
}

}  // namespace

std::vector<std::uint8_t> jointed_bodies(const Model& model, const Params& params, const State& state) {
  std::vector<std::uint8_t> out(model.shape.size(), 0);
  std::vector<Index> found;
  const auto add = [&](Index i) {
    if (i == kWorld || model.fixed[i] || out[i]) return;
    out[i] = 1;
    found.push_back(i);
  };
  for (const Joint& joint : model.joints) {
    add(joint.i);
    add(joint.j);
  }
  if (found.empty()) return out;
  std::vector<Aabb> boxes(model.shape.size(), Aabb{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)});
  for (Index i = 0; i < model.size(); ++i)  // what is fixed couples nobody
    if (!model.fixed[i]) boxes[i] = reached(model, params, state, i);
  Team team;
  BroadPhase broad;
  std::vector<IndexPair> pairs;
  broad.find({boxes, model.fixed, {}, {}}, 1, team, pairs);
  std::vector<std::vector<Index>> beside(model.shape.size());
  for (const auto& [a, b] : pairs) {
    beside[a].push_back(b);
    beside[b].push_back(a);
  }
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const Index i : beside[found[k]]) add(i);
  return out;
}

void take_bodies(const Model& model, const std::vector<std::uint8_t>& chosen, ModelPart& out) {
  fill_part(model, chosen, true, out);
}

ModelParts split_model(const Model& model, const std::vector<std::uint8_t>& jointed) {
  ModelParts out;
  fill_part(model, jointed, true, out.jointed);
  fill_part(model, jointed, false, out.free);
  return out;
}

std::optional<std::pair<Index, Index>> coupling(const Model& model, const ModelParts& parts,
                                                const Params& params, const State& state) {
  std::vector<std::pair<Aabb, Index>> boxes;
  Aabb all{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Index i : parts.jointed.bodies) {
    if (model.fixed[i]) continue;
    boxes.emplace_back(reached(model, params, state, i), i);
    all.lo = all.lo.cwiseMin(boxes.back().first.lo);
    all.hi = all.hi.cwiseMax(boxes.back().first.hi);
  }
  for (const Index i : parts.free.bodies) {
    if (model.fixed[i]) continue;
    const Vec3 around = Vec3::Constant(bounding_radius(model.shape[i]) + reach(model, params, state, i));
    if (!meet(all, {state.c[i] - around, state.c[i] + around})) continue;
    const Aabb box = reached(model, params, state, i);
    for (const auto& [other, k] : boxes)
      if (meet(box, other)) return std::pair(k, i);
  }
  return std::nullopt;
}

void take_part(const ModelPart& part, const State& whole, State& out) {
  out.time = whole.time;
  out.step = whole.step;
  each_body_array([&](const auto& from, auto& to) { pick(from, part.bodies, to); }, whole, out);
  pick(whole.change, part.bodies, out.change);
  pick(whole.joint_force, part.joints, out.joint_force);
  out.contacts.clear();
  for (const ContactMemory& contact : whole.contacts) {
    if (!belongs(part, contact.pair)) continue;
    const auto [a, b] = bodies_of_pair(contact.pair);
    out.contacts.push_back(contact);
    out.contacts.back().pair = pair_key(part.place[a], part.place[b]);
  }
  const bool known =
      !part.couplings.empty() && static_cast<std::size_t>(part.couplings.back()) < whole.coupling.size();
  out.coupling.resize(known ? part.couplings.size() : 0);
  for (std::size_t k = 0; k < out.coupling.size(); ++k) out.coupling[k] = whole.coupling[part.couplings[k]];
}

void put_part(const ModelPart& part, const State& state, State& whole) {
  whole.time = state.time;
  whole.step = state.step;
  if (!state.change.empty()) whole.change.resize(whole.c.size());
  for (std::size_t k = 0; k < part.bodies.size(); ++k) {
    const auto i = static_cast<std::size_t>(part.bodies[k]);
    if (part.model.fixed[k]) continue;
    each_body_array([&](const auto& from, auto& to) { to[i] = from[k]; }, state, whole);
    if (!state.change.empty()) whole.change[i] = state.change[k];
  }
  std::erase_if(whole.contacts, [&](const ContactMemory& contact) { return belongs(part, contact.pair); });
  for (const ContactMemory& contact : state.contacts) {
    const auto [a, b] = bodies_of_pair(contact.pair);
    whole.contacts.push_back(contact);
    whole.contacts.back().pair = pair_key(part.bodies[a], part.bodies[b]);
  }
  std::sort(whole.contacts.begin(), whole.contacts.end(), [](const ContactMemory& a, const ContactMemory& b) {
    return std::tie(a.pair, a.feature) < std::tie(b.pair, b.feature);
  });
  if (!state.coupling.empty()) {
    const auto most = static_cast<std::size_t>(part.couplings.back()) + 1;
    if (whole.coupling.size() < most) whole.coupling.resize(most, 0);
    for (std::size_t k = 0; k < part.couplings.size(); ++k)
      whole.coupling[part.couplings[k]] = state.coupling[k];
  }
  if (state.joint_force.empty()) return;
  const auto needed = static_cast<std::size_t>(part.joints.back()) + 1;
  if (whole.joint_force.size() < needed) whole.joint_force.resize(needed, Vec3::Zero());
  for (std::size_t k = 0; k < part.joints.size(); ++k)
    whole.joint_force[part.joints[k]] = state.joint_force[k];
}

void put_contacts(const ModelPart& part, const std::vector<ContactReport>& contacts,
                  std::vector<ContactReport>& whole) {
  for (const ContactReport& contact : contacts) {
    whole.push_back(contact);
    whole.back().a = part.bodies[contact.a];
    whole.back().b = part.bodies[contact.b];
  }
  const auto before = [](const ContactReport& x, const ContactReport& y) {
    return std::minmax(x.a, x.b) < std::minmax(y.a, y.b);
  };
  if (!std::is_sorted(whole.begin(), whole.end(), before))
    std::stable_sort(whole.begin(), whole.end(), before);
}

void add_report(const ModelPart& part, const StepReport& of_part, StepReport& out) {
  out.status = std::max(out.status, of_part.status);
  add_numbers(of_part, out);
  out.times += of_part.times;
  put_contacts(part, of_part.contact_reports, out.contact_reports);
  for (IslandReport island : of_part.islands) {
    island.first_body = part.bodies[island.first_body];
    out.islands.push_back(island);
  }
}

}  // namespace pabd
