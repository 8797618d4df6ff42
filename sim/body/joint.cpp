// SPDX-License-Identifier: MIT
#include "sim/body/joint.h"

namespace pabd {

const char* to_string(JointType type) {
  static constexpr const char* kWords[] = {
#define PABD_TYPE(name) #name,
      PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
  };
  return kWords[static_cast<std::size_t>(type)];
}

std::optional<JointType> joint_type(std::string_view word) {
  for (const JointType type : kJointTypes)
    if (word == to_string(type)) return type;
  return std::nullopt;
}

}  // namespace pabd
