// SPDX-License-Identifier: MIT
// One entry of "bodies". Internal to sim/scene.
#pragma once

#include "sim/scene/mesh_library.h"
#include "sim/scene/model_builder.h"

namespace pabd {

// Reads body number `index`, which gives its name when the file has none: "body 3". Meshes come from
// `meshes`.
BodySpec read_body(const Node& node, std::size_t index, MeshLibrary& meshes);

}  // namespace pabd
