// SPDX-License-Identifier: MIT
// A message of a page to 'pabd serve'.
#include "app/serve/messages.h"
#include "tests/fuzz/fuzz.h"

PABD_FUZZ_TARGET(message, bytes) {
  pabd::fuzz::accepts([&] { pabd::read_client_message(bytes); });
}
