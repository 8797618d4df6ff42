// SPDX-License-Identifier: MIT
// The constant part of a simulation: what the bodies are. Built and validated once, then never changed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/body/joint.h"
#include "sim/body/shape.h"

namespace pabd {

// Structure of arrays, one entry a body. Bodies keep the order of the scene file; generated ones follow.
struct Model {
  std::vector<std::string> name;
  std::vector<Shape> shape;
  std::vector<double> mass;         // kg; 0 for a fixed body
  std::vector<Mat3> J;              // kg m², body frame; zero for a fixed body
  std::vector<std::uint8_t> fixed;  // 1: never moves
  std::vector<Joint> joints;
  std::vector<std::pair<Index, Index>> no_collide;  // pairs a < b that never touch, sorted

  Index size() const { return static_cast<Index>(shape.size()); }
};

// Largest mass of a movable body; 0 when there is none.
double heaviest_mass(const Model& model);

}  // namespace pabd
