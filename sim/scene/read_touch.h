// SPDX-License-Identifier: MIT
// How bodies touch others: friction and restitution of their own, groups, and who never touches whom. Internal to sim/scene.
#pragma once

#include "sim/scene/model_builder.h"

namespace pabd {

// "friction", "restitution" and "group" of a body, or of all bodies of a generator. Only what is there enters the hash.
TouchSpec read_touch(const ObjectReader& in);

// "no_collide": pairs that never touch, each of the two the name of a body or { "group": its name }.
void read_no_collide(const ObjectReader& scene, const BodyNames& names, ModelBuilder& out);

}  // namespace pabd
