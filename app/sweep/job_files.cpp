// SPDX-License-Identifier: MIT
// See job_files.h. The text of each file is in jobs/, with "@name@" for what differs from sweep to sweep.
#include "app/sweep/job_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/shell_quoted.h"

namespace pabd {

std::string_view job_template(std::string_view name);  // embedded by embed_files.cmake

namespace {

constexpr std::size_t kMostArrayJobs = 1000;  // Slurm's MaxArraySize is 1001 unless it is set

struct Engine {
  std::string_view name, file, start;  // of start: @file@, @processes@
};
constexpr Engine kEngines[] = {{"slurm", "sweep.sbatch", "sbatch @file@"},
                               {"parallel", "sweep.parallel.sh", "sh @file@"},
                               {"mpi", "sweep.mpi.sh", "sh @file@ -n @processes@"},
                               {"snakemake", "Snakefile", "snakemake -s @file@ --cores all"}};

using Values = std::vector<std::pair<std::string_view, std::string>>;

// Replaces "@name@" by the value of that name; values are not searched.
std::string filled(std::string_view text, const Values& values) {
  std::string out;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find('@'), text.size());
    out += text.substr(0, at);
    text.remove_prefix(at);
    const auto value = std::find_if(values.begin(), values.end(), [&](const auto& v) {
      return text.substr(std::min<std::size_t>(1, text.size())).starts_with(fmt::format("{}@", v.first));
    });
    if (value != values.end()) {
      out += value->second;
      text.remove_prefix(value->first.size() + 2);
    } else if (!text.empty()) {
      out += '@';
      text.remove_prefix(1);
    }
  }
  return out;
}

// "pabd sweep …/plan.json -o …", for a shell.
std::string command(const JobSetting& setting, std::size_t chunk) {
  std::string out =
      fmt::format("{} sweep {} -o {} --quiet", sh_quoted(setting.program.string()),
                  sh_quoted((setting.folder / "plan.json").string()), sh_quoted(setting.folder.string()));
  if (setting.threads > 1) out += fmt::format(" --threads {}", setting.threads);
  if (chunk > 1) out += fmt::format(" --chunk {}", chunk);
  return out;
}

// JSON's texts are Python's, too.
std::string python(const std::string& text) { return Json(text).dump(-1, ' ', true); }

}  // namespace

std::vector<std::string> job_engines() {
  std::vector<std::string> out;
  for (const Engine& engine : kEngines) out.emplace_back(engine.name);
  return out;
}

JobFile job_file(std::string_view name, const std::vector<SweepTask>& tasks, const JobSetting& setting) {
  for (const auto& path : {setting.program, setting.folder}) {
    if (path.string().find_first_of("\n\r\"%") != std::string::npos)
      throw Error(ErrorKind::bad_input, "--emit " + std::string(name),
                  path.string() +
                      ": a path with a line break, a quote or a % does not fit in there; take another one");
  }
  const Engine& engine = *std::find_if(std::begin(kEngines), std::end(kEngines),
                                       [&](const Engine& e) { return e.name == name; });
  std::size_t chunk = std::max<std::size_t>(setting.chunk, 1);
  if (name == "slurm" && setting.chunk == 0) chunk = (tasks.size() + kMostArrayJobs - 1) / kMostArrayJobs;
  const auto path = setting.folder / engine.file;
  std::string numbers;
  for (const SweepTask& task : tasks) numbers += fmt::format("    \"{}\": {},\n", task.hash, task.index);
  const std::string run = command(setting, chunk);
  const Values values = {{"file", sh_quoted(path.string())},
                         {"folder", setting.folder.string()},
                         {"last", std::to_string((tasks.size() + chunk - 1) / chunk - 1)},
                         {"threads", std::to_string(setting.threads)},
                         {"processes", std::to_string(setting.processes)},
                         {"log", sh_quoted((setting.folder / "parallel.log").string())},
                         {"command", run},
                         {"quoted_command", sh_quoted(run + " --task {}")},
                         {"tasks", numbers},
                         {"python_folder", python(setting.folder.string())},
                         {"python_program", python(setting.program.string())}};
  return {path, filled(job_template(engine.file), values), filled(engine.start, values)};
}

}  // namespace pabd
