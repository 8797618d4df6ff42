// SPDX-License-Identifier: MIT
// See common.h.
#include "app/cli/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "app/session/step_at_time.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace pabd::cli {
namespace {

constexpr double kDefaultTime = 5;  // s, where neither the command line nor the scene has a length

void set_up_help(CLI::App& app) {
  app.set_help_flag("-h,--help", "print this and leave");
  app.set_version_flag("--version", "pabd " PABD_VERSION, "print the version and leave");
}

}  // namespace

int default_threads(const CpuLimits& limits) { return std::min(usable_cpus(limits), 64); }

int CommonOptions::thread_count() const { return threads > 0 ? threads : default_threads(cpu_limits()); }

void set_up_program(CLI::App& app, Action& action) {
  app.name("pabd");
  app.description("Projective affine body dynamics: simulate, render without a display, plot, compare.");
  set_up_help(app);
  app.require_subcommand(1);
  app.footer(
      "'pabd help COMMAND' shows how a command is used.\n"
      "\n"
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

Command::Command(CLI::App& above, const std::string& name, const std::string& description,
                 const std::vector<std::string>& examples)
    : app_(above.add_subcommand(name, description)) {
  std::string footer = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) footer += "  " + example + "\n";
  app_->footer(footer);
  set_up_help(*app_);
}

Command::Command(CLI::App& above, const std::string& name, const std::string& description,
                 const std::vector<std::string>& examples, CommonOptions& common)
    : Command(above, name, description, examples) {
  flag(group::kGeneral, "--quiet", common.quiet, "no progress and no summary, errors only");
}

CLI::Option* Command::scene(std::string& scene) const {
  return argument("SCENE", scene, "scene file, or the name of a shipped scene")->required();
}

CLI::Option* Command::from(std::string& from) const {
  return option(group::kSimulation, "--from", from, "start at a state file of this scene", "STATE.json");
}

void Command::simulation(CommonOptions& common) const {
  repeated(group::kSimulation, "--set", common.sets,
           "override a scene key: --set contact.kappa=50 (may be repeated)", "KEY=VALUE");
  threads(common.threads,
          "threads of the solver, 1 … 1024; results do not depend on it. Default: the CPUs that this process "
          "may use, at most 64; 'pabd doctor' tells how many. Software GL and video encoders have threads of "
          "their own beside them");
}

void Command::threads(int& threads, const std::string& words) const {
  option(group::kSimulation, "--threads", threads, words, "N")->check(CLI::Range(1, 1024));
}

void Command::force(bool& force) const { flag(group::kOutput, "--force", force, "overwrite what exists"); }

void Command::output(OutputOptions& output, const std::string& words) const {
  option(group::kOutput, "-o,--out", output.path, words, "OUT")->required();
  force(output.force);
}

CLI::Option* Command::length(LengthOptions& length, const std::string& time, const std::string& fps) const {
  auto* seconds = option(group::kOutput, "--time", length.time, time, "S");
  auto* frames =
      option(group::kOutput, "--frames", length.frames, "number of frames instead of a length", "N");
  option(group::kOutput, "--fps", length.fps, fps, "F");
  return frames->excludes(seconds);
}

void Command::backend(std::string& backend) const {
  word(group::kPicture, "--backend", backend, {"auto", "egl", "osmesa"},
       "where OpenGL comes from: auto, egl, osmesa (default auto)", "NAME");
}

void Command::trail(std::vector<std::string>& trails, const std::string& words) const {
  repeated(group::kPicture, "--trail", trails,
           "the path of a body's centre, of a point of it (body frame, m), or with com of the centre of mass "
           "of all that moves" +
               words + "; may be given several times",
           "BODY[@X,Y,Z]");
}

void Command::quality(std::string& quality, const std::string& words) const {
  word(group::kPicture, "--quality", quality, {"draft", "good", "best"}, words);
}

Backend parse_backend(const std::string& name) {
  if (name == "egl") return Backend::egl;
  if (name == "osmesa") return Backend::osmesa;
  return Backend::automatic;
}

std::int64_t frame_count(const LengthOptions& length, const Scene& scene, double fps, bool with_end,
                         const Pace& pace) {
  if (length.frames) {
    check_range("--frames", static_cast<double>(*length.frames), 1, kMostFrames);
    return *length.frames;
  }
  const double time = length.time.value_or(scene.duration.value_or(kDefaultTime));
  const std::string name = length.time || !scene.duration ? "--time" : "duration of the scene";
  check_range(name, time, 0, 1e6, "s");
  const std::int64_t frames = steps_until(pace.shown(time), 1 / fps) + (with_end ? 1 : 0);
  if (frames < 1) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{} {}: shorter than one frame; give at least {:.4g} s, or --frames 1", name,
                            time, 1 / fps));
  }
  check_range(fmt::format("{} × --fps", name), static_cast<double>(frames), 1, kMostFrames, "frames");
  return frames;
}

std::string file_size_text(const std::string& path) {
  std::error_code unknown;
  const auto bytes = static_cast<double>(std::filesystem::file_size(path, unknown));
  if (unknown) return "";
  return bytes < 1e6 ? fmt::format(", {:.0f} kB", std::ceil(bytes / 1e3))
                     : fmt::format(", {:.1f} MB", bytes / 1e6);
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
