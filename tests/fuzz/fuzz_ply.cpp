// SPDX-License-Identifier: MIT
// A mesh of an PLY file.
#include "tests/fuzz/fuzz_mesh.h"

void fuzz(std::string_view bytes) { pabd::fuzz::read_mesh(bytes, "ply"); }
