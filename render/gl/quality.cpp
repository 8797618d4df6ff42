// SPDX-License-Identifier: MIT
// The size of live pictures.
//
//   s          scale in use, s' the next larger one
//   t          ms of a picture, t ≈ a + b s²: something fixed, and something a pixel
//
// t (s'/s)² is never less than the picture at s' would take. Only where that leaves room is s' tried, so that
// it is not given up again at once.
#include "render/gl/quality.h"

namespace pabd {
namespace {

constexpr double kRoom = 0.8;  // of the budget, for the next larger scale
constexpr int kVotes = 4;      // one slow picture may be an accident
constexpr double kFar = 3;     // times the budget: three of them are none

}  // namespace

void LiveScale::took(double ms) {
  const bool smallest = at_ + 1 == static_cast<int>(kScales.size());
  const double growth = at_ > 0 ? kScales[static_cast<std::size_t>(at_) - 1] / scale() : 1;
  if (ms > budget_ && !smallest) {
    votes_ = votes_ > 0 ? votes_ + 1 : 1;
  } else if (at_ > 0 && ms * growth * growth < kRoom * budget_) {
    votes_ = votes_ < 0 ? votes_ - 1 : -1;
  } else {
    votes_ = 0;
  }
  const int votes = ms > kFar * budget_ ? kVotes - 1 : kVotes;
  if (votes_ < votes && votes_ > -votes) return;
  if (votes_ < 0) {
    --at_;
  } else {  // at once as far as the picture needs at least
    const double s = scale();
    do {
      ++at_;
    } while (at_ + 1 < static_cast<int>(kScales.size()) && ms * (scale() / s) * (scale() / s) > budget_);
  }
  votes_ = 0;
}

}  // namespace pabd
