// SPDX-License-Identifier: MIT
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

// --threads; `words`: what it is for and what it is unless given.
void add_threads_option(CLI::App& command, int& threads, const std::string& words);

// --force, beside the outputs that it is about.
void add_force_option(CLI::App& command, bool& force);

// -o/--out and --force.
struct OutputOptions {
  std::string path;
  bool force = false;
};
void add_output_options(CLI::App& command, OutputOptions& output, const std::string& description);

// What `render` and `export` take unless it is said otherwise, and the most that is no slip of the hand.
inline constexpr double kDefaultTime = 5;  // s
inline constexpr int kMostFrames = 10'000'000;

inline constexpr int kBytesPerMegabyte = 1'000'000;
// "640 kB", "3.1 MB".
std::string bytes_text(double bytes);

// A size as "1280x720". Throws Error(bad_input) for anything else, or outside 16 … 16384.
struct FrameSize {
  int width = 1280;
  int height = 720;
};
FrameSize parse_size(const std::string& text);

// Throws Error(bad_input) "OPTION: …" unless lo ≤ value ≤ hi (false for NaN).
void check_range(const std::string& option, double value, double lo, double hi, const std::string& unit = "");

// Every subcommand, in the order of the help: one a file, and a line here. add_NAME_command adds it to `app`.
// clang-format off
#define PABD_COMMANDS(X) \
  X(render) \
  X(export) \
  X(run) \
  X(plot) \
  X(figure) \
  X(compare) \
  X(sweep) \
  X(scenes) \
  X(import) \
  X(bench) \
  X(validate) \
  X(doctor) \
  X(marks) \
  X(view) \
  X(serve) \
  X(completion) \
  X(man)
// clang-format on
#define PABD_DECLARE(name) void add_##name##_command(CLI::App& app, Action& action);
PABD_COMMANDS(PABD_DECLARE)
#undef PABD_DECLARE

// The program with its options and every subcommand; the chosen one leaves its work in `action`.
void set_up_program(CLI::App& app, Action& action);

}  // namespace pabd::cli
