// SPDX-License-Identifier: MIT
// See job_files.h.
#include "app/sweep/job_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/base/error.h"
#include "sim/base/shell_quoted.h"

namespace pabd {
namespace {

constexpr std::size_t kMostArrayJobs = 1000;  // Slurm's MaxArraySize is 1001 unless it is set

// "pabd sweep …/plan.json -o …", for a shell.
std::string command(const JobSetting& setting, std::size_t chunk) {
  std::string out =
      fmt::format("{} sweep {} -o {} --quiet", sh_quoted(setting.program.string()),
                  sh_quoted((setting.folder / "plan.json").string()), sh_quoted(setting.folder.string()));
  if (setting.threads > 1) out += fmt::format(" --threads {}", setting.threads);
  if (chunk > 1) out += fmt::format(" --chunk {}", chunk);
  return out;
}

std::size_t last_job(std::size_t tasks, std::size_t chunk) { return (tasks + chunk - 1) / chunk - 1; }

// sbatch gives a job a signal before its time is up, and the shell of the script must hand it on.
std::string slurm(std::size_t count, std::size_t chunk, const JobSetting& setting) {
  return fmt::format(
      "#!/bin/bash\n"
      "# A sweep of pabd as a Slurm array. Start it with: sbatch {0}\n"
      "# Options of sbatch go before the file: sbatch --time=2:00:00 --partition=short {0}\n"
      "#SBATCH --job-name=pabd-sweep\n"
      "#SBATCH --array=0-{1}\n"
      "#SBATCH --cpus-per-task={2}\n"
      "#SBATCH --output=\"{3}/slurm-%A_%a.out\"\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --requeue\n"
      "#SBATCH --signal=B:TERM@60\n"
      "\n"
      "{4} --task \"$SLURM_ARRAY_TASK_ID\" &\n"
      "pid=$!\n"
      "trap 'kill -TERM \"$pid\" 2>/dev/null' TERM\n"
      "wait \"$pid\"\n"
      "# A signal ends the wait, not the program: it writes its checkpoint now.\n"
      "while kill -0 \"$pid\" 2>/dev/null; do wait \"$pid\"; done\n"
      "wait \"$pid\"  # has ended: what it ended with\n"
      "code=$?\n"
      "if [ \"$code\" = 75 ]; then\n"
      "  scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID\"  # and goes on there\n"
      "fi\n"
      "exit \"$code\"\n",
      sh_quoted((setting.folder / "sweep.sbatch").string()), last_job(count, chunk), setting.threads,
      setting.folder.string(), command(setting, chunk));
}

std::string parallel(std::size_t count, std::size_t chunk, const JobSetting& setting) {
  return fmt::format(
      "#!/bin/sh\n"
      "# A sweep of pabd by GNU parallel. Start it with: sh {0}\n"
      "# Options of parallel go behind: sh {0} --sshloginfile nodes --jobs 16\n"
      "seq 0 {1} | exec parallel --jobs {2} --joblog {3} \"$@\" {4}\n",
      sh_quoted((setting.folder / "sweep.parallel.sh").string()), last_job(count, chunk), setting.processes,
      sh_quoted((setting.folder / "parallel.log").string()),
      sh_quoted(command(setting, chunk) + " --task {}"));
}

std::string mpi(std::size_t chunk, const JobSetting& setting) {
  return fmt::format(
      "#!/bin/sh\n"
      "# A sweep of pabd, its tasks dealt out to the ranks of MPI. Start it with: sh {0} -n 64\n"
      "# Options of mpirun go behind: sh {0} -n 64 --hostfile nodes\n"
      "exec mpirun \"$@\" {1}\n",
      sh_quoted((setting.folder / "sweep.mpi.sh").string()), command(setting, chunk));
}

// JSON's texts are Python's, too.
std::string python(const std::string& text) { return Json(text).dump(-1, ' ', true); }

std::string snakemake(const std::vector<SweepTask>& tasks, const JobSetting& setting) {
  std::string numbers;
  for (const SweepTask& task : tasks) numbers += fmt::format("    \"{}\": {},\n", task.hash, task.index);
  return fmt::format(
      "# A sweep of pabd by Snakemake. Start it with: snakemake -s {0} --cores all\n"
      "TASKS = {{\n{1}}}\n"
      "FOLDER = {2}\n"
      "PROGRAM = {3}\n"
      "\n"
      "workdir: FOLDER\n"
      "\n"
      "rule all:\n"
      "    input: [\"tasks/\" + task + \"/result.json\" for task in TASKS]\n"
      "\n"
      "rule task:\n"
      "    output: \"tasks/{{task}}/result.json\"\n"
      "    # Functions: braces in a text would be wildcards.\n"
      "    params: program=lambda wildcards: PROGRAM, folder=lambda wildcards: FOLDER,\n"
      "            index=lambda wildcards: TASKS[wildcards.task]\n"
      "    threads: {4}\n"
      "    shell: \"{{params.program:q}} sweep {{params.folder:q}}/plan.json -o {{params.folder:q}} --quiet"
      " --threads {{threads}} --task {{params.index}}\"\n",
      sh_quoted((setting.folder / "Snakefile").string()), numbers, python(setting.folder.string()),
      python(setting.program.string()), setting.threads);
}

}  // namespace

std::span<const std::string_view> job_engines() {
  static constexpr std::array<std::string_view, 4> kEngines = {"slurm", "parallel", "mpi", "snakemake"};
  return kEngines;
}

JobFile job_file(std::string_view engine, const std::vector<SweepTask>& tasks, const JobSetting& setting) {
  for (const auto& path : {setting.program, setting.folder}) {
    if (path.string().find_first_of("\n\r\"%") != std::string::npos)
      throw Error(ErrorKind::bad_input, "--emit " + std::string(engine),
                  path.string() +
                      ": a path with a line break, a quote or a % does not fit in there; take another one");
  }
  std::size_t chunk = std::max<std::size_t>(setting.chunk, 1);
  if (engine == "slurm") {
    if (setting.chunk == 0) chunk = (tasks.size() + kMostArrayJobs - 1) / kMostArrayJobs;
    const auto path = setting.folder / "sweep.sbatch";
    return {path, slurm(tasks.size(), chunk, setting), "sbatch " + sh_quoted(path.string())};
  }
  if (engine == "parallel") {
    const auto path = setting.folder / "sweep.parallel.sh";
    return {path, parallel(tasks.size(), chunk, setting), "sh " + sh_quoted(path.string())};
  }
  if (engine == "mpi") {
    const auto path = setting.folder / "sweep.mpi.sh";
    return {path, mpi(chunk, setting),
            fmt::format("sh {} -n {}", sh_quoted(path.string()), setting.processes)};
  }
  const auto path = setting.folder / "Snakefile";
  return {path, snakemake(tasks, setting),
          fmt::format("snakemake -s {} --cores all", sh_quoted(path.string()))};
}

}  // namespace pabd
