// SPDX-License-Identifier: MIT
// Options that several subcommands share.
#include "app/cli/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/help_text.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"

namespace pabd::cli {

int default_threads(const CpuLimits& limits) { return std::min(usable_cpus(limits), 64); }

int CommonOptions::thread_count() const { return threads > 0 ? threads : default_threads(cpu_limits()); }

void set_up_program(CLI::App& app, Action& action) {
  app.name("pabd");
  app.description("Projective affine body dynamics: simulate, render without a display, plot, compare.");
  app.set_help_flag("-h,--help", "print this and leave");
  app.set_version_flag("--version", "pabd " PABD_VERSION, "print the version and leave");
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  pabd render pyramid -o pyramid.mp4 --time 5\n"
      "  pabd view two_boxes\n"
      "  pabd run pyramid --time 10 --trace steps.csv\n"
      "  pabd bench pyramid bridge --steps 100\n"
      "  pabd plot barrier -o barrier.svg --N 1,2,3,8\n"
      "\n"
      "Exit codes: 0 done, 1 defect in the program, 2 bad input, 3 file, 4 no GL, 5 diverged, 6 encoder, "
      "7 images differ or an expectation failed, 75 a sweep stopped with checkpoints, "
      "129/130/143 interrupted.\n");

#define PABD_ADD(name) add_##name##_command(app, action);
  PABD_COMMANDS(PABD_ADD)
#undef PABD_ADD
}

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::vector<std::string>& examples, CommonOptions& common) {
  CLI::App* command = app.add_subcommand(name, description);
  std::string footer = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) footer += "  " + example + "\n";
  command->footer(footer);
  command->set_help_flag("-h,--help", "print this and leave");
  command->add_flag("--quiet", common.quiet, "no progress and no summary, errors only")
      ->group(group::kGeneral);
  command->set_version_flag("--version", "pabd " PABD_VERSION, "print the version and leave");
  return command;
}

void add_scene_options(CLI::App& command, CommonOptions& common) {
  command.add_option("--set", common.sets, "override a scene key: --set contact.kappa=50 (may be repeated)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->group(group::kSimulation);
  add_threads_option(command, common.threads,
                     "threads of the solver, 1 … 1024; results do not depend on it. Default: the CPUs that "
                     "this process may use, at "
                     "most 64; 'pabd doctor' tells how many. Software GL and video encoders have threads of "
                     "their own beside them");
}

void add_threads_option(CLI::App& command, int& threads, const std::string& words) {
  command.add_option("--threads", threads, words)
      ->type_name("N")
      ->group(group::kSimulation)
      ->check(CLI::Range(1, 1024));
}

void add_force_option(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "overwrite what exists")->group(group::kOutput);
}

void add_output_options(CLI::App& command, OutputOptions& output, const std::string& description) {
  command.add_option("-o,--out", output.path, description)
      ->type_name("OUT")
      ->required()
      ->group(group::kOutput);
  add_force_option(command, output.force);
}

std::string bytes_text(double bytes) {
  return bytes < 1e6 ? fmt::format("{:.0f} kB", std::ceil(bytes / 1e3))
                     : fmt::format("{:.1f} MB", bytes / 1e6);
}

FrameSize parse_size(const std::string& text) {
  FrameSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  bool good = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  if (good) {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    good = height.ec == std::errc() && height.ptr == end;
  }
  const auto fits = [](int side) { return side >= 16 && side <= 16384; };
  if (!good || !fits(size.width) || !fits(size.height)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("--size {}: expected WIDTHxHEIGHT, each 16 … 16384, such as 1280x720", text));
  }
  return size;
}

void check_range(const std::string& option, double value, double lo, double hi, const std::string& unit) {
  if (value >= lo && value <= hi) return;
  throw Error(ErrorKind::bad_input, fmt::format("{} {}: expected {} … {}{}{}", option, value, lo, hi,
                                                unit.empty() ? "" : " ", unit));
}

}  // namespace pabd::cli
