// SPDX-License-Identifier: MIT
#include "sim/collision/kept_points.h"

#include <algorithm>
#include <cstring>

#include "sim/collision/detect.h"

namespace pabd {
namespace {

// Data of hulls, compounds and solids never changes, and lives as long as a copy of the shape.
struct SameShape {
  const Shape& other;
  bool operator()(const Box& box) const { return box.half == std::get<Box>(other).half; }
  bool operator()(const Sphere& sphere) const { return sphere.radius == std::get<Sphere>(other).radius; }
  bool operator()(const Capsule& capsule) const {
    const auto& with = std::get<Capsule>(other);
    return capsule.radius == with.radius && capsule.length == with.length;
  }
  bool operator()(const Plane& plane) const {
    const auto& with = std::get<Plane>(other);
    return plane.normal == with.normal && plane.offset == with.offset;
  }
  template <class Shared>
  bool operator()(const Shared& shape) const {
    return shape.data == std::get<Shared>(other).data;
  }
};
bool same(const Shape& a, const Shape& b) { return a.index() == b.index() && std::visit(SameShape{b}, a); }

}  // namespace

void KeptPoints::begin(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R,
                       const Passage& passage, const std::vector<double>& reach) {
  constexpr double kHardly = 1e-6;  // of what touches: others are not worth a memory
  const std::size_t n = model.shape.size();
  const bool told_alike = passage.touching == touching_ && passage.from_start == from_start_;
  touching_ = passage.touching;
  from_start_ = passage.from_start;
  still_.assign(n, 0);
  any_still_ = false;
  seen_.swap(last_);
  seen_.clear();
  if (passage.c.empty()) return;
  auto last = last_.begin();
  for (std::size_t i = 0; i < n; ++i) {
    if (!model.fixed[i] && !(passage.way[i].norm() + passage.spin[i] < kHardly * passage.touching)) continue;
    const Place place = {c[i], passage.c[i], passage.way[i],  passage.turn[i],
                         R[i], passage.R[i], passage.spin[i], reach[i]};
    const auto body = static_cast<Index>(i);
    const bool fixed = model.fixed[i] != 0;
    last = std::find_if(last, last_.end(), [body](const Seen& seen) { return seen.body >= body; });
    if (told_alike && last != last_.end() && last->body == body && last->fixed == fixed &&
        std::memcmp(&last->place, &place, sizeof place) == 0 && same(last->shape, model.shape[i])) {
      still_[i] = 1;
      any_still_ |= !fixed;
      seen_.push_back(std::move(*last));
    } else {
      seen_.push_back({body, fixed, model.shape[i], place});
    }
  }
}

std::optional<std::span<const ContactPoint>> KeptPoints::find(const IndexPair& pair,
                                                              std::size_t& next) const {
  if (pairs_.empty() || !still(pair)) return {};
  const auto from = pairs_.begin() + static_cast<std::ptrdiff_t>(next);
  // The next one, as a rule.
  const auto found =
      from != pairs_.end() && *from == pair ? from : std::lower_bound(from, pairs_.end(), pair);
  next = static_cast<std::size_t>(found - pairs_.begin());
  if (found == pairs_.end() || *found != pair) return {};
  const std::size_t k = next++;
  return std::span(points_).subspan(first_[k], count_[k]);
}

void KeptPoints::end(const std::vector<IndexPair>& pairs, const std::vector<PairCount>& counts,
                     const std::vector<ContactPoint>& points) {
  pairs_.clear();
  if (!any_still_) return;
  first_.clear();
  count_.clear();
  std::size_t first = 0;
  for (std::size_t k = 0; k < pairs.size(); first += counts[k++].points) {
    if (!counts[k].own || !still(pairs[k])) continue;
    pairs_.push_back(pairs[k]);
    first_.push_back(first);
    count_.push_back(counts[k].points);
  }
  points_ = points;
}

}  // namespace pabd
