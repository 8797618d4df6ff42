// SPDX-License-Identifier: MIT
// See crowd.h.
#include "app/plots/crowd.h"

#include <algorithm>
#include <cmath>

namespace pabd {

std::vector<CrowdMarker> thin_crowd(const PlotLayout& layout, const Series& series, double spacing) {
  std::vector<CrowdMarker> out;
  const Rect room = layout.inner.inset(-1);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const Point at = layout.map(series.x[i], series.y[i], series.right_axis);
    if (!room.contains(at)) continue;
    double least = spacing;
    CrowdMarker* nearest = nullptr;
    for (CrowdMarker& marker : out) {
      const double distance = std::hypot(marker.at.x - at.x, marker.at.y - at.y);
      if (distance < least) {
        least = distance;
        nearest = &marker;
      }
    }
    if (nearest) {
      ++nearest->count;
    } else {
      out.push_back({i, at, 1});
    }
  }
  return out;
}

double crowd_size(std::size_t count) {
  return std::min(0.45 * kCrowdSpacing,
                  1 + 0.15 * std::log10(static_cast<double>(std::max<std::size_t>(count, 1))));
}

}  // namespace pabd
