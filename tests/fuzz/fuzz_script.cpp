// SPDX-License-Identifier: MIT
// A script of actions, read and checked, not played.
#include "app/gui/script_actions.h"
#include "tests/fuzz/fuzz.h"

PABD_FUZZ_TARGET(script, bytes) {
  pabd::fuzz::accepts([&] { pabd::read_script(std::string(bytes), "script.json"); });
}
