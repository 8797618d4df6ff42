// SPDX-License-Identifier: MIT
// See timeline.h.
#include "app/session/timeline.h"

#include <algorithm>
#include <cmath>

#include "app/session/step_at_time.h"

namespace pabd {
namespace {

constexpr std::size_t kAllKept = 120;  // of the newest moments, for quick steps back
constexpr std::int64_t kLongestStride = 64;
constexpr double kRoom = 0.8;         // part of the budget that is filled after dropping
constexpr double kNewestPart = 0.25;  // of the budget, for the newest of a device, whose states are large

}  // namespace

std::size_t state_bytes(const State& state) {
  return sizeof(State) + state.c.size() * (3 * sizeof(Vec3) + sizeof(Mat3)) +
         state.contacts.size() * sizeof(ContactMemory) + state.joint_force.size() * sizeof(Vec3) +
         state.change.size() * sizeof(StepChange);
}

double largest_distance(const State& a, const State& b) {
  double squared = 0;
  for (std::size_t i = 0; i < std::min(a.c.size(), b.c.size()); ++i) {
    squared = std::max(squared, (a.c[i] - b.c[i]).squaredNorm());
  }
  return std::sqrt(squared);
}

void Timeline::add(Moment moment) {
  if (moment.state) {
    bytes_ += state_bytes(*moment.state);
  } else if (moment.device) {
    ++gone_;
  }
  reports_.push_back(moment.report);
  if (moment.edit) edits_.push_back(moment.edit);
  if (moment.pulls) ++pulled_;
  moments_.push_back(std::move(moment));
  if (bytes_ > budget_) shrink();
}

std::size_t Timeline::newest_of_device(std::size_t bytes) const {
  const auto room = static_cast<std::size_t>(kNewestPart * static_cast<double>(budget_));
  return std::min(kAllKept, room / std::max<std::size_t>(bytes, 1));
}

bool Timeline::wants(std::int64_t step, std::size_t bytes, bool newest) const {
  return (newest && newest_of_device(bytes) > 0) || step % stride_ == 0;
}

void Timeline::put_state(std::shared_ptr<const State> state) {
  Moment& last = moments_.back();
  bytes_ += state_bytes(*state);
  if (last.device) --gone_;
  last.state = std::move(state);
  if (bytes_ > budget_) shrink();
}

std::size_t Timeline::kept(std::size_t i) const {
  std::size_t from = i;
  while (from > 0 && !moments_[from].state) --from;
  while (from < i && !moments_[from + 1].device) ++from;
  return from;
}

std::size_t Timeline::next_kept(std::size_t i) const {
  for (std::size_t k = i + 1; k < moments_.size(); ++k) {
    if (kept(k) == k) return k;
  }
  return i;
}

std::size_t Timeline::made_alike(std::size_t i, std::size_t most) const {
  const auto alike = [&](const Moment& m) {
    return !m.start && (m.params == moments_[i].params || *m.params == *moments_[i].params);
  };
  std::size_t count = 0;
  while (count < most && count <= i && alike(moments_[i - count])) ++count;
  return count;
}

std::shared_ptr<const State> Timeline::state(std::size_t i, int threads) const {
  std::size_t kept = i;
  while (!moments_[kept].state) --kept;
  if (kept == i) return moments_[i].state;
  auto state = std::make_shared<State>(*moments_[kept].state);
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  options.threads = threads;
  for (std::size_t k = kept + 1; k <= i; ++k) {
    options.pulls = moments_[k].pulls ? *moments_[k].pulls : std::vector<Pull>{};
    step(*moments_[k].model, *moments_[k].params, options, *state, workspace, report);
  }
  return state;
}

Timeline Timeline::branch(std::size_t i) {
  Timeline rest(budget_);
  rest.reports_ = reports_;
  rest.reports_.drop_front(i + 1);
  reports_.truncate(i + 1);
  for (std::size_t k = i + 1; k < moments_.size(); ++k) {
    if (moments_[k].state) rest.bytes_ += state_bytes(*moments_[k].state);
    if (moments_[k].edit) rest.edits_.push_back(moments_[k].edit);
    if (moments_[k].pulls) ++rest.pulled_;
    if (moments_[k].device && !moments_[k].state) ++rest.gone_;
    rest.moments_.push_back(std::move(moments_[k]));
  }
  moments_.resize(i + 1);
  edits_.resize(edits_.size() - rest.edits_.size());
  pulled_ -= rest.pulled_;
  gone_ -= rest.gone_;
  bytes_ -= rest.bytes_;
  return rest;
}

std::size_t Timeline::at_time(double time) const {
  const auto after = std::upper_bound(moments_.begin(), moments_.end(), time, [](double t, const Moment& m) {
    return !is_reached(m.report.time, t, m.params->h);
  });
  return after == moments_.begin() ? 0 : static_cast<std::size_t>(after - moments_.begin()) - 1;
}

std::vector<std::shared_ptr<const MadeEdit>> Timeline::edits() const {
  std::vector<std::shared_ptr<const MadeEdit>> out;
  for (const ForgottenEdit& edit : forgotten_edits_) out.push_back(edit.made);
  out.insert(out.end(), edits_.begin(), edits_.end());
  return out;
}

bool Timeline::touched_after(std::size_t i) const {
  const auto touched = [](const Moment& m) { return m.edit || m.pulls; };
  return std::any_of(moments_.begin() + static_cast<std::ptrdiff_t>(i) + 1, moments_.end(), touched);
}

void Timeline::set_forgotten(std::size_t moments, std::vector<ForgottenEdit> edits) {
  forgotten_ = moments;
  forgotten_edits_ = std::move(edits);
}

void Timeline::shrink() {
  const auto enough = static_cast<std::size_t>(kRoom * static_cast<double>(budget_));
  for (std::int64_t stride = 2; stride <= kLongestStride && bytes_ > enough; stride *= 2)
    drop_between(stride);
  const std::size_t least = budget_ == kNoPast ? 1 : 2 * kAllKept;
  while (bytes_ > enough && moments_.size() > least && forget_oldest()) {
  }
  // States that are so large that few of them fit.
  const auto all = static_cast<std::int64_t>(moments_.size());
  for (std::int64_t stride = 2 * kLongestStride; stride <= all && bytes_ > enough; stride *= 2)
    drop_between(stride);
}

// A moment where somebody else takes over stays: no report leads to what follows.
void Timeline::drop_between(std::int64_t stride) {
  const std::size_t newest =
      newest_of_device(moments_.back().state ? state_bytes(*moments_.back().state) : 0);
  if (moments_.size() <= newest) return;
  if (std::any_of(moments_.begin(), moments_.end(), [](const Moment& m) { return m.device; }))
    stride_ = stride;
  for (std::size_t i = 1; i + 1 < moments_.size(); ++i) {
    Moment& m = moments_[i];
    const std::size_t after = moments_.size() - i;
    if (!m.state || m.start || m.report.step % stride == 0) continue;
    if (m.device ? after > newest && moments_[i + 1].device : after > kAllKept && stride <= kLongestStride)
      drop(m);
  }
}

void Timeline::drop(Moment& moment) {
  bytes_ -= state_bytes(*moment.state);
  if (moment.device) ++gone_;
  moment.state.reset();
}

// Up to the next state that is there; false when there is none.
bool Timeline::forget_oldest() {
  const auto stands = [](const Moment& m) { return m.state != nullptr; };
  if (std::none_of(moments_.begin() + 1, moments_.end(), stands)) return false;
  do {
    const Moment& m = moments_.front();
    if (m.state) {
      bytes_ -= state_bytes(*m.state);
    } else if (m.device) {
      --gone_;
    }
    if (m.edit) {
      forgotten_edits_.push_back({m.edit, m.edit->adds_joint ? m.state : nullptr});
      edits_.erase(edits_.begin());
    }
    moments_.pop_front();
    reports_.drop_front(1);
    ++forgotten_;
  } while (!moments_.front().state);
  return true;
}

}  // namespace pabd
