// SPDX-License-Identifier: MIT
// A mesh of an STL file.
#include "tests/fuzz/fuzz_mesh.h"

void fuzz(std::string_view bytes) { pabd::fuzz::read_mesh(bytes, "stl"); }
