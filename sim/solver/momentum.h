// SPDX-License-Identifier: MIT
// Momentum of what hangs together, to rounding, however far a solve came (Deviation D15).
//
// A solve that stops early leaves forces on a body that its neighbours do not feel, and the implicit step itself damps what turns
// about a common centre. Bodies without external forces, weight aside, only pass momentum on among themselves:
//
//   P  = Σ m v*                                     kg m/s
//   L  = Σ (c₀ − o) × m v* + I ω*                   kg m²/s, c₀ the centres at the start of the step
//
// What is missing is given to all bodies of a group as one rigid motion, of which bonds inside feel nothing: the smallest change
// of the velocities, in the norm of the kinetic energy, that restores the sums.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// Bodies that felt each other in a step, and no external force but weight.
struct FreeGroup {
  Index count = 0;
  double mass = 0;
  double h = 0;                             // Flight::h of its bodies; s
  Vec3 origin = Vec3::Zero();               // of moments; world, m
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();  // what its momentum should be
  Vec3 missing_P, missing_L;                // of that
  Vec3 centre;                              // of mass, from the origin; m
  Vec3 start = Vec3::Zero();                // of mass where the step starts; world, m
  bool about_centre = false;                // L is, in a step of second order (second_order.h)
  Mat3 I;                                   // about it; kg m²
  Vec3 v, omega;                            // rigid motion that is missing, or that carries P and L
  Mat3 turn;                                // its rotation in a step
};
struct FreeGroups {
  std::vector<Index> parent, number;
  std::vector<std::uint8_t> held;
  std::vector<FreeGroup> group;
  std::vector<std::pair<Index, Index>> bodies;  // and their groups
};

// The groups of bodies that felt each other in the solve, and no external force but weight: no fixed body,
// no joint to the world, no pull; and their momentum.
void find_free_groups(const Problem& p, const Islands& islands, const Iterate& it, FreeGroups& out);

// Moves each as a whole by what its momentum misses, and a body that felt nothing back to its free flight.
// Not for the log barrier's poses, whose gaps must stay open: there only velocities are balanced.
void balance_poses(const Problem& p, FreeGroups& groups, Iterate& it);

// The same for the velocities that follow from the poses; to rounding.
void balance_velocities(const Problem& p, const Iterate& it, FreeGroups& groups, Velocities& velocities);

// Finds the rigid motion of each group that carries its momentum, for inner_motion().
void find_rigid_motions(const Problem& p, const Iterate& it, FreeGroups& groups);

// Where the bodies of an island would be had they gone from the start by these motions alone; one entry a body.
void rigidly_moved(const Problem& p, const Island& island, FreeGroups& groups, std::vector<Pose>& out);

// What the velocities (v, ω) of body i, whose centre is at c, are beside that: all of them where its group is not free.
std::pair<Vec3, Vec3> inner_motion(const FreeGroups& groups, Index i, const Vec3& c,
                                   const Velocities& velocities);

}  // namespace pabd
