// SPDX-License-Identifier: MIT
// Progress on standard error.
#include "app/cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/cli/streams.h"
#include "sim/base/counted.h"

namespace pabd::cli {
namespace {

constexpr int kBarWidth = 24;

std::string duration(double seconds) {
  const auto s = static_cast<std::int64_t>(seconds + 0.5);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{}:{:02} min", s / 60, s % 60);
  return fmt::format("{}:{:02} h", s / 3600, s / 60 % 60);
}

std::string step_details(const StepSummary& report) {
  return fmt::format("iterations {}  residual {:.1e}", report.iterations, report.residual);
}

}  // namespace

std::string progress_line(const std::string& unit, std::int64_t done, std::int64_t total, double seconds_left,
                          const std::string& details, bool bar) {
  std::string line;
  if (bar) {
    const auto filled = static_cast<int>(kBarWidth * done / std::max<std::int64_t>(total, 1));
    line = fmt::format("[{}{}] ", std::string(filled, '#'), std::string(kBarWidth - filled, '.'));
  }
  const auto word = std::min(unit.find(' '), unit.size());  // "steps of pile"
  return line + fmt::format("{} of {}{}  {} %  ETA {}{}{}", done, counted(total, unit.substr(0, word)),
                            unit.substr(word), 100 * done / std::max<std::int64_t>(total, 1),
                            duration(seconds_left), details.empty() ? "" : "  ", details);
}

std::string progress_line(const std::string& unit, std::int64_t done, std::int64_t total, double seconds_left,
                          const StepSummary& report, bool bar) {
  return progress_line(unit, done, total, seconds_left, step_details(report), bar);
}

Progress::Progress(std::string unit, std::int64_t total, bool enabled)
    : unit_(std::move(unit)),
      total_(total),
      enabled_(enabled),
      terminal_(stderr_is_terminal()),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (open_line_) write_stderr("\n");
}

void Progress::update(std::int64_t done, const StepSummary& report) { update(done, step_details(report)); }

void Progress::update(std::int64_t done, const std::string& details) {
  if (!enabled_ || done <= 0) return;
  const auto now = Clock::now();
  const double pause = terminal_ ? 0.1 : 2.0;
  const bool last = done == total_;
  if (std::chrono::duration<double>(now - last_).count() < pause && !(last && open_line_)) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = elapsed * static_cast<double>(total_ - done) / static_cast<double>(done);
  const std::string line = progress_line(unit_, done, total_, left, details, terminal_);
  // "\033[K" clears what a longer line before left behind.
  write_stderr(terminal_ ? fmt::format("\r{}\033[K", line) : line + "\n");
  open_line_ = terminal_;
}

}  // namespace pabd::cli
