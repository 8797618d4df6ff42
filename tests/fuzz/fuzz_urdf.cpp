// SPDX-License-Identifier: MIT
// A robot in URDF.
#include "tests/fuzz/fuzz_robot.h"

PABD_FUZZ_TARGET(urdf, bytes) { pabd::fuzz::read_robot(bytes, "robot.urdf"); }
