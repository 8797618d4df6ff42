// SPDX-License-Identifier: MIT
// A mesh of an STL file.
#include "tests/fuzz/fuzz_mesh.h"

PABD_FUZZ_TARGET(stl, bytes) { pabd::fuzz::read_mesh(bytes, "stl"); }
