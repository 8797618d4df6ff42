// SPDX-License-Identifier: MIT
// For programs that are built without Boost: asking for the server says so.
#include "app/cli/serve_setup.h"
#include "sim/base/error.h"

namespace pabd::cli {

int serve(const ServeSetup&) {
  throw Error(
      ErrorKind::bad_input,
      "no server: this program was built with PABD_SERVE=OFF; build it without that (scripts/setup installs "
      "Boost, libjpeg-turbo and OpenSSL), or use 'pabd view --script ACTIONS.json --headless'");
}

}  // namespace pabd::cli
