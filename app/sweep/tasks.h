// SPDX-License-Identifier: MIT
// The runs of a plan, in a fixed order.
#pragma once

#include <string>
#include <vector>

#include "app/sweep/plan.h"
#include "sim/import/notes.h"

namespace pabd {

// "pabd 1.2.3". Part of the hash of a task, since versions may differ in results.
std::string sweep_program();

struct SweepTask {
  std::size_t index = 0;  // from 0
  std::string hash;       // 16 hex digits
  std::string program;    // that makes it
  KeyValues parameters;   // in the order of the plan

  nlohmann::ordered_json to_json() const;  // as in task.json
  std::string text() const;                // "contact.N=3 contact.kappa=10"
};

// All combinations without duplicates; the last entry of the plan varies fastest. `base`: the plan's scene with its
// "set". An empty `program`: hashes of versions that did not include the program.
std::vector<SweepTask> tasks_of(const SweepPlan& plan, const Scene& base,
                                const std::string& program = sweep_program());

// The scene of a plan without parameters. `notes`, if not null, receives those of an imported robot. Throws as
// load_any_scene does, and Error(bad_input) if it requires a GPU.
Scene base_scene(const SweepPlan& plan, std::vector<ImportNote>* notes = nullptr);
// With the parameters of a task. Throws in the same way.
Scene scene_of(const SweepPlan& plan, const SweepTask& task);
// Of the reference run. Precondition: the plan has a reference.
Scene reference_scene(const SweepPlan& plan);

// Throws Error(bad_input) when the scene accepts none of several tasks across the plan: then the plan itself is wrong.
void check_plan(const SweepPlan& plan, const std::vector<SweepTask>& tasks);

}  // namespace pabd
