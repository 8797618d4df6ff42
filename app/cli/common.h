// SPDX-License-Identifier: MIT
// What the subcommands share: how they are added, their common options, and how the chosen one is carried out.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/frames/pace.h"
#include "render/context/context.h"
#include "sim/base/available_cpus.h"
#include "sim/scene/typed_number.h"

namespace pabd {
struct Scene;
}

namespace pabd::cli {

// The work of the chosen command, set while the command line is parsed and run afterwards, so that a wrong command line
// never starts any work. Returns the exit code.
using Action = std::function<int()>;

struct CommonOptions {
  std::vector<std::string> sets;  // "key.path=value" for the scene reader
  int threads = 0;                // 0: default_threads
  bool quiet = false;

  int thread_count() const;
};

// What --threads is unless given: every CPU that may be used, at most 64.
int default_threads(const CpuLimits& limits);

// Groups of options, in the order in which help shows them; any other comes before the last.
namespace group {
inline constexpr const char* kOwn = "Options";
inline constexpr const char* kOutput = "Output";
inline constexpr const char* kPicture = "Picture";
inline constexpr const char* kVideo = "Video";
inline constexpr const char* kSimulation = "Simulation";
inline constexpr const char* kGeneral = "General";
}  // namespace group

// -o/--out and --force.
struct OutputOptions {
  std::string path;
  bool force = false;
};

// How many frames: --time, --frames and --fps.
struct LengthOptions {
  std::optional<double> time;  // s
  std::optional<std::int64_t> frames;
  std::optional<double> fps;  // 1/s
};
inline constexpr int kMostFrames = 10'000'000;

// The type of a value, of an optional one, of one of a list.
template <class T>
struct Single {
  using Type = T;
};
template <class T>
struct Single<std::optional<T>> : Single<T> {};
template <class T>
struct Single<std::vector<T>> : Single<T> {};

// A subcommand, while its options are added to it.
class Command {
 public:
  // With --version; `examples` are whole command lines.
  Command(CLI::App& above, const std::string& name, const std::string& description,
          const std::vector<std::string>& examples);
  // And with --quiet.
  Command(CLI::App& above, const std::string& name, const std::string& description,
          const std::vector<std::string>& examples, CommonOptions& common);

  CLI::App& app() const { return *app_; }

  template <class T>
  CLI::Option* argument(const char* name, T& value, const std::string& words) const {
    return app_->add_option(name, value, words);
  }
  // `type`: what help calls the value: "N", "OUT.png", "S" for seconds. `unit`: of numbers.
  template <class T>
  CLI::Option* option(const char* group, const char* name, T& value, const std::string& words,
                      const char* type, const char* unit = "") const {
    auto* option = app_->add_option(name, value, words)->type_name(type)->group(group);
    using Type = typename Single<T>::Type;
    if constexpr (std::is_arithmetic_v<Type>) {
      const std::string_view of = std::string_view(type) == "S" ? "s" : unit;
      option->transform(CLI::Validator(
          [of](std::string& text) {
            const std::string problem = number_problem(text, std::is_integral_v<Type>, of);
            if (problem.empty()) text = typed_number(text, of);
            return problem;
          },
          ""));
    }
    return option;
  }
  // One that may be given several times.
  CLI::Option* repeated(const char* group, const char* name, std::vector<std::string>& values,
                        const std::string& words, const char* type) const {
    return option(group, name, values, words, type)->allow_extra_args(false);
  }
  // One that takes a list with commas.
  template <class T>
  CLI::Option* list(const char* group, const char* name, std::vector<T>& values, const std::string& words,
                    const char* unit = "") const {
    return option(group, name, values, words, "LIST", unit)->delimiter(',')->allow_extra_args(false);
  }
  // One of several words.
  CLI::Option* word(const char* group, const char* name, std::string& value,
                    const std::vector<std::string>& allowed, const std::string& words,
                    const char* type = "WORD") const {
    return option(group, name, value, words, type)->check(CLI::IsMember(allowed));
  }
  CLI::Option* flag(const char* group, const char* name, bool& value, const std::string& words) const {
    return app_->add_flag(name, value, words)->group(group);
  }

  CLI::Option* scene(std::string& scene) const;                        // the argument SCENE
  CLI::Option* from(std::string& from) const;                          // --from, a state to start at
  void simulation(CommonOptions& common) const;                        // --set and --threads
  void threads(int& threads, const std::string& words) const;          // --threads alone
  void force(bool& force) const;                                       // --force
  void output(OutputOptions& output, const std::string& words) const;  // -o and --force
  // --time, --frames and --fps; `time` and `fps` are their words. Returns --frames.
  CLI::Option* length(LengthOptions& length, const std::string& time, const std::string& fps) const;
  void backend(std::string& backend) const;  // --backend
  void trail(std::vector<std::string>& trails, const std::string& words) const;
  void quality(std::string& quality, const std::string& words) const;

  // What the command does once everything is parsed. A command below this one that was chosen goes first.
  template <class Options>
  void carry_out(Action& action, const std::shared_ptr<Options>& options, int (*work)(const Options&)) const {
    app_->callback([&action, options, work] {
      if (!action) action = [options, work] { return work(*options); };
    });
  }

 private:
  CLI::App* app_;
};

// "auto", "egl" or "osmesa".
Backend parse_backend(const std::string& name);

// Frames at this pace of `length` or, where it does not say, of the scene: with_end counts the one at the end, too. Throws
// Error(bad_input) for none or more than kMostFrames.
std::int64_t frame_count(const LengthOptions& length, const Scene& scene, double fps, bool with_end,
                         const Pace& pace = {});

inline constexpr int kBytesPerMegabyte = 1'000'000;
// ", 3.1 MB": the size of a file that was written, for the end of a line; empty where it is not known.
std::string file_size_text(const std::string& path);

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
  X(view) \
  X(serve)
// clang-format on
#define PABD_DECLARE(name) void add_##name##_command(CLI::App& app, Action& action);
PABD_COMMANDS(PABD_DECLARE)
#undef PABD_DECLARE
// Commands below others.
void add_plot_barrier_command(CLI::App& plot, Action& action);
void add_plot_convergence_command(CLI::App& plot, Action& action);
void add_plot_reactions_command(CLI::App& plot, Action& action);
void add_plot_series_command(CLI::App& plot, Action& action);
void add_sweep_collect_command(CLI::App& sweep, Action& action);

// The program with its options and every subcommand; the chosen one leaves its work in `action`.
void set_up_program(CLI::App& app, Action& action);

}  // namespace pabd::cli
