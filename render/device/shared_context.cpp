// SPDX-License-Identifier: MIT
// See shared_context.h.
#include "render/device/shared_context.h"

#include <utility>

#include "sim/base/error.h"

namespace pabd {

void SharedContext::put_beside(GlContext& drawer) {
  if (!why_no_compute(drawer).empty()) return;
  try {
    auto context = drawer.share();
    const std::scoped_lock lock(place_->mutex);
    place_->context = std::move(context);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
  }
}

void SharedContext::drop() {
  const std::scoped_lock lock(place_->mutex);
  place_->context.reset();
}

SharedContext::Lent SharedContext::take() {
  const std::scoped_lock lock(place_->mutex);
  if (!place_->context) return {};
  GlContext* const lent = place_->context.release();
  const auto bring_back = [place = place_](GlContext* context) {
    const std::scoped_lock back(place->mutex);
    place->context.reset(context);
  };
  return {std::shared_ptr<GlContext>(lent, bring_back), copies_};
}

}  // namespace pabd
