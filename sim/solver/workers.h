// SPDX-License-Identifier: MIT
// Who works on a step, and until when.
#pragma once

#include <algorithm>
#include <vector>

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
  // Σ term(k) from `zero` on, in blocks of one size, so that it is the same for every number of threads. `blocks` is scratch.
  template <class Value, class Term>
  Value sum(std::size_t count, const Value& zero, std::vector<Value>& blocks, const Term& term) const {
    constexpr std::size_t kTerms = 512;
    blocks.assign((count + kTerms - 1) / kTerms, zero);
    team.for_each(threads, blocks.size(), 1, [&](std::size_t b) {
      const std::size_t end = std::min(count, (b + 1) * kTerms);
      for (std::size_t k = b * kTerms; k < end; ++k) blocks[b] += term(k);
    });
    Value total = zero;
    for (const Value& block : blocks) total += block;
    return total;
  }
  // For work inside a piece of work that is shared already.
  Workers alone() const { return {team, 1, stop}; }
};

}  // namespace pabd
