// SPDX-License-Identifier: MIT
// A mesh of an PLY file.
#include "tests/fuzz/fuzz_mesh.h"

PABD_FUZZ_TARGET(ply, bytes) { pabd::fuzz::read_mesh(bytes, "ply"); }
