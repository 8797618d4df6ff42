// SPDX-License-Identifier: MIT
// See pace.h.
#include "app/frames/pace.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kSlowest = 1e-4, kFastest = 1000, kLastTime = 1e6;

[[noreturn]] void fail(const std::string& text, const std::string& why) {
  throw Error(ErrorKind::bad_input, fmt::format("--speed {}: {}; expected {}", text, why, speed_help()));
}

double number(const std::string& text, std::string_view word, double lo, double hi) {
  double value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size() || !(value >= lo && value <= hi))
    fail(text, fmt::format("'{}' is not a number from {} to {}", word, lo, hi));
  return value;
}

}  // namespace

std::string speed_help() {
  return "simulated time over the video's (default 1; 0.1: slow motion), with other speeds from one "
         "simulated "
         "time to another: 1,0.1:0.8-1.2 (s)";
}

Pace::Pace(const std::string& text) {
  std::istringstream words(text);
  bool whole = false;
  for (std::string word; std::getline(words, word, ',');) {
    const std::string_view view = word;
    const auto colon = view.find(':'), dash = view.find('-', colon == view.npos ? 0 : colon);
    const double speed = number(text, view.substr(0, colon), kSlowest, kFastest);
    if (colon == view.npos) {
      if (whole) fail(text, "two speeds for the whole");
      speed_ = speed;
      whole = true;
      continue;
    }
    if (dash == view.npos) fail(text, fmt::format("'{}' needs two times, as 0.8-1.2", word));
    const double from = number(text, view.substr(colon + 1, dash - colon - 1), 0, kLastTime);
    const double to = number(text, view.substr(dash + 1), 0, kLastTime);
    if (!(from < to)) fail(text, fmt::format("'{}' ends before it begins", word));
    parts_.push_back({from, to, speed});
  }
  if (!whole && parts_.empty()) fail(text, "no number");
  std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.from < b.from; });
  for (std::size_t k = 1; k < parts_.size(); ++k)
    if (parts_[k].from < parts_[k - 1].to) fail(text, "two speeds at one time");
}

double Pace::simulated(double shown) const {
  double time = 0;
  for (const Part& part : parts_) {
    const double before = (part.from - time) / speed_;
    if (shown <= before) break;
    shown -= before;
    const double inside = (part.to - part.from) / part.speed;
    if (shown <= inside) return part.from + shown * part.speed;
    shown -= inside;
    time = part.to;
  }
  return time + shown * speed_;
}

double Pace::shown(double simulated) const {
  double out = simulated / speed_;
  for (const Part& part : parts_)
    out += std::clamp(simulated - part.from, 0.0, part.to - part.from) * (1 / part.speed - 1 / speed_);
  return out;
}

}  // namespace pabd
