// SPDX-License-Identifier: MIT
// Undo and redo: see workbench.h.
//
// A change at the end of the timeline is undone in place. A change that discards something (the future of a change in the
// past, a comparison that ends) keeps it, and undo exchanges the two. If the run has advanced since a parameter was
// changed in the past, the parameter is undone in place, and the discarded future becomes a step of undo of its own if it
// has edits or hands; otherwise it can be computed again.
#include <fmt/format.h>

#include "app/workbench/workbench.h"

namespace pabd {
namespace {

constexpr std::size_t kMostChanges = 1000;

}  // namespace

void Workbench::keep(Change change) {
  undo_.push_back(std::move(change));
  if (undo_.size() > kMostChanges) undo_.erase(undo_.begin());
  thin(undo_);
}

void Workbench::keep_exchange(const std::string& what, std::shared_ptr<GivenUp> given_up) {
  Change change{Change::Kind::exchange, Side::a, what, {}, {}};
  change.given_up = std::move(given_up);
  keep(std::move(change));
  redo_.clear();
}

// Discarded futures may take as much memory as the timeline; the newest of them always stays.
void Workbench::thin(std::vector<Change>& changes) const {
  const auto bytes = [](const std::optional<Head>& head) { return head ? head->timeline.bytes() : 0; };
  std::size_t used = 0;
  for (std::size_t i = changes.size(); i-- > 0;) {
    const auto& given_up = changes[i].given_up;
    if (!given_up || !(given_up->a || given_up->b)) continue;
    const bool first = used == 0;
    used += bytes(given_up->a) + bytes(given_up->b);
    if (first || used <= options_.memory) continue;
    changes[i].given_up.reset();
    if (changes[i].kind == Change::Kind::exchange)
      changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::shared_ptr<Workbench::GivenUp> Workbench::heads(bool with_a, bool with_b) const {
  auto out = std::make_shared<GivenUp>();
  out->with_a = with_a;
  out->with_b = with_b;
  if (with_a) out->a = a_->head();
  if (with_b && b_) out->b = b_->head();
  const auto touched = [](const auto& head) { return head && head->timeline.touched_after(head->cursor); };
  out->touched = touched(out->a) || touched(out->b);
  out->distances = distances_;
  return out;
}

// Each run goes to the head that was kept, and its own is kept instead. Without a head there was no comparison.
void Workbench::exchange(GivenUp& other) {
  if (other.held) std::swap(shown_.held, *other.held);
  if (!other.with_a && !other.with_b) return;
  std::swap(distances_, other.distances);
  if (other.with_a) {
    ++shown_.jumps;
    Head now = a_->head();
    a_->go_to(std::exchange(*other.a, std::move(now)));
  }
  if (other.with_b) {
    std::optional<Head> now;
    if (b_) now = b_->head();
    if (!other.b) {
      b_.reset();
    } else {
      if (!b_) b_.emplace(a_->fork());
      b_->go_to(*std::move(other.b));
    }
    other.b = std::move(now);
  }
  // The other run follows to the same time.
  if (b_ && other.with_a != other.with_b)
    seek_to(other.with_a ? a_->cursor() : a_->timeline().at_time(b_->state().time));
  shown_.diverged = false;
}

void Workbench::carry_out(const command::Undo&) { restore(undo_, redo_, true); }
void Workbench::carry_out(const command::Redo&) { restore(redo_, undo_, false); }

void Workbench::restore(std::vector<Change>& from, std::vector<Change>& to, bool before) {
  using Kind = Change::Kind;
  // Changes of a comparison that no longer exists.
  while (!from.empty() && from.back().kind == Kind::parameters && from.back().side == Side::b && !b_)
    from.pop_back();
  if (from.empty()) return;
  Change change = from.back();
  std::shared_ptr<GivenUp> left;
  bool done = true;
  if (change.given_up && restore_heads(change, before)) {
  } else if (change.kind == Kind::parameters) {
    left = restore_params(change, before);
  } else if (before) {
    auto now = heads(true, b_.has_value());
    done = undo_edit(change);
    change.given_up = std::move(now);
    change.exchanged = true;
  } else {
    change = make_edit(*change.edit, change.what);
  }
  from.pop_back();
  if (left && left->touched) {
    Change own{Kind::exchange, Side::a, "the run before " + change.what, {}, {}};
    own.given_up = std::move(left);
    from.push_back(std::move(own));
  }
  if (!done) return;
  to.push_back(std::move(change));
  thin(to);
}

// Exchanges the runs with what the change discarded. False when it has to be undone in place.
bool Workbench::restore_heads(Change& change, bool before) {
  const Run& run = run_of(change.side);
  const bool stayed = run.at_end() && run.cursor() == change.at;
  if (change.kind == Change::Kind::parameters && !change.exchanged && !stayed) return false;
  exchange(*change.given_up);
  change.exchanged = !change.exchanged;
  change.at = run_of(change.side).cursor();
  const bool runs = change.given_up->with_a || change.given_up->with_b;
  tell(Severity::note, fmt::format("{}: {}{}", before ? "undone" : "done again", change.what,
                                   runs ? fmt::format("; back at t = {:.4g} s", a_->state().time) : ""));
  return true;
}

// Undoes in place. The result is what the change had discarded, which is no longer part of it.
std::shared_ptr<Workbench::GivenUp> Workbench::restore_params(Change& change, bool before) {
  Run& run = run_of(change.side);
  const Params& wanted = before ? change.before : change.after;
  std::shared_ptr<GivenUp> now;
  const bool leaves = !run.at_end() && run.params() != wanted;
  if (leaves) now = heads(change.side == Side::a, change.side == Side::b);
  run.set_params(wanted);
  measure_distance();
  change.at = run.cursor();
  change.exchanged = leaves;
  return std::exchange(change.given_up, std::move(now));
}

}  // namespace pabd
