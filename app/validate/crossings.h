// SPDX-License-Identifier: MIT
// When a quantity that is seen at steps goes through zero, between them.
#pragma once

#include <limits>
#include <vector>

namespace pabd::validate {

class Crossings {
 public:
  // The quantity at `time`, in order. Counts where it rises through 0.
  void see(double time, double value) {
    if (last_ < 0 && value >= 0) at_.push_back(last_time_ + (time - last_time_) * last_ / (last_ - value));
    last_ = value;
    last_time_ = time;
  }

  const std::vector<double>& at() const { return at_; }
  // Mean time between two; NaN with fewer.
  double period() const {
    if (at_.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    return (at_.back() - at_.front()) / static_cast<double>(at_.size() - 1);
  }

 private:
  double last_ = 0, last_time_ = 0;
  std::vector<double> at_;
};

}  // namespace pabd::validate
