// SPDX-License-Identifier: MIT
// Contact points of pairs that rest are kept from one call of `detect` to the next.
//
// The points of a pair follow from the shapes of its two bodies, from where they are, and from how they come there. Where all
// that has the same bits as in the last call, so have the points.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/body/model.h"
#include "sim/collision/broad_phase.h"
#include "sim/collision/passage.h"

namespace pabd {

// What a pair has: how many points follow in the list of all, and whether they follow from its two bodies alone (of pairs that
// were not looked at they do not).
struct PairCount {
  std::uint32_t points = 0;
  bool own = false;
};

class KeptPoints {
 public:
  // A call begins; `detect` has the units. A call with an empty passage keeps nothing.
  void begin(const Model& model, const std::vector<Vec3>& c, const std::vector<Mat3>& R,
             const Passage& passage, const std::vector<double>& reach);
  // Is body i, and what `detect` was told of it, as in the last call, to the last bit?
  bool still(Index i) const { return still_[static_cast<std::size_t>(i)] != 0; }
  bool still(const IndexPair& pair) const { return still(pair.first) && still(pair.second); }
  bool any_still() const { return any_still_; }

  // Points of a pair in the last call, where both are still and where they were kept. `next` is where the search begins, at
  // first 0, for pairs in rising order.
  std::optional<std::span<const ContactPoint>> find(const IndexPair& pair, std::size_t& next) const;

  // The call ends with `points`, those of its sorted pairs one after another.
  void end(const std::vector<IndexPair>& pairs, const std::vector<PairCount>& counts,
           const std::vector<ContactPoint>& points);

 private:
  // What `detect` is told of a body: doubles without gaps, so that bytes can be compared.
  struct Place {
    Vec3 c, from_c, way, turn;
    Mat3 R, from_R;
    double spin, reach;
  };
  static_assert(sizeof(Place) == 32 * sizeof(double));
  struct Seen {
    Index body;
    bool fixed;
    Shape shape;
    Place place;
  };

  std::vector<Seen> seen_, last_;  // bodies that hardly move, by number
  std::vector<std::uint8_t> still_;
  bool any_still_ = false;
  double touching_ = 0;
  bool from_start_ = false;
  std::vector<IndexPair> pairs_;    // of the last call, sorted
  std::vector<std::size_t> first_;  // of their points
  std::vector<std::uint32_t> count_;
  std::vector<ContactPoint> points_;
};

}  // namespace pabd
