// SPDX-License-Identifier: MIT
// The runs of a plan, in an order that stays the same.
#pragma once

#include <string>
#include <vector>

#include "app/sweep/plan.h"
#include "sim/import/notes.h"

namespace pabd {

struct SweepTask {
  std::size_t index = 0;  // from 0
  std::string hash;       // 16 hex digits
  KeyValues parameters;   // in the order of the plan

  nlohmann::ordered_json to_json() const;  // as in task.json
  std::string text() const;                // "contact.N=3 contact.kappa=10"
};

// All combinations, the last entry of the plan varies fastest; what comes out twice is there once. `base`: the plan's
// scene with its "set".
std::vector<SweepTask> tasks_of(const SweepPlan& plan, const Scene& base);

// The scene of a plan without parameters. `notes`, if there, gets those of robots. Throws Error as load_any_scene does,
// and Error(bad_input) where it asks for a GPU.
Scene base_scene(const SweepPlan& plan, std::vector<ImportNote>* notes = nullptr);
// With those of a task. Throws in the same way.
Scene scene_of(const SweepPlan& plan, const SweepTask& task);
// Of the run that distances are measured to. Precondition: the plan has a reference.
Scene reference_scene(const SweepPlan& plan);

// Throws Error(bad_input) when the scene takes none of several tasks from all over the plan: then it is the plan that is
// wrong, in a key for example.
void check_plan(const SweepPlan& plan, const std::vector<SweepTask>& tasks);

}  // namespace pabd
