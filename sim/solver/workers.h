// SPDX-License-Identifier: MIT
// Who works on a step, and until when.
#pragma once

#include "sim/math/stop.h"
#include "sim/math/team.h"

namespace pabd {

// What a thread takes at a time, some microseconds of work: bodies or contacts of a simple loop, bodies of a sweep (a colour of
// a pile of a thousand has a hundred).
inline constexpr std::size_t kBlock = 64, kSweepBlock = 8;

struct Workers {
  Team& team;
  int threads;
  Stop stop;

  template <class Body>
  void for_each(std::size_t count, const Body& body) const {
    team.for_each(threads, count, kBlock, body);
  }
  template <class Body>
  void for_each_in_sweep(std::size_t count, const Body& body) const {
    team.for_each(threads, count, kSweepBlock, body);
  }
  // For work inside a piece of work that is shared already.
  Workers alone() const { return {team, 1, stop}; }
};

}  // namespace pabd
