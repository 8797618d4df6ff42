// SPDX-License-Identifier: MIT
#include "sim/solver/problem.h"

#include <algorithm>
#include <array>

namespace pabd {
namespace {

// `now` becomes `last`; were they the same?
template <class List>
bool stays(const List& now, List& last) {
  if (now == last) return true;
  last = now;
  return false;
}

// Each once at each of its bodies.
void list_couplings(Problem& p) {
  p.couplings_at.fill(p.model->shape.size(), [&](const auto& visit) {
    for (std::size_t n = 0; n < p.followers.size(); ++n) {
      const auto [i, j] = p.joint_ends[p.followers[n]];
      const auto [k, l] = p.joint_ends[static_cast<std::size_t>(p.joints[p.followers[n]].follows->leader)];
      const std::array bodies{i, j, k, l};
      for (auto at = bodies.begin(); at != bodies.end(); ++at)
        if (p.movable(*at) && std::find(bodies.begin(), at, *at) == at) visit(*at, static_cast<Index>(n));
    }
  });
}

bool couplings_stay(const Problem& p, BodyPairs& last) {
  const auto pair_of = [&](Index follower) {
    return std::pair(follower, p.joints[follower].follows->leader);
  };
  const auto same = [&](Index follower, const auto& pair) { return pair_of(follower) == pair; };
  if (std::equal(p.followers.begin(), p.followers.end(), last.begin(), last.end(), same)) return true;
  last.clear();
  for (const Index k : p.followers) last.push_back(pair_of(k));
  return false;
}

bool manifolds_stay(const Iterate& it, BodyPairs& last) {
  const auto same = [](const ContactManifold& manifold, const std::pair<Index, Index>& pair) {
    return manifold.a == pair.first && manifold.b == pair.second;
  };
  if (std::equal(it.manifold.begin(), it.manifold.end(), last.begin(), last.end(), same)) return true;
  last.clear();
  for (const ContactManifold& manifold : it.manifold) last.emplace_back(manifold.a, manifold.b);
  return false;
}

}  // namespace

bool list_bonds(Problem& p, const Iterate& it, BondGraph& last) {
  const auto bodies = p.model->shape.size();
  p.joint_ends.clear();
  p.works.clear();
  p.acting.clear();
  p.followers.clear();
  for (const Joint& joint : p.joints.model) {
    const auto number = static_cast<Index>(p.joint_ends.size());
    p.works.push_back(joint.action || joint.drive || joint.turn);
    if (joint.action) p.acting.push_back(number);
    if (joint.follows) p.followers.push_back(number);
    p.joint_ends.emplace_back(joint.i, joint.j);
  }
  for (const Joint& joint : p.joints.pulls) p.joint_ends.emplace_back(joint.i, joint.j);
  p.works.resize(p.joint_ends.size(), 0);
  bool same = stays(bodies, last.bodies);
  same = stays(p.joints.model.size(), last.model_joints) && same;
  same = stays(p.model->fixed, last.fixed) && same;
  same = stays(p.joint_ends, last.joints) && same;
  same = couplings_stay(p, last.couplings) && same;
  same = manifolds_stay(it, last.manifolds) && same;
  if (same) return false;
  p.ends.fill(bodies, [&](const auto& visit) {
    for (std::size_t k = 0; k < it.manifold.size(); ++k) {
      const ContactManifold& manifold = it.manifold[k];
      const auto number = static_cast<Index>(k);
      const bool a = p.movable(manifold.a), b = p.movable(manifold.b);
      if (a) visit(manifold.a, ManifoldEnd{number, manifold.b, true, true});
      if (b) visit(manifold.b, ManifoldEnd{number, manifold.a, false, !a});
    }
  });
  p.joints_at.fill(bodies, [&](const auto& visit) {
    for (std::size_t k = 0; k < p.joint_ends.size(); ++k) {
      for (const Index i : {p.joint_ends[k].first, p.joint_ends[k].second}) {
        if (p.movable(i)) visit(i, static_cast<Index>(k));
      }
    }
  });
  if (!p.followers.empty()) list_couplings(p);
  return true;
}

}  // namespace pabd
