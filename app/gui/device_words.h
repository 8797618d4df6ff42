// SPDX-License-Identifier: MIT
// Who makes the steps, in words of a line.
#pragma once

#include <string>

#include "app/workbench/snapshot.h"

namespace pabd {

// "GPU · llvmpipe"; "CPU" where another might have been, of both runs where they differ; empty where nobody asked.
std::string device_words(const Snapshot& snapshot);
// In sentences, for a tooltip; empty likewise.
std::string device_story(const Snapshot& snapshot);

}  // namespace pabd
