// Parameters: see workbench.h.
#include "app/workbench/workbench.h"

#include "sim/error.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

constexpr std::size_t kMostChanges = 1000;

}  // namespace

void Workbench::carry_out(const command::Set& c) {
  change(c.side, c.key, tuned(run_of(c.side).params(), {c.key + "=" + c.value}), c.more);
}

void Workbench::carry_out(const command::SetAll& c) {
  if (c.values.empty()) return;
  const std::string what =
      c.values.size() == 1 ? c.values[0].substr(0, c.values[0].find('=')) : "several parameters";
  change(c.side, what, tuned(run_of(c.side).params(), c.values));
}

void Workbench::carry_out(const command::ResetParams& c) {
  const Params& now = run_of(c.side).params();
  if (c.key.empty()) {
    change(c.side, "all parameters", scene_->params);
    return;
  }
  change(c.side, c.key, tuned(now, {c.key + "=" + tuned_value(scene_->params, c.key)}));
}

void Workbench::change(Side side, const std::string& what, const Params& after, bool more) {
  Run& run = run_of(side);
  const Params before = run.params();
  if (differences(before, after).empty()) return;
  run.set_params(after);
  measure_distance();
  diverged_ = false;
  redo_.clear();
  if (more && !undo_.empty() && undo_.back().what == what && undo_.back().side == side) {
    undo_.back().after = after;
    return;
  }
  keep({side, what, before, after});
}

void Workbench::keep(Change change) {
  undo_.push_back(std::move(change));
  if (undo_.size() > kMostChanges) undo_.erase(undo_.begin());
}

void Workbench::carry_out(const command::Undo&) { restore(undo_, redo_, true); }
void Workbench::carry_out(const command::Redo&) { restore(redo_, undo_, false); }

void Workbench::restore(std::vector<Change>& from, std::vector<Change>& to, bool before) {
  if (from.empty()) return;
  Change change = from.back();
  if (change.run_a) {
    undo_restart(change);
  } else if (!change.edit) {
    run_of(change.side).set_params(before ? change.before : change.after);
  } else if (before) {
    undo_edit(change);
  } else {
    change = make_edit(*change.edit, change.what);
  }
  from.pop_back();
  to.push_back(std::move(change));
}

std::string Workbench::tuning() const {
  return params_json(a_->params()) + (b_ ? params_json(b_->params()) : "");
}

}  // namespace pabd
