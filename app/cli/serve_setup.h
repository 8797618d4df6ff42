// SPDX-License-Identifier: MIT
// What 'pabd serve' was asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/common.h"

namespace pabd::cli {

struct ServeSetup {
  CommonOptions common;
  std::string scene = "two_boxes", backend = "auto", size = "1280x720", root, certificate, key, embed;
  std::vector<std::string> addresses, hosts;
  std::optional<int> port;  // none: 8472, or one of the next 19
  int sessions = 1;
  bool trusted = false, no_watchers = false, pause_when_alone = false, play = false;
  double past = 256, idle_limit = 10;  // MB, minutes
};

// Until SIGINT or SIGTERM. Throws Error; of a program that was built without it Error(bad_input).
int serve(const ServeSetup& setup);

}  // namespace pabd::cli
