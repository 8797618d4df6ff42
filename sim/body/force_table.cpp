// SPDX-License-Identifier: MIT
#include "sim/body/force_table.h"

#include <algorithm>

namespace pabd {
namespace {

using Points = std::vector<std::pair<double, double>>;

// Number of the segment that has x, or is nearest to it.
std::size_t segment_of(const Points& points, double x) {
  const auto after =
      std::upper_bound(points.begin() + 1, points.end() - 1, x,
                       [](double place, const std::pair<double, double>& p) { return place < p.first; });
  return static_cast<std::size_t>(after - points.begin()) - 1;
}

double slope_of(const Points& points, std::size_t k) {
  return (points[k + 1].second - points[k].second) / (points[k + 1].first - points[k].first);
}

double force_on(const Points& points, std::size_t k, double x) {
  return points[k].second + slope_of(points, k) * (x - points[k].first);
}

}  // namespace

ForceTable::Value ForceTable::at(double x) const {
  const std::size_t at_x = segment_of(points, x), at_0 = segment_of(points, 0);
  // From the lower of 0 and x to the upper one, segment by segment.
  const std::size_t first = std::min(at_0, at_x), last = std::max(at_0, at_x);
  const double from = std::min(0.0, x), to = std::max(0.0, x);
  double energy = 0;
  for (std::size_t k = first; k <= last; ++k) {
    const double low = k == first ? from : points[k].first, high = k == last ? to : points[k + 1].first;
    energy += 0.5 * (force_on(points, k, low) + force_on(points, k, high)) * (high - low);
  }
  return {x < 0 ? -energy : energy, force_on(points, at_x, x), slope_of(points, at_x)};
}

}  // namespace pabd
