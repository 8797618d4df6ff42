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

bool same_edits(const EditChain* a, const EditChain* b) {
  for (; a != b; a = a->before.get(), b = b->before.get())
    if (!a || !b || (a->made != b->made && a->made->text != b->made->text)) return false;
  return true;
}

double largest_distance(const State& a, const State& b) {
  double squared = 0;
  for (std::size_t i = 0; i < std::min(a.c.size(), b.c.size()); ++i) {
    squared = std::max(squared, (a.c[i] - b.c[i]).squaredNorm());
  }
  return std::sqrt(squared);
}

void Timeline::count(const Moment& moment, bool comes) {
  const std::size_t bytes = moment.state ? state_bytes(*moment.state) : 0;
  const std::size_t gone = moment.device && !moment.state ? 1 : 0;
  bytes_ = comes ? bytes_ + bytes : bytes_ - bytes;
  gone_ = comes ? gone_ + gone : gone_ - gone;
}

void Timeline::add(Moment moment) {
  moment.edits = empty() ? edits_before_ : back().edits;
  if (moment.edit) {
    moment.edits = std::make_shared<const EditChain>(
        EditChain{moment.edit, moment.edit->adds_joint ? moment.state : nullptr, moment.edits});
  }
  moment.pulled = (empty() ? 0 : pulled()) + (moment.pulls ? 1 : 0);
  reports_.push_back(moment.report);
  moments_.push_back(std::make_shared<const Moment>(std::move(moment)));
  count(back(), true);
  if (bytes_ > budget_) shrink();
}

// In place of the moment one with that state: others may share it.
void Timeline::give_state(std::shared_ptr<const Moment>& moment, std::shared_ptr<const State> state) {
  count(*moment, false);
  auto other = std::make_shared<Moment>(*moment);
  other->state = std::move(state);
  moment = std::move(other);
  count(*moment, true);
}

std::size_t Timeline::newest_of_device(std::size_t bytes) const {
  const auto room = static_cast<std::size_t>(kNewestPart * static_cast<double>(budget_));
  return std::min(kAllKept, room / std::max<std::size_t>(bytes, 1));
}

bool Timeline::wants(std::int64_t step, std::size_t bytes, bool newest) const {
  return (newest && newest_of_device(bytes) > 0) || step % stride_ == 0;
}

void Timeline::put_state(std::shared_ptr<const State> state) {
  give_state(moments_.back(), std::move(state));
  if (bytes_ > budget_) shrink();
}

std::size_t Timeline::kept(std::size_t i) const {
  std::size_t from = i;
  while (from > 0 && !moments_[from]->state) --from;
  while (from < i && !moments_[from + 1]->device) ++from;
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
    return !m.start && (m.params == moments_[i]->params || *m.params == *moments_[i]->params);
  };
  std::size_t count = 0;
  while (count < most && count <= i && alike(*moments_[i - count])) ++count;
  return count;
}

std::shared_ptr<const State> Timeline::state(std::size_t i, int threads) const {
  std::size_t kept = i;
  while (!moments_[kept]->state) --kept;
  if (kept == i) return moments_[i]->state;
  auto state = std::make_shared<State>(*moments_[kept]->state);
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  options.threads = threads;
  for (std::size_t k = kept + 1; k <= i; ++k) {
    options.pulls = moments_[k]->pulls ? *moments_[k]->pulls : std::vector<Pull>{};
    step(*moments_[k]->model, *moments_[k]->params, options, *state, workspace, report);
  }
  return state;
}

Timeline Timeline::branch(std::size_t i) {
  Timeline rest(budget_);
  rest.reports_ = reports_;
  rest.reports_.drop_front(i + 1);
  reports_.truncate(i + 1);
  rest.moments_.assign(moments_.begin() + static_cast<std::ptrdiff_t>(i) + 1, moments_.end());
  moments_.resize(i + 1);
  for (const auto& moment : rest.moments_) {
    rest.count(*moment, true);
    count(*moment, false);
  }
  return rest;
}

std::size_t Timeline::at_time(double time) const {
  const auto after = std::upper_bound(moments_.begin(), moments_.end(), time, [](double t, const auto& m) {
    return !is_reached(m->report.time, t, m->params->h);
  });
  return after == moments_.begin() ? 0 : static_cast<std::size_t>(after - moments_.begin()) - 1;
}

std::shared_ptr<const EditChain> Timeline::forgotten_edits() const {
  const Moment& first = *moments_.front();
  return first.edit ? first.edits->before : first.edits;
}

bool Timeline::touched_after(std::size_t i) const {
  return back().edits != moments_[i]->edits || back().pulled != moments_[i]->pulled;
}

void Timeline::set_forgotten(std::size_t moments, std::shared_ptr<const EditChain> edits) {
  forgotten_ = moments;
  edits_before_ = std::move(edits);
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
  const std::size_t newest = newest_of_device(back().state ? state_bytes(*back().state) : 0);
  if (moments_.size() <= newest) return;
  if (std::any_of(moments_.begin(), moments_.end(), [](const auto& m) { return m->device; }))
    stride_ = stride;
  for (std::size_t i = 1; i + 1 < moments_.size(); ++i) {
    const Moment& m = *moments_[i];
    const std::size_t after = moments_.size() - i;
    if (!m.state || m.start || m.report.step % stride == 0) continue;
    if (m.device ? after > newest && moments_[i + 1]->device : after > kAllKept && stride <= kLongestStride)
      give_state(moments_[i], nullptr);
  }
}

// Up to the next state that is there; false when there is none.
bool Timeline::forget_oldest() {
  const auto stands = [](const auto& m) { return m->state != nullptr; };
  if (std::none_of(moments_.begin() + 1, moments_.end(), stands)) return false;
  do {
    count(*moments_.front(), false);
    moments_.pop_front();
    reports_.drop_front(1);
    ++forgotten_;
  } while (!moments_.front()->state);
  return true;
}

}  // namespace pabd
