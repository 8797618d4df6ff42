// SPDX-License-Identifier: MIT
// What of a robot is not in its scene, for whoever imports or runs it.
#pragma once

#include <string>
#include <vector>

#include "sim/import/notes.h"

namespace pabd::cli {

// A line each, to standard error.
void write_import_notes(const std::string& robot, const std::vector<ImportNote>& notes);

}  // namespace pabd::cli
