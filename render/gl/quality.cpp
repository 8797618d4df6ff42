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
  if (votes_ != kVotes && votes_ != -kVotes) return;
  at_ += votes_ > 0 ? 1 : -1;
  votes_ = 0;
}

}  // namespace pabd
