// SPDX-License-Identifier: MIT
#include "sim/joint/joint_traits.h"

namespace pabd {

const JointTraits& traits_of(JointType type) {
  static constexpr const JointTraits* kTraits[] = {
#define PABD_TYPE(name) &joints::name,
      PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
  };
  return *kTraits[static_cast<std::size_t>(type)];
}

const JointMeasure* measure_with(const JointTraits& traits, Rare<JointRange> Joint::*limits) {
  for (const JointMeasure& measure : traits.measures)
    if (measure.limits == limits) return &measure;
  return nullptr;
}

bool has_arms(const Joint& joint) {
  const JointTraits& traits = traits_of(joint.type);
  return !traits.points && (!traits.turn || joint.turn);
}

bool is_ball(const Joint& joint) {
  return !traits_of(joint.type).points && !has_arms(joint) && !joint.action;
}

}  // namespace pabd
