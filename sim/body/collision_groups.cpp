// SPDX-License-Identifier: MIT
#include "sim/body/collision_groups.h"

#include <algorithm>

namespace pabd {

void find_avoided(CollisionGroups& groups) {
  groups.avoids.clear();
  if (std::all_of(groups.apart.begin(), groups.apart.end(), [](std::uint64_t bits) { return bits == 0; }))
    return;
  groups.avoids.assign(groups.of_body.size(), 0);
  for (std::size_t i = 0; i < groups.of_body.size(); ++i) {
    for (std::size_t g = 0; g < groups.apart.size(); ++g)
      if ((groups.of_body[i] >> g & 1) != 0) groups.avoids[i] |= groups.apart[g];
  }
}

}  // namespace pabd
