// SPDX-License-Identifier: MIT
// See adaptation.h.
#include "app/serve/adaptation.h"

#include <algorithm>
#include <iterator>

namespace pabd {
namespace {

constexpr FrameLook kLooks[] = {{1, 85}, {1, 70}, {1, 55}, {0.75, 60}, {0.5, 60}, {0.5, 40}};
constexpr std::size_t kLast = std::size(kLooks) - 1;
constexpr std::size_t kFast = 3;  // what "fast" begins with
constexpr FrameLook kFine{1, 92};
constexpr double kShare = 0.25;      // weight of the newest in a smoothed value
constexpr std::size_t kTiny = 4000;  // bytes; a smaller frame measures the empty link
constexpr double kForgets = 1;       // ms by which the empty link may become slower with each such frame
constexpr double kPatience = 0.5;    // s between two steps down
constexpr double kRecovered = 2;     // s of low load before a step up
constexpr double kWell = 0.45;       // share of kFrameMs that counts as low load

}  // namespace

void Adaptation::choose(Mode mode) {
  mode_ = mode;
  level_ = mode == Mode::fast ? kFast : 0;
  good_since_ = -1;
}

double Adaptation::transfer_ms() const {
  auto sorted = late_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(count_, late_.size()));
  const auto middle = sorted.begin() + (end - sorted.begin()) / 2;
  std::nth_element(sorted.begin(), middle, end);
  return std::max(0.0, *middle - empty_ms_);
}

void Adaptation::took(double encode_ms, double link_ms, std::size_t bytes, double now) {
  late_[count_++ % late_.size()] = link_ms;
  if (bytes <= kTiny) empty_ms_ = empty_ms_ > 0 ? std::min(link_ms, empty_ms_ + kForgets) : link_ms;
  const double share = known_ ? kShare : 1;
  encode_ms_ += share * (encode_ms - encode_ms_);
  link_ms_ += share * (link_ms - link_ms_);
  known_ = true;
  const double ms = encode_ms_ + transfer_ms();
  if (ms > kFrameMs) {
    good_since_ = -1;
    if (now - changed_ < kPatience || level_ == kLast) return;
    ++level_;
    changed_ = now;
    return;
  }
  if (ms > kWell * kFrameMs) {
    good_since_ = -1;
    return;
  }
  if (good_since_ < 0) good_since_ = now;
  const std::size_t best = mode_ == Mode::fast ? kFast : 0;
  if (now - good_since_ < kRecovered || level_ <= best) return;
  --level_;
  changed_ = good_since_ = now;
}

FrameLook Adaptation::look() const { return mode_ == Mode::fine ? kFine : kLooks[level_]; }

}  // namespace pabd
