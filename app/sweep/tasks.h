// SPDX-License-Identifier: MIT
// The runs of a plan, in an order that stays the same.
#pragma once

#include <string>
#include <vector>

#include "app/sweep/plan.h"
#include "sim/import/notes.h"

namespace pabd {

// "pabd 1.2.3". Other versions may come to other numbers, so that the hash of a task has it.
std::string sweep_program();

struct SweepTask {
  std::size_t index = 0;  // from 0
  std::string hash;       // 16 hex digits
  std::string program;    // that makes it
  KeyValues parameters;   // in the order of the plan

  nlohmann::ordered_json to_json() const;  // as in task.json
  std::string text() const;                // "contact.N=3 contact.kappa=10"
};

// All combinations, the last entry of the plan varies fastest; what comes out twice is there once. `base`: the plan's
// scene with its "set". An empty `program`: as the versions counted them that did not look at theirs.
std::vector<SweepTask> tasks_of(const SweepPlan& plan, const Scene& base,
                                const std::string& program = sweep_program());

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
