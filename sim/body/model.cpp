// SPDX-License-Identifier: MIT
// Questions about a whole model.
#include "sim/body/model.h"

#include <algorithm>

namespace pabd {

double heaviest_mass(const Model& model) {
  double heaviest = 0.0;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    if (!model.fixed[i]) heaviest = std::max(heaviest, model.mass[i]);
  }
  return heaviest;
}

}  // namespace pabd
