// SPDX-License-Identifier: MIT
#include "tests/bench/peers/rulers.h"

#include <algorithm>
#include <cmath>

#include "sim/joint/expand.h"

namespace pabd::peers {

void Depth::add(double depth) {
  if (!(depth > 0)) return;
  max = std::max(max, depth);
  sum += depth;
  ++count;
}

OverlapRuler::OverlapRuler(const Model& model)
    : model_(model), reach_(static_cast<std::size_t>(model.size()), 0.0) {}

void OverlapRuler::measure(const State& state, Depth& depth) {
  detect(model_, state.c, state.R, reach_, model_.no_collide, 1, workspace_, points_);
  for (const ContactPoint& point : points_) depth.add(-point.d);
}

double joint_drift(const Model& model, const State& state) {
  const auto anchor = [&](Index body, const JointFrame& frame) -> Vec3 {
    if (body == kWorld) return frame.r;
    const auto k = static_cast<std::size_t>(body);
    return state.c[k] + state.R[k] * frame.r;
  };
  double drift = 0;
  for (const Joint& joint : model.joints) {
    const double distance = (anchor(joint.j, joint.on_j) - anchor(joint.i, joint.on_i)).norm();
    if (!std::isfinite(distance)) return distance;
    drift = std::max(drift, distance);
  }
  return drift;
}

Index highest_body(const State& state) {
  Index top = 0;
  for (Index i = 1; i < state.size(); ++i) {
    if (state.c[i].y() > state.c[top].y()) top = i;
  }
  return top;
}

}  // namespace pabd::peers
