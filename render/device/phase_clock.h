// SPDX-License-Identifier: MIT
// How long parts of the work take on the GPU's own clock: time stamps between them, read when they are there.
#pragma once

#include <array>
#include <vector>

#include "render/device/compute_functions.h"

namespace pabd::device {

class PhaseClock {
 public:
  PhaseClock(const ComputeFunctions& gl, bool runs) : gl_(gl), runs_(runs) {}
  ~PhaseClock() {
    if (!stamps_.empty()) gl_.DeleteQueries(static_cast<GLsizei>(stamps_.size()), stamps_.data());
  }
  PhaseClock(const PhaseClock&) = delete;
  PhaseClock& operator=(const PhaseClock&) = delete;

  void start() {
    laps_.clear();
    stamp(0);
  }
  // What was asked for since the last call is measured into `ms`, which read() fills.
  void lap(double& ms) {
    laps_.push_back(&ms);
    stamp(laps_.size());
  }
  // Waits for the last stamp. Of the newest start() only.
  void read() const {
    if (!runs_) return;
    std::vector<GLuint64> at(laps_.size() + 1);
    for (std::size_t k = 0; k < at.size(); ++k) gl_.GetQueryObjectui64v(stamps_[k], GL_QUERY_RESULT, &at[k]);
    for (std::size_t k = 0; k < laps_.size(); ++k) *laps_[k] = 1e-6 * static_cast<double>(at[k + 1] - at[k]);
  }

 private:
  void stamp(std::size_t k) {
    if (!runs_) return;
    if (k == stamps_.size()) {
      stamps_.push_back(0);
      gl_.GenQueries(1, &stamps_.back());
    }
    gl_.QueryCounter(stamps_[k], GL_TIMESTAMP);
  }

  const ComputeFunctions& gl_;
  bool runs_;
  std::vector<GLuint> stamps_;
  std::vector<double*> laps_;
};

}  // namespace pabd::device
