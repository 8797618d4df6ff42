// SPDX-License-Identifier: MIT
// Questions about a whole model.
#include "sim/body/model.h"

#include <algorithm>

namespace pabd {

MovableMass movable_mass(const Model& model) {
  MovableMass out;
  bool any = false;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    if (model.fixed[i]) continue;
    out.total += model.mass[i];
    out.heaviest = std::max(out.heaviest, model.mass[i]);
    out.lightest = any ? std::min(out.lightest, model.mass[i]) : model.mass[i];
    any = true;
  }
  return out;
}

double most_external_force(const Model& model) {
  double sum = 0;
  for (const auto& external : model.external) {
    double most = 0;
    if (external && external->force)
      for (const auto& [time, force] : external->force->keys) most = std::max(most, force.norm());
    sum += most;
  }
  return sum;
}

}  // namespace pabd
