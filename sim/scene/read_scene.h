// SPDX-License-Identifier: MIT
// A scene's document, wherever it is from: a file, or a SceneBuilder. Internal to sim/scene.
#pragma once

#include "sim/scene/include_library.h"
#include "sim/scene/mesh_library.h"
#include "sim/scene/reader.h"
#include "sim/scene/scene.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// Refuses what is no scene, or one of another version.
void check_format(const Json& document, ReadContext& context);

// Reads, validates and expands a scene; all but its files. Throws Error(bad_input).
Scene read_scene(const Json& document, ReadContext& context, MeshLibrary& meshes, IncludeLibrary& includes,
                 ParameterTable table = parameter_table());

}  // namespace pabd
