// SPDX-License-Identifier: MIT
// A mesh of an OBJ file.
#include "tests/fuzz/fuzz_mesh.h"

PABD_FUZZ_TARGET(obj, bytes) { pabd::fuzz::read_mesh(bytes, "obj"); }
