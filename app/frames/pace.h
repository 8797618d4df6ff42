// SPDX-License-Identifier: MIT
// --speed: how fast a video shows what is simulated.
#pragma once

#include <string>
#include <vector>

namespace pabd {

// Simulated time over the time of the video.
class Pace {
 public:
  Pace() = default;
  // "0.1", or with other speeds from one simulated time to another, s: "1,0.1:0.8-1.2,0.05:3-3.1". Throws
  // Error(bad_input).
  explicit Pace(const std::string& text);

  // Of a video, s since its start, and of the simulation, s since the first frame: from one to the other.
  double simulated(double shown) const;
  double shown(double simulated) const;

  // If not, frames may show what lies between two steps.
  bool is_real_time() const { return parts_.empty() && speed_ == 1; }

 private:
  struct Part {
    double from, to;  // s, simulated
    double speed;
  };
  double speed_ = 1;
  std::vector<Part> parts_;  // in order, apart from each other
};

std::string speed_help();

}  // namespace pabd
