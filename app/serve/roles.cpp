// SPDX-License-Identifier: MIT
// See roles.h.
#include "app/serve/roles.h"

#include <algorithm>

namespace pabd {

Roles::Visitor* Roles::find(VisitorId id) {
  const auto found =
      std::find_if(visitors_.begin(), visitors_.end(), [&](const Visitor& v) { return v.id == id; });
  return found == visitors_.end() ? nullptr : &*found;
}

std::optional<Roles::Arrival> Roles::arrive(const std::string& key, bool may_control, double now) {
  tick(now);
  const auto known = std::find_if(visitors_.begin(), visitors_.end(), [&](const Visitor& v) {
    return v.key == key && v.may_control == may_control;
  });
  const bool here = known != visitors_.end() && known->present;
  if (!here && present() >= kMost) return std::nullopt;  // for returning visitors as well
  Arrival out;
  out.id = next_;
  if (known != visitors_.end()) {
    out.came_back = true;
    if (here) out.replaced = known->id;
    if (holder_ == known->id) holder_ = out.id;
    known->id = out.id;
    known->present = true;
    known->closed = false;
  } else {
    if (visitors_.size() - present() >= kMostKept) {
      const auto oldest = std::find_if(visitors_.begin(), visitors_.end(),
                                       [&](const Visitor& v) { return !v.present && holder_ != v.id; });
      if (oldest != visitors_.end()) visitors_.erase(oldest);
    }
    visitors_.push_back({out.id, key, may_control, true, false, false, 0});
  }
  ++next_;
  // After closing a tab and opening another one there is nobody to wait for.
  const Visitor* holder = holder_ ? find(*holder_) : nullptr;
  if (may_control && holder && !holder->present && holder->closed && present_controllers() == 1)
    holder_ = out.id;
  settle();
  return out;
}

void Roles::leave(VisitorId id, double now, bool closed) {
  if (Visitor* visitor = find(id)) {
    visitor->present = visitor->asks = false;
    visitor->left = now;
    visitor->closed = closed;
  }
}

void Roles::ask(VisitorId id) {
  Visitor* visitor = find(id);
  if (!visitor || !visitor->may_control || holder_ == id) return;
  visitor->asks = true;
}

bool Roles::give(VisitorId id) {
  if (holder_ != id) return false;
  const auto fits = [&](const Visitor& v) { return v.present && v.may_control && v.id != id; };
  auto to =
      std::find_if(visitors_.begin(), visitors_.end(), [&](const Visitor& v) { return fits(v) && v.asks; });
  if (to == visitors_.end()) to = std::find_if(visitors_.begin(), visitors_.end(), fits);
  if (to == visitors_.end()) return false;
  holder_ = to->id;
  to->asks = false;
  return true;
}

void Roles::tick(double now) {
  if (holder_) {
    const Visitor* holder = find(*holder_);
    if (!holder || (!holder->present && present_controllers() > 0 &&
                    now - holder->left >= (holder->closed ? kReload : kGone)))
      holder_.reset();
  }
  std::erase_if(visitors_, [&](const Visitor& v) { return !v.present && now - v.left >= kKept; });
  if (holder_ && !find(*holder_)) holder_.reset();
  settle();
}

void Roles::settle() {
  if (holder_) return;
  for (Visitor& visitor : visitors_) {
    if (!visitor.present || !visitor.may_control) continue;
    holder_ = visitor.id;
    visitor.asks = false;
    return;
  }
}

std::optional<VisitorId> Roles::controller() const {
  return count([&](const Visitor& v) { return v.present && holder_ == v.id; }) > 0 ? holder_ : std::nullopt;
}

bool Roles::somebody_asks() const {
  return count([](const Visitor& v) { return v.present && v.asks; }) > 0;
}

std::size_t Roles::present_controllers() const {
  return count([](const Visitor& v) { return v.present && v.may_control; });
}

std::size_t Roles::present() const {
  return count([](const Visitor& v) { return v.present; });
}

}  // namespace pabd
