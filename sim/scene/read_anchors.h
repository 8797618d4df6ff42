// The memory of touching contacts, as state files and scenes hold it. Internal to sim/scene and sim/trace.
#pragma once

#include "sim/body/state.h"
#include "sim/scene/reader.h"

namespace pabd {

// Appends the entries of `list`: bodies by number, below `count`. They must come in rising order of bodies
// and feature.
void read_anchors(const Node& list, Index count, std::vector<FrictionAnchor>& out);

}  // namespace pabd
