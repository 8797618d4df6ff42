// SPDX-License-Identifier: MIT
// The past of a run: every step with what it was made with, and its state, within a memory budget.
//
// When the budget is used up, every second state of the older part is dropped, then every fourth and so on;
// such a state is computed again from the one before, which gives the same bits because a step is a function
// of state, parameters and model. Only then are the oldest moments forgotten.
//
// What a device made (step_engine.h) is not computed again: the processor's bits are others. Of such steps those whose
// states are dropped are known by their reports alone, and one can go back only to what is kept.
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
};

// The budget of a run that is never wound back: it keeps the last moment alone.
inline constexpr std::size_t kNoPast = 0;

class Timeline {
 public:
  explicit Timeline(std::size_t budget_bytes) : budget_(budget_bytes) {}

  // The first moment must be a start, or have its state; the model may only change at a start. A state may be
  // absent where the moments before lead to it, or a device does: wants().
  void add(Moment moment);

  // Whether the budget has room for the state of a device's step of that number; `bytes`: about (state_bytes). `newest`: also
  // as one of the newest, which later ones replace.
  bool wants(std::int64_t step, std::size_t bytes, bool newest = true) const;
  // The last moment gets its state. Precondition: it has none.
  void put_state(std::shared_ptr<const State> state);

  // The last moment that is not after i and can be gone to, and the first after i; the precondition of state().
  std::size_t kept(std::size_t i) const;
  std::size_t next_kept(std::size_t i) const;  // i itself where there is none
  // How many steps, at most `most`, led to moment i one after the other with the parameters of the last of them.
  std::size_t made_alike(std::size_t i, std::size_t most) const;
  std::size_t gone() const { return gone_; }  // moments that cannot be gone to any more

  bool empty() const { return moments_.empty(); }
  std::size_t size() const { return moments_.size(); }
  const Moment& operator[](std::size_t i) const { return moments_[i]; }
  const Moment& back() const { return moments_.back(); }

  // Of all moments; costs the same however many there are.
  Reports reports() const { return reports_.view(); }
  // Edits that led to the present model, in order, also those of moments that are forgotten.
  std::vector<std::shared_ptr<const MadeEdit>> edits() const;
  // Moments that came about with a hand on a body, also those that are forgotten.
  std::size_t pulled() const { return pulled_; }
  // Whether an edit or a hand comes after moment i.
  bool touched_after(std::size_t i) const;

  // The state of moment i, computed again if it was dropped. `threads` as for a step. Precondition: kept(i) is i, and
  // the first moment has its state, which is so unless this was cut off another timeline.
  std::shared_ptr<const State> state(std::size_t i, int threads = 1) const;

  // Cuts off everything behind moment i and returns it, without moment i.
  Timeline branch(std::size_t i);

  // The last moment that is not after `time` (s; step_at_time.h), or the first one.
  std::size_t at_time(double time) const;

  std::size_t bytes() const { return bytes_; }  // of the states, about
  std::size_t budget() const { return budget_; }
  // Edits that led to the model of the first moment, of moments that are forgotten.
  struct ForgottenEdit {
    std::shared_ptr<const MadeEdit> made;
    std::shared_ptr<const State>
        state;  // where a joint was added: its frames are those of these poses; else null
  };
  const std::vector<ForgottenEdit>& forgotten_edits() const { return forgotten_edits_; }
  void set_forgotten(std::size_t moments, std::vector<ForgottenEdit> edits);  // of a recording

  std::size_t forgotten() const { return forgotten_; }  // moments at the beginning

 private:
  void shrink();
  void drop_between(std::int64_t stride);
  void drop(Moment& moment);
  bool forget_oldest();
  std::size_t newest_of_device(std::size_t bytes) const;

  std::size_t budget_;
  std::size_t bytes_ = 0, forgotten_ = 0;
  std::deque<Moment> moments_;
  ReportList reports_;                                  // those of the moments
  std::vector<std::shared_ptr<const MadeEdit>> edits_;  // of the moments that are there
  std::size_t pulled_ = 0;
  std::size_t gone_ = 0;     // moments of a device without a state
  std::int64_t stride_ = 1;  // of the steps of a device whose states are kept
  std::vector<ForgottenEdit> forgotten_edits_;
};

// About how much memory a state takes.
std::size_t state_bytes(const State& state);

// Largest distance between the places of a body in two states of one model; m.
double largest_distance(const State& a, const State& b);

}  // namespace pabd
