// SPDX-License-Identifier: MIT
// Parameters, and B with another law of its joints: see workbench.h. The law belongs to the bodies and joints of a scene,
// so B goes on with the scene read again.
#include <fmt/format.h>

#include "app/session/joint_settings.h"
#include "app/workbench/command_json.h"
#include "app/workbench/workbench.h"
#include "sim/base/error.h"
#include "sim/import/import.h"
#include "sim/scene/tuning.h"

namespace pabd {

void Workbench::carry_out(const command::Set& c) {
  Params after = run_of(c.side).params();
  const std::string setting = c.key + "=" + command_json::text_of(c.value);
  if (is_joint_setting(c.key)) return change(c.side, c.key, after, std::vector{setting});
  const ParameterRow* row = find_parameter(c.key);
  const auto* typed = std::get_if<ParameterValue>(&c.value);
  if (row && typed) {
    set_value(*row, after, *typed);  // Run::set_params checks it
  } else {
    after = tuned(after, {setting});
  }
  change(c.side, c.key, after, c.more);
}

void Workbench::carry_out(const command::SetAll& c) {
  if (c.values.empty()) return;
  const std::string what =
      c.values.size() == 1 ? c.values[0].substr(0, c.values[0].find('=')) : "several parameters";
  std::vector<std::string> values = c.values;
  const std::vector<std::string> joints = take_joint_settings(values);
  change(c.side, what, tuned(run_of(c.side).params(), values), joints);
}

void Workbench::carry_out(const command::ResetParams& c) {
  const Params& now = run_of(c.side).params();
  if (c.key.empty()) {
    if (c.side == Side::b) return change_b("all parameters", shown_.scene->params, shown_.scene);
    change(c.side, "all parameters", shown_.scene->params);
    return;
  }
  if (is_joint_setting(c.key)) {
    if (c.side == Side::a) refuse_joints_of_a();
    return change_b(c.key, now, shown_.scene);
  }
  if (const ParameterRow* row = find_parameter(c.key)) {
    Params after = now;
    set_value(*row, after, value_of(*row, shown_.scene->params));
    return change(c.side, c.key, after);
  }
  change(c.side, c.key, tuned(now, {c.key + "=" + tuned_value(shown_.scene->params, c.key)}));
}

void Workbench::change(Side side, const std::string& what, const Params& after, bool more) {
  Run& run = run_of(side);
  const Params before = run.params();
  if (before == after) return;
  check_device(run, after);
  Change made{Change::Kind::parameters, side, what, before, after};
  if (!run.at_end()) {
    made.given_up = heads(side == Side::a, side == Side::b);
    made.at = run.cursor();
  }
  run.set_params(after);
  measure_distance();
  shown_.diverged = false;
  redo_.clear();
  const bool goes_on = more && !made.given_up && !undo_.empty() && undo_.back().what == what &&
                       undo_.back().side == side && undo_.back().kind == Change::Kind::parameters;
  if (goes_on) {
    undo_.back().after = after;
  } else {
    keep(std::move(made));
  }
}

std::shared_ptr<const Scene> Workbench::read_with_joints(const Source& source, const Scene& scene,
                                                         const BondLaw& now,
                                                         const std::vector<std::string>& settings) const {
  if (scene.model.joints.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: the scene has no joints to give a law to", kJointSettings));
  }
  std::vector<std::string> sets = source.sets;
  const std::vector<std::string> joints = joint_settings_after(scene.joint_law, now, settings);
  sets.insert(sets.end(), joints.begin(), joints.end());
  return std::make_shared<const Scene>(parse_any_scene(
      source.text, source.path, std::filesystem::path(source.path).parent_path(), sets, options_.may_read));
}

void Workbench::refuse_joints_of_a() {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: the law of A's joints is the scene's; B of a comparison can have another one, "
                          "and a scene that is loaded with --set",
                          kJointSettings));
}

void Workbench::change(Side side, const std::string& what, const Params& after,
                       const std::vector<std::string>& joints) {
  if (joints.empty()) return change(side, what, after);
  if (side == Side::a) refuse_joints_of_a();
  change_b(what, after, read_with_joints(source_, *shown_.scene, run_of(side).scene().joint_law, joints));
}

void Workbench::change_b(const std::string& what, const Params& after, std::shared_ptr<const Scene> scene) {
  const Run& b = run_of(Side::b);
  if (same_law(b.scene().joint_law, scene->joint_law)) return change(Side::b, what, after);
  Run next = b.fork();
  next.continue_as(std::move(scene));
  next.set_params(after);
  std::shared_ptr<GivenUp> given_up = heads(false, true);
  b_.emplace(std::move(next));
  measure_distance();
  shown_.diverged = false;
  keep_exchange(what, std::move(given_up));
}

}  // namespace pabd
