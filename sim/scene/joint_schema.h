// SPDX-License-Identifier: MIT
// The definitions of joints in the JSON Schema of scene files, as their traits give them.
#pragma once

#include "sim/body/joint.h"
#include "sim/scene/write_values.h"

namespace pabd {

// "$defs/hinge" and so on.
OrderedJson joint_schema(JointType type);

// "properties/joints/items": one of them.
OrderedJson joint_schema_list();

}  // namespace pabd
