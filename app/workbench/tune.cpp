// SPDX-License-Identifier: MIT
// Parameters: see workbench.h.
#include "app/workbench/workbench.h"

#include "app/session/joint_settings.h"
#include "app/workbench/command_json.h"
#include "sim/base/error.h"
#include "sim/scene/tuning.h"

namespace pabd {

void Workbench::carry_out(const command::Set& c) {
  Params after = run_of(c.side).params();
  if (is_joint_setting(c.key)) {
    if (c.side == Side::a) refuse_joints_of_a();
    return change_b(c.key, after, {c.key + "=" + command_json::text_of(c.value)});
  }
  const ParameterRow* row = find_parameter(c.key);
  const auto* typed = std::get_if<ParameterValue>(&c.value);
  if (row && typed) {
    set_value(*row, after, *typed);  // Run::set_params checks it
  } else {
    after = tuned(after, {c.key + "=" + command_json::text_of(c.value)});
  }
  change(c.side, c.key, after, c.more);
}

void Workbench::carry_out(const command::SetAll& c) {
  if (c.values.empty()) return;
  const std::string what =
      c.values.size() == 1 ? c.values[0].substr(0, c.values[0].find('=')) : "several parameters";
  std::vector<std::string> values = c.values;
  const std::vector<std::string> joints = take_joint_settings(values);
  if (!joints.empty() && c.side == Side::a) refuse_joints_of_a();
  const Params after = tuned(run_of(c.side).params(), values);
  if (c.side == Side::b) return change_b(what, after, joints);
  change(c.side, what, after);
}

void Workbench::carry_out(const command::ResetParams& c) {
  const Params& now = run_of(c.side).params();
  if (c.key.empty()) {
    if (c.side == Side::b) return change_b("all parameters", scene_->params, scene_);
    change(c.side, "all parameters", scene_->params);
    return;
  }
  if (is_joint_setting(c.key)) {
    if (c.side == Side::a) refuse_joints_of_a();
    return change_b(c.key, now, scene_);
  }
  if (const ParameterRow* row = find_parameter(c.key)) {
    Params after = now;
    set_value(*row, after, value_of(*row, scene_->params));
    return change(c.side, c.key, after);
  }
  change(c.side, c.key, tuned(now, {c.key + "=" + tuned_value(scene_->params, c.key)}));
}

void Workbench::change(Side side, const std::string& what, const Params& after, bool more) {
  Run& run = run_of(side);
  const Params before = run.params();
  if (before == after) return;
  check_device(run, after);
  Change made{Change::Kind::parameters, side, what, before, after};
  if (!run.at_end()) {
    made.given_up = copy_runs(side == Side::a, side == Side::b);
    made.at = run.cursor();
  }
  run.set_params(after);
  measure_distance();
  diverged_ = false;
  redo_.clear();
  const bool goes_on = more && !made.given_up && !undo_.empty() && undo_.back().what == what &&
                       undo_.back().side == side && undo_.back().kind == Change::Kind::parameters;
  if (goes_on) {
    undo_.back().after = after;
  } else {
    keep(std::move(made));
  }
}

}  // namespace pabd
