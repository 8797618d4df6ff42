// One entry of "bodies". Internal to sim/scene.
#pragma once

#include "sim/scene/builder.h"

namespace pabd {

// Reads body number `index`, which gives its name when the file has none: "body 3".
BodySpec read_body(const Node& node, std::size_t index);

}  // namespace pabd
