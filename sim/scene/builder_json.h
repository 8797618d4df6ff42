// SPDX-License-Identifier: MIT
// Entries of a SceneBuilder as the values of a scene file. Internal to sim/scene.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/scene/builder.h"
#include "sim/scene/document.h"
#include "sim/scene/write_values.h"

namespace pabd {

Json json_of(const spec::Law& law);
Json json_of(const spec::Mesh& mesh);
Json json_of(const spec::Body& body);  // without its shape
Json json_of(const spec::Joint& joint);
Json json_of(const spec::NoCollide& pair);
Json json_of(const spec::Include& include);
// Without their type.
Json json_of(const spec::Stack& stack);
Json json_of(const spec::Wall& wall);
Json json_of(const spec::Pyramid& pyramid);
Json json_of(const spec::Pile& pile);
Json json_of(const spec::Chain& chain);
Json json_of(const spec::Net& net);
Json json_of(const CameraDesc& camera);

}  // namespace pabd
