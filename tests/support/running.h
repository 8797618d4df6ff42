// SPDX-License-Identifier: MIT
// Do programs still run?
#pragma once

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace pabd {

// A process that nobody has asked for its end yet has ended all the same.
inline bool is_running(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  if (!std::getline(file, text)) return false;
  const auto name_end = text.rfind(')');
  return name_end == std::string::npos || (text[name_end + 2] != 'Z' && text[name_end + 2] != 'X');
}

// There are `count` numbers in `pids`, and none of them runs, or soon none: to be killed takes a moment.
inline bool all_ended(const std::string& pids, int count) {
  std::istringstream in(pids);
  int found = 0;
  for (int pid; in >> pid; ++found) {
    for (int i = 0; i < 4000 && is_running(pid); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (is_running(pid)) return false;
  }
  return found == count;
}

}  // namespace pabd
