// SPDX-License-Identifier: MIT
// "color" and "material" of a body. Internal to sim/scene.
#pragma once

#include "sim/body/body_look.h"
#include "sim/scene/reader.h"
#include "sim/scene/write_values.h"

namespace pabd {

BodyLook read_look(const ObjectReader& body);

// Adds both keys as far as they say something: what read_look() makes the same look from.
void add_look(const BodyLook& look, OrderedJson& out);

}  // namespace pabd
