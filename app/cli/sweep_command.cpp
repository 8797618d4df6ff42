// SPDX-License-Identifier: MIT
// pabd sweep: one scene with many parameter sets.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "app/cli/exit_code.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/cli/sweep_run.h"
#include "app/sweep/job_files.h"
#include "app/sweep/share.h"
#include "app/sweep/task_folder.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace fs = std::filesystem;

namespace pabd::cli {
namespace {

struct SweepOptions {
  CommonOptions common;
  std::string plan;
  std::string folder;
  std::string task;  // a number, "all", "-"; empty: as the environment says
  std::string engine;
  std::size_t chunk = 0;  // 0: 1, or what the engine needs
  int jobs = 0;           // 0: the CPUs that may be used
  bool list = false;
  bool json = false;
  bool force = false;
};

int usable(const Environment& environment) {
  return std::min(available_cpus(), scheduled_cpus(environment, true).value_or(available_cpus()));
}

// Which tasks are asked for; a share of a scheduler's says so.
std::vector<std::size_t> chosen_tasks(const SweepOptions& options, const std::optional<TaskShare>& share,
                                      std::size_t count) {
  return tasks_in(share.value_or(TaskShare{}), count, std::max<std::size_t>(options.chunk, 1));
}

std::optional<TaskShare> share_of(const SweepOptions& options, const Environment& environment) {
  if (options.task == "all") return std::nullopt;
  if (options.task.empty()) return scheduled_share(environment);
  TaskShare share{0, 1, true, ""};
  const char* end = options.task.data() + options.task.size();
  const auto [at, failure] = std::from_chars(options.task.data(), end, share.first);
  if (failure != std::errc() || at != end)
    throw Error(
        ErrorKind::bad_input, "--task " + options.task,
        "expected the index of a task, as --list shows it, or \"all\", or - to be told by standard input");
  return share;
}

int list_tasks(const SweepOptions& options, const std::vector<SweepTask>& tasks) {
  std::string out;
  for (const SweepTask& task : tasks)
    out += options.json ? task.to_json().dump() + "\n" : fmt::format("{}\t{}\n", task.index, task.text());
  write_stdout(out);
  return kDone;
}

int emit_file(const SweepOptions& options, const fs::path& folder, const std::vector<SweepTask>& tasks,
              const Environment& environment) {
  JobSetting setting{own_program(), folder, options.chunk, 1, std::max(options.common.threads, 1)};
  setting.processes = options.jobs > 0 ? options.jobs : std::max(usable(environment) / setting.threads, 1);
  const JobFile file = job_file(options.engine, tasks, setting);
  TextOutput output("--emit", file.path.string(), options.force);
  output.write(file.text);
  output.finish();
  if (!options.common.quiet)
    write_note(fmt::format("{} · start it with: {}", file.path.string(), file.start));
  return kDone;
}

int sweep(const SweepOptions& options) {
  if (options.plan.empty())
    throw Error(ErrorKind::bad_input, "PLAN: expected a plan of a sweep, or 'pabd sweep collect DIR'");
  const SweepPlan plan = read_plan(options.plan, find_scene);
  std::vector<ImportNote> notes;
  const Scene base = base_scene(plan, &notes);
  const std::vector<SweepTask> tasks = tasks_of(plan, base);
  if (!options.common.quiet) write_import_notes(plan.scene_name, notes);
  if (options.list) {
    check_plan(plan, tasks);
    return list_tasks(options, tasks);
  }
  if (options.folder.empty())
    throw Error(ErrorKind::bad_input,
                "--out: expected the folder of the results: -o DIR (or --list, to see the tasks)");
  const Environment environment = own_environment();
  const bool told = options.task == "-";
  const auto share = told ? std::nullopt : share_of(options, environment);
  if (!told && !share) check_plan(plan, tasks);
  const auto chosen = chosen_tasks(options, share, tasks.size());
  const fs::path folder = fs::absolute(options.folder).lexically_normal();
  prepare_sweep_folder(folder, plan, tasks, options.force);
  if (!options.engine.empty()) return emit_file(options, folder, tasks, environment);

  SweepWork work{plan, tasks, (folder / "plan.json").string(), folder, 1, 1, options.common.quiet};
  work.threads = options.common.threads;
  if (work.threads == 0)
    work.threads = share ? std::min(scheduled_cpus(environment, false).value_or(1), usable(environment)) : 1;
  if (told) return do_tasks_told(work);
  work.processes = options.jobs > 0 ? options.jobs
                   : share          ? 1
                                    : std::max(usable(environment) / work.threads, 1);
  if (share && !share->from.empty() && !options.common.quiet)
    write_note(fmt::format("pabd: note: {} of {}, as {} says; --task all does all of them",
                           counted(chosen.size(), "task"), tasks.size(), share->from));
  if (!options.common.quiet) {
    const std::string others = made_by_others(folder, plan, base, tasks, chosen);
    if (!others.empty()) write_note("pabd: note: " + others);
  }
  return do_tasks(work, chosen);
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<SweepOptions>();
  const Command command(
      app, "sweep", "run a scene with many parameter sets, here or on a cluster",
      {"pabd sweep plan.json --list", "pabd sweep plan.json -o out", "pabd sweep plan.json -o out --task 3",
       "pabd sweep plan.json -o out --emit slurm", "pabd sweep collect out"},
      options->common);
  using namespace group;
  command.argument("PLAN", options->plan, "plan of the sweep, JSON");
  command.option(kOutput, "-o,--out", options->folder,
                 "folder of the results, one for each task; what is done there is skipped", "FOLDER");
  auto* list =
      command.flag(kOutput, "--list", options->list, "print index and parameters of every task, and leave");
  command
      .flag(kOutput, "--json", options->json,
            "of --list: a JSON object a line, with the hash that names its folder")
      ->needs(list);
  command
      .word(kOutput, "--emit", options->engine, job_engines(),
            "write the file with which slurm, parallel, mpi or snakemake runs the sweep into the folder, and "
            "leave",
            "ENGINE")
      ->excludes(list);
  command.flag(kOutput, "--force", options->force,
               "replace the plan of a folder by another one; tasks that both have stay");
  command.option(kSimulation, "--task", options->task,
                 "only this one, counted from 0; \"all\"; or - for those that standard input names, one a "
                 "line. Default: what SLURM_ARRAY_TASK_ID, PBS_ARRAY_INDEX, PARALLEL_SEQ (from 1), "
                 "OMPI_COMM_WORLD_RANK or PMI_RANK says, else all",
                 "I");
  command
      .option(kSimulation, "--chunk", options->chunk,
              "count so many tasks as one, for --task and the schedulers (default 1)", "K")
      ->check(CLI::Range(std::size_t{1}, kMostTasks));
  command
      .option(kSimulation, "--jobs", options->jobs,
              "processes side by side, 1 … 1024; default: the CPUs that this process may use by its "
              "affinity, control groups and scheduler, over --threads; of one task 1",
              "N")
      ->check(CLI::Range(1, 1024));
  command.threads(options->common.threads,
                  "threads of the solver a task, 1 … 1024; results do not depend on it. Default: 1, of one "
                  "task SLURM_CPUS_PER_TASK");
  add_sweep_collect_command(command.app(), action);
  command.carry_out(action, options, sweep);
}

}  // namespace pabd::cli
