// SPDX-License-Identifier: MIT
// Pairs of bodies that may pass through each other within a step (Deviation D7).
//
// Contacts are looked for where the step ends. A pair that comes towards each other, along the normal of one of its
// contacts, by more than half of the thinner one's thickness along that normal may be past each other there: it is
// looked at where it first touches on its way. How fast bodies fly matters no more than that: a wheel does not come
// towards its road. So is a pair that is apart where it comes from while the planes of its contacts at the end say that it
// overlapped there: a corner that falls past another meets it from above, and is nearest to its side at the end.
#pragma once

#include <span>

#include "sim/body/model.h"
#include "sim/math/so3.h"

namespace pabd {

struct ContactPoint;

// How bodies come to the poses at which they are looked at; one entry a body, zero for what stays. Empty: they did not
// move.
struct Passage {
  std::span<const Vec3> c;  // where they come from; world, m
  std::span<const Mat3> R;
  std::span<const Vec3> way;     // of their centres; m
  std::span<const Vec3> turn;    // rotation vectors; world, rad
  std::span<const double> spin;  // how far their surfaces turn, at most; m
  double touching = 0;           // what is closer touches; m
  bool from_start = false;       // all are looked at where they come from

  // Part 0 of the way is its start.
  Vec3 c_at(Index i, double part) const { return c[at(i)] + part * way[at(i)]; }
  Mat3 R_at(Index i, double part) const { return exp_so3(part * turn[at(i)]) * R[at(i)]; }

  const Vec3& way_of(Index i) const { return way[at(i)]; }
  // How far a point of one moves as seen from the other, at most; m.
  double farthest(Index i, Index j) const {
    return (way[at(i)] - way[at(j)]).norm() + spin[at(i)] + spin[at(j)];
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
};

// May the two bodies be past each other at the end, if these are their contacts where they are on their way?
bool may_pass(const Model& model, const Passage& passage, std::span<const ContactPoint> points);

}  // namespace pabd
