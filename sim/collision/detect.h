// SPDX-License-Identifier: MIT
// Discrete collision detection: contact points between bodies at given poses.
#pragma once

#include <vector>

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/collision/broad_phase.h"
#include "sim/collision/kept_points.h"
#include "sim/collision/passage.h"
#include "sim/math/stop.h"
#include "sim/math/team.h"

namespace pabd {

// One contact point, S(17). World frame, at the poses given to `detect`.
struct ContactPoint {
  Index a, b;             // a owns the normal (the face); b the point. Not ordered by number
  Vec3 y_a, y_b;          // points on the two surfaces
  Vec3 n;                 // unit, outward from a towards b
  double d;               // (y_b − y_a)·n, negative when the bodies overlap; m
  std::uint32_t feature;  // stays the same for the same corner or edge pair from step to step
  // How far inside its body, along n, the point lies that rolling moves as it moves the centre; 0 of what is flat; m
  double round_a = 0, round_b = 0;
  double part = 1;               // of the way of the bodies, see Passage
  double least_start_d = -1e30;  // of d where they come from, whatever this plane says of that place; m
  bool crowded = false;          // of two bodies in crowds: the only one of them
};

// Threads, bounds and pair lists kept between calls so that a warm call does not allocate, and points of what rests. A fresh
// one gives the same bytes.
struct CollisionWorkspace {
  Team team;
  std::vector<Aabb> boxes;
  BroadPhase broad_phase;
  std::vector<std::pair<Index, Index>> pairs, merged;
  std::vector<PairCount> counts;  // of each pair
  KeptPoints kept;
  std::vector<std::size_t> by_body;                // contacts of round bodies with flat ones
  std::vector<std::vector<ContactPoint>> partial;  // a bucket a chunk of pairs, joined in order
  Stop stop;                                       // detection ends early, with what it has
  // Of the last call: pairs of crowded bodies that were not looked at, whether or not they overlap.
  std::int64_t left_pairs = 0;
};

// Fills `out` with every contact point whose d is below `reach`[a] + `reach`[b].
//   c, R     poses, one entry a body (m; rotation matrices)
//   passage  how bodies come there: some pairs are looked at on their way (ContactPoint::part)
//   reach    how far beyond its surface a body looks for contacts, ≥ 0, one entry a body; m
//   skip     sorted list of pairs (a < b) that never collide, for jointed bodies
// Two fixed bodies never meet, nor do two whose groups keep them apart. Of a crowd each body meets a few others
// (broad_phase.h), where they are deepest in each other. The result is sorted by (min(a,b), max(a,b), feature) and does
// not depend on `threads`.
void detect(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R,
            const Passage& passage, const std::vector<double>& reach,
            const std::vector<std::pair<Index, Index>>& skip, int threads, CollisionWorkspace& workspace,
            std::vector<ContactPoint>& out);
inline void detect(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R,
                   const std::vector<double>& reach, const std::vector<std::pair<Index, Index>>& skip,
                   int threads, CollisionWorkspace& workspace, std::vector<ContactPoint>& out) {
  detect(model, c, R, Passage{}, reach, skip, threads, workspace, out);
}

}  // namespace pabd
