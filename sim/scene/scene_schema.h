// SPDX-License-Identifier: MIT
// What is written about the keys of scene files, from the lists that the reader has (field.h) and the table of
// parameters: the JSON Schema and a reference for people. assets/ has both; tests compare, and write them anew with
// PABD_UPDATE_GOLDEN=1.
#pragma once

#include <string>

namespace pabd {

std::string scene_schema();   // assets/pabd-scene.schema.json
std::string key_reference();  // assets/keys.md

}  // namespace pabd
