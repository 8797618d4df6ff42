// SPDX-License-Identifier: MIT
// B with another law of its joints: see workbench.h. The law belongs to the bodies and joints of a scene, so B goes on
// with the scene read again.
#include <fmt/format.h>

#include "app/session/joint_settings.h"
#include "app/workbench/workbench.h"
#include "sim/base/error.h"
#include "sim/import/import.h"

namespace pabd {

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

void Workbench::change_b(const std::string& what, const Params& after,
                         const std::vector<std::string>& settings) {
  const Run& b = run_of(Side::b);
  if (settings.empty()) return change(Side::b, what, after);
  change_b(what, after, read_with_joints(source_, *scene_, b.scene().joint_law, settings));
}

void Workbench::change_b(const std::string& what, const Params& after, std::shared_ptr<const Scene> scene) {
  const Run& b = run_of(Side::b);
  if (same_law(b.scene().joint_law, scene->joint_law)) return change(Side::b, what, after);
  Run next = b.fork();
  next.continue_as(std::move(scene));
  next.set_params(after);
  std::shared_ptr<GivenUp> given_up = copy_runs(false, true);
  b_.emplace(std::move(next));
  measure_distance();
  diverged_ = false;
  keep_exchange(what, std::move(given_up));
}

}  // namespace pabd
