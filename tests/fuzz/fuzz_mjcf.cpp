// SPDX-License-Identifier: MIT
// A robot in MJCF.
#include "tests/fuzz/fuzz_robot.h"

void fuzz(std::string_view bytes) { pabd::fuzz::read_robot(bytes, "robot.mjcf"); }
