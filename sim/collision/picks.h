// SPDX-License-Identifier: MIT
// The corners of a clipped face that become contacts, one a name: the first, unless a later one is clearly
// deeper. Internal.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pabd::narrow {

// A corner has its height above the reference face in `z`.
template <class Corner, int kMost>
class Picks {
 public:
  struct Pick {
    Corner corner;
    std::uint32_t name;
  };

  explicit Picks(double clearly) : clearly_(clearly) {}

  void add(const Corner& p, std::uint32_t name) {
    lowest_ = std::min(lowest_, p.z);
    for (int i = 0; i < size_; ++i) {
      if (pick_[i].name != name) continue;
      if (p.z < pick_[i].corner.z - clearly_) pick_[i].corner = p;
      return;
    }
    pick_[size_++] = {p, name};
  }

  int size() const { return size_; }
  const Pick& operator[](int i) const { return pick_[i]; }
  double lowest() const { return lowest_; }  // infinite when empty

 private:
  double clearly_, lowest_ = std::numeric_limits<double>::infinity();
  int size_ = 0;
  Pick pick_[kMost];
};

}  // namespace pabd::narrow
