// SPDX-License-Identifier: MIT
// The past of a run: every step with what it was made with, and its state, within a memory budget. A moment never
// changes: copies of a timeline, and branches that part from it, share the moments that they have in common.
//
// When the budget is used up, every second state of the older part is dropped, then every fourth and so on; such a
// state is computed again from the one before, to the same bits. Only then are the oldest moments forgotten.
//
// Steps that a device made (step_engine.h) are not computed again, because the processor's bits differ. Of those whose
// states were dropped only the reports are known, and one can go back only to states that were kept.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/reports.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/time_step.h"

namespace pabd {

// An edit as it was carried out: its JSON (model_edit.h), so that carrying it out again gives the same bits.
struct MadeEdit {
  std::string text;
  bool adds_joint = false;
};

using Pulls = std::shared_ptr<const std::vector<Pull>>;  // null: none

// The edits that led to a model, the newest first: each with those before it.
struct EditChain {
  std::shared_ptr<const MadeEdit> made;  // never null
  // After an edit that added a joint, whose frames are those of these poses; else null.
  std::shared_ptr<const State> state;
  std::shared_ptr<const EditChain> before;
};

struct Moment {
  std::shared_ptr<const Model> model;
  std::shared_ptr<const Params> params;  // that the step which ended here was made with
  std::shared_ptr<const State> state;    // null when it was dropped
  StepSummary report;                    // energies only where no step led here
  bool start = false;  // no step led here: the beginning, or an edit. Such a state is never dropped
  Pulls pulls;         // that the step which ended here was made with
  std::shared_ptr<const MadeEdit> edit;  // that led here; null without one
  std::string hash = {};                 // state_hash, where it came from a recording; else empty
  bool device = false;                   // no processor made the step
  // Of the whole past, which Timeline::add knows: edits up to here, and moments that came about with a hand on a body.
  std::shared_ptr<const EditChain> edits = {};
  std::size_t pulled = 0;
};

// The budget of a run that is never wound back: it keeps the last moment alone.
inline constexpr std::size_t kNoPast = 0;

class Timeline {
 public:
  explicit Timeline(std::size_t budget_bytes) : budget_(budget_bytes) {}

  // The first moment must have its state; the model may only change at a start. A later state may be absent if it can
  // be computed from the moments before, or a device made it (wants()).
  void add(Moment moment);

  // Whether the state of a device's step of that number should be kept, of about `bytes` (state_bytes). `newest`: also as
  // one of the newest, which later ones replace.
  bool wants(std::int64_t step, std::size_t bytes, bool newest = true) const;
  // The last moment gets its state. Precondition: it has none.
  void put_state(std::shared_ptr<const State> state);

  // The last moment not after i whose state is known or can be computed, and the first such one after i.
  std::size_t kept(std::size_t i) const;
  std::size_t next_kept(std::size_t i) const;  // i itself where there is none
  // How many of the steps that led to moment i, at most `most`, were made with the same parameters as the last one.
  std::size_t made_alike(std::size_t i, std::size_t most) const;
  std::size_t gone() const { return gone_; }  // moments that cannot be gone to any more

  bool empty() const { return moments_.empty(); }
  std::size_t size() const { return moments_.size(); }
  const Moment& operator[](std::size_t i) const { return *moments_[i]; }
  const Moment& back() const { return *moments_.back(); }

  // Of all moments; costs the same however many there are.
  Reports reports() const { return reports_.view(); }
  // Edits that led to the model of the last moment, also those of moments that are forgotten; null without one.
  const std::shared_ptr<const EditChain>& edits() const { return back().edits; }
  // Those that led to the model before the first moment, of moments that are forgotten.
  std::shared_ptr<const EditChain> forgotten_edits() const;
  // Moments that came about with a hand on a body, also those that are forgotten.
  std::size_t pulled() const { return back().pulled; }
  // Whether an edit or a hand comes after moment i.
  bool touched_after(std::size_t i) const;

  // The state of moment i, computed again if it was dropped. `threads` as for a step. Precondition: kept(i) is i, and this
  // is no result of branch().
  std::shared_ptr<const State> state(std::size_t i, int threads = 1) const;

  // Cuts off everything behind moment i and returns it, without moment i.
  Timeline branch(std::size_t i);

  // The last moment that is not after `time` (s; step_at_time.h), or the first one.
  std::size_t at_time(double time) const;

  std::size_t bytes() const { return bytes_; }  // of the states, about
  std::size_t budget() const { return budget_; }
  std::size_t forgotten() const { return forgotten_; }  // moments at the beginning
  // Before the first moment is added: what a recording tells of the moments before it.
  void set_forgotten(std::size_t moments, std::shared_ptr<const EditChain> edits);

 private:
  void shrink();
  void drop_between(std::int64_t stride);
  bool forget_oldest();
  std::size_t newest_of_device(std::size_t bytes) const;
  void give_state(std::shared_ptr<const Moment>& moment, std::shared_ptr<const State> state);
  void count(const Moment& moment, bool comes);

  std::size_t budget_;
  std::size_t bytes_ = 0, forgotten_ = 0;
  std::deque<std::shared_ptr<const Moment>> moments_;  // shared with timelines that have the same past
  ReportList reports_;                                 // those of the moments
  std::size_t gone_ = 0;                               // moments of a device without a state
  std::int64_t stride_ = 1;                            // of the steps of a device whose states are kept
  std::shared_ptr<const EditChain> edits_before_;      // the first moment is added
};

// Whether both are the same edits, made in the same order.
bool same_edits(const EditChain* a, const EditChain* b);

// About how much memory a state takes.
std::size_t state_bytes(const State& state);

// Largest distance between the places of a body in two states of one model; m.
double largest_distance(const State& a, const State& b);

}  // namespace pabd
