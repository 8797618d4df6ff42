// SPDX-License-Identifier: MIT
// May a file be written from the window or a script? One rule for all that they save.
#pragma once

#include <string>

namespace pabd {

// Throws Error(bad_input) for no name and for the scene that is open (a path; empty: it has no file), and
// Error(exists) for what is there already and not to be replaced.
void check_output(const std::string& path, bool force, const std::string& open_scene = {});

// Whether both are the same file, whatever their names.
bool same_file(const std::string& a, const std::string& b);

}  // namespace pabd
