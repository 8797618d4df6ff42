// SPDX-License-Identifier: MIT
// See keep_apart.h.
#include "sim/import/keep_apart.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/collision/detect.h"

namespace pabd {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;

using Pairs = std::vector<std::pair<int, int>>;

void add(Pairs& pairs, int a, int b) {
  if (a != b && a != kNoBody && b != kNoBody) pairs.emplace_back(std::minmax(a, b));
}

void sort(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (pairs.size() > kMostPairs) throw Error(ErrorKind::bad_input, "too many pairs that never touch");
}

// Of one robot, at the poses of the scene. Of a crowd not all pairs are looked at: they are, once others are apart.
Pairs near_pairs(const Scene& scene, std::size_t first, const ScenePlan& plan) {
  const Model& model = scene.model;
  const std::vector<double> reach(model.size(), scene.params.contact.d_hat / 2);
  std::vector<std::pair<Index, Index>> skip = model.no_collide;
  CollisionWorkspace workspace;
  Pairs out;
  for (bool more = true; more;) {
    std::vector<ContactPoint> points;
    detect(model, scene.initial.c, scene.initial.R, reach, skip, 1, workspace, points);
    more = false;
    for (const ContactPoint& point : points) {
      const auto [a, b] = std::minmax(point.a, point.b);
      if (static_cast<std::size_t>(a) < first) continue;
      const int x = static_cast<int>(a) - static_cast<int>(first),
                y = static_cast<int>(b) - static_cast<int>(first);
      const int tree = plan.bodies[static_cast<std::size_t>(x)].tree;
      if (tree == kNoTree || tree != plan.bodies[static_cast<std::size_t>(y)].tree) continue;
      if (!out.empty() && out.back() == std::pair(x, y)) continue;
      out.emplace_back(x, y);
      skip.emplace_back(a, b);
      more = workspace.left_pairs > 0;
    }
    std::sort(skip.begin(), skip.end());
  }
  return out;
}

}  // namespace

void keep_apart(const Robot& robot, const LinkGroups& groups, ScenePlan& plan) {
  const int n = static_cast<int>(plan.bodies.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      const BodyPlan &x = plan.bodies[static_cast<std::size_t>(a)],
                     &y = plan.bodies[static_cast<std::size_t>(b)];
      const bool meet = robot.contacts && ((x.type & y.affinity) != 0 || (y.type & x.affinity) != 0);
      if ((x.ghost || y.ghost || !meet) && !(x.fixed && y.fixed)) add(plan.apart, a, b);
    }
    if (plan.apart.size() > kMostPairs) throw Error(ErrorKind::bad_input, "too many pairs that never touch");
  }
  for (const LinkGroup& group : groups.groups) {
    if (group.still || group.dropped || group.link.parent == kNoLink) continue;
    const LinkGroup& parent = groups.groups[static_cast<std::size_t>(group.link.parent)];
    if (parent.still && robot.has_world) continue;
    if (!parent.still && group.link.joints.size() == 1) continue;  // their joint says it
    for (const int body : parent.bodies) add(plan.apart, group.bodies.front(), body);
  }
  const auto bodies_of = [&](int link) -> const std::vector<int>& {
    return groups.groups[static_cast<std::size_t>(groups.of[static_cast<std::size_t>(link)])].bodies;
  };
  for (const auto& [i, j] : robot.excludes) {
    for (const int x : bodies_of(i))
      for (const int y : bodies_of(j)) add(plan.apart, x, y);
  }
  sort(plan.apart);
}

void keep_apart(SelfCollision which, const Scene& scene, std::size_t first, ScenePlan& plan,
                ImportNotes& notes) {
  if (which == SelfCollision::all) return;
  if (which == SelfCollision::none) {
    const int n = static_cast<int>(plan.bodies.size());
    for (int a = 0; a < n; ++a) {
      const BodyPlan& x = plan.bodies[static_cast<std::size_t>(a)];
      for (int b = a + 1; b < n; ++b) {
        const BodyPlan& y = plan.bodies[static_cast<std::size_t>(b)];
        if (x.tree != kNoTree && x.tree == y.tree && !(x.fixed && y.fixed)) add(plan.apart, a, b);
      }
    }
    notes.add("links of one robot never touch each other, as --self-collision none asks", "", 0);
  } else {
    const Pairs near = near_pairs(scene, first, plan);
    if (near.empty()) return;
    plan.apart.insert(plan.apart.end(), near.begin(), near.end());
    notes.add(
        fmt::format("{} of links of one robot that touch at the start, or are nearer than d_hat: they never "
                    "touch each other (--self-collision all lets them)",
                    near.size() == 1 ? "a pair" : fmt::format("{} pairs", near.size())),
        "", 0);
  }
  sort(plan.apart);
}

}  // namespace pabd
