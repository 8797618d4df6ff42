// SPDX-License-Identifier: MIT
// How far a run is, on standard error: a bar that is redrawn on a terminal, a line every two seconds
// elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "sim/solver/report.h"

namespace pabd::cli {

// One line: "3 of 12 tasks  25 %  ETA 9 s  1 diverged", with a bar in front on a terminal.
std::string progress_line(const std::string& unit, std::int64_t done, std::int64_t total, double seconds_left,
                          const std::string& details, bool bar);
// Of steps: "12 of 300 frames  4 %  ETA 31 s  iterations 7  residual 3.1e-07".
std::string progress_line(const std::string& unit, std::int64_t done, std::int64_t total, double seconds_left,
                          const StepSummary& report, bool bar);

class Progress {
 public:
  // `unit` is what is counted: "frame", "step", "step of pile". Silent when not `enabled`.
  Progress(std::string unit, std::int64_t total, bool enabled);
  ~Progress();  // leaves the cursor on a fresh line

  void update(std::int64_t done, const StepSummary& report);
  void update(std::int64_t done, const std::string& details);

 private:
  using Clock = std::chrono::steady_clock;
  std::string unit_;
  std::int64_t total_;
  bool enabled_;
  bool terminal_;
  bool open_line_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace pabd::cli
