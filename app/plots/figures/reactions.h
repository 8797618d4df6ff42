// SPDX-License-Identifier: MIT
// What joints carry over time: the force through each, and how far its points are apart.
#pragma once

#include <string>
#include <vector>

#include "app/plots/plot.h"

namespace pabd {

struct JointSeries {
  std::string name;
  std::vector<double> force;  // ‖f‖; N
  std::vector<double> error;  // largest distance between points that it holds together; m
};

// Keeps the `most` joints with the largest forces, the largest first; equal ones in their order.
void keep_strongest(std::vector<JointSeries>& joints, std::size_t most);

// Left the forces, right the errors (log), over the times (s) of the steps; a curve a joint, in their order.
Figure reactions_figure(const std::vector<double>& time, const std::vector<JointSeries>& joints);

}  // namespace pabd
