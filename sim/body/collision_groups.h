// SPDX-License-Identifier: MIT
// Groups of bodies, and which of them never touch each other. A body may belong to several.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

inline constexpr std::size_t kMostGroups = 64;  // a bit each

struct CollisionGroups {
  std::vector<std::string> name;       // at most kMostGroups
  std::vector<std::uint64_t> apart;    // a group: bits of the groups that it never touches; symmetric
  std::vector<std::uint64_t> of_body;  // a body: bits of its groups. Empty: there are no groups
  std::vector<std::uint64_t>
      avoids;  // a body: bits of all groups that it never touches. Empty: it touches all

  bool operator==(const CollisionGroups&) const = default;
};

// Do two bodies never touch because of their groups?
inline bool keeps_apart(const CollisionGroups& groups, Index a, Index b) {
  if (groups.avoids.empty()) return false;
  return (groups.avoids[a] & groups.of_body[b]) != 0;
}

// Fills `avoids` from the other lists.
void find_avoided(CollisionGroups& groups);

}  // namespace pabd
