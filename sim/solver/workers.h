// Who works on a step, and until when.
#pragma once

#include "sim/math/stop.h"
#include "sim/math/team.h"

namespace pabd {

// Bodies or contacts that a thread takes at a time: some ten microseconds of work.
inline constexpr std::size_t kBlock = 64;

struct Workers {
  Team& team;
  int threads;
  Stop stop;

  template <class Body>
  void for_each(std::size_t count, const Body& body) const {
    team.for_each(threads, count, kBlock, body);
  }
  // For work inside a piece of work that is shared already.
  Workers alone() const { return {team, 1, stop}; }
};

}  // namespace pabd
