// SPDX-License-Identifier: MIT
// See frame_source.h.
#include "app/frames/frame_source.h"

#include <utility>

#include "app/session/step_at_time.h"

namespace pabd {
namespace {

constexpr std::size_t kMostDistances = 40000;

}  // namespace

Frame make_frame(int number, FrameView a, std::optional<FrameView> b, const DistanceList& apart) {
  if (b) {
    a.label = std::string("A");
    b->label = std::string("B");
  }
  return {number, std::move(a), std::move(b), apart.view()};
}

void add_distance(const Run& a, const Run& b, DistanceList& distances) {
  if (!at_common_time(a, b)) return;
  const StateDistance apart = state_distance(a.state(), b.state());
  distances.push_back({a.state().time, apart.position, apart.angle});
}

void drop_old(DistanceList& distances) {
  if (distances.size() >= kMostDistances) distances.drop_front(kMostDistances / 2);
}

}  // namespace pabd
