// SPDX-License-Identifier: MIT
// Who never touches whom. Internal to sim/scene.
#pragma once

#include "sim/scene/model_builder.h"

namespace pabd {

// "no_collide": pairs that never touch, each of the two the name of a body or { "group": its name }.
void read_no_collide(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out);

}  // namespace pabd
