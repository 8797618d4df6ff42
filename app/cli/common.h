// What every subcommand shares: options, and how a chosen command is carried out.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <string>
#include <vector>

#include "sim/base/available_cpus.h"

namespace pabd::cli {

// The work of the command that was chosen, set while the command line is parsed and run afterwards, so that a
// wrong command line never starts any work. Returns the exit code.
using Action = std::function<int()>;

struct CommonOptions {
  std::vector<std::string> sets;  // "key.path=value" for the scene reader
  int threads = 0;                // 0: default_threads
  bool quiet = false;

  int thread_count() const;
};

// What --threads is unless given: every CPU that may be used. Whoever draws or encodes beside has threads of
// his own: nothing waits for a thread that has not begun (sim/math/team.h), so that too many cost little.
int default_threads(const CpuLimits& limits);

// A subcommand with --quiet, --version and the examples in its help; `examples` are whole command lines.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::vector<std::string>& examples, CommonOptions& common);

// --set and --threads, for commands that read a scene.
void add_scene_options(CLI::App& command, CommonOptions& common);

// -o/--out and --force.
struct OutputOptions {
  std::string path;
  bool force = false;
};
void add_output_options(CLI::App& command, OutputOptions& output, const std::string& description);

// A size as "1280x720". Throws Error(bad_input) for anything else, or outside 16 … 16384.
struct FrameSize {
  int width = 1280;
  int height = 720;
};
FrameSize parse_size(const std::string& text);

// Throws Error(bad_input) "OPTION: …" unless lo ≤ value ≤ hi (false for NaN).
void check_range(const std::string& option, double value, double lo, double hi, const std::string& unit = "");

// One a file. Each adds its subcommand to `app`.
void add_run_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_plot_command(CLI::App& app, Action& action);
void add_figure_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_scenes_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);
void add_doctor_command(CLI::App& app, Action& action);
void add_view_command(CLI::App& app, Action& action);

}  // namespace pabd::cli
