// SPDX-License-Identifier: MIT
// A robot in MJCF.
#include "tests/fuzz/fuzz_robot.h"

PABD_FUZZ_TARGET(mjcf, bytes) { pabd::fuzz::read_robot(bytes, "robot.mjcf"); }
