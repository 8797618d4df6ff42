// SPDX-License-Identifier: MIT
// Yardsticks that are the same for every engine: they read nothing but its poses and velocities.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/collision/detect.h"
#include "sim/solver/params.h"

namespace pabd::peers {

struct Depth {
  double max = 0;  // m
  double sum = 0;
  std::int64_t count = 0;
  void add(double depth);
  double mean() const { return count ? sum / static_cast<double>(count) : 0; }
};

// Overlap of the poses, by this project's collision code; joined bodies do not count.
class OverlapRuler {
 public:
  explicit OverlapRuler(const Model& model);
  void measure(const State& state, Depth& depth);

 private:
  const Model& model_;
  std::vector<double> reach_;
  CollisionWorkspace workspace_;
  std::vector<ContactPoint> points_;
};

// Largest distance of the two anchor points of a joint over all joints; m. NaN where a pose is not finite.
double joint_drift(const Model& model, const State& state);

Index highest_body(const State& state);

}  // namespace pabd::peers
