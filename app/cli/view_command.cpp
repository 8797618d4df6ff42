// SPDX-License-Identifier: MIT
// pabd view: the interactive window, and the same without a display for scripts.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "app/cli/device_option.h"
#include "app/cli/exit_code.h"
#include "app/cli/interrupt.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/streams.h"
#include "app/gui/script.h"
#include "app/gui/settings.h"
#include "app/gui/viewer.h"
#include "app/sweep/collect_sweep.h"
#include "render/context/window.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"

namespace fs = std::filesystem;

namespace pabd::cli {
namespace {

constexpr std::size_t kMostScriptBytes = std::size_t{16} << 20;
constexpr const char *kWindowSize = "1280x720", *kScene = "two_boxes";
constexpr double kIdle = 0.1;  // seconds that a window at rest waits for an event

// What steps are made with has a context of the window: it ends first.
struct RunnerEnd {
  std::unique_ptr<Runner>& runner;
  SharedContext& shared;
  ~RunnerEnd() {
    runner.reset();
    shared.drop();
  }
};

// Ends a script early: the window was closed, or the program was interrupted.
struct LeftScript {};

struct ViewOptions {
  CommonOptions common;
  std::string scene = kScene;
  std::string sweep;  // folder; empty: none
  std::string script, out = ".", size, backend = "auto", device;
  double scale = 0, memory = 512;
  bool headless = false, actions = false, force = false, play = false;
};

ViewerOptions viewer_options(const ViewOptions& options, double screen_scale) {
  ViewerOptions out;
  out.screen_scale = options.scale > 0 ? options.scale : screen_scale;
  out.steady = options.headless;
  out.shipped_scenes = [] { return shipped_scenes(); };
  return out;
}

std::unique_ptr<Runner> start_runner(const ViewOptions& options, std::shared_ptr<SharedContext> shared) {
  WorkbenchOptions bench;
  bench.threads = options.common.thread_count();
  bench.memory = static_cast<std::size_t>(options.memory * kBytesPerMegabyte);
  bench.find_scene = [](const std::string& name) { return find_scene(name).string(); };
  bench.devices = gpu_devices(parse_backend(options.backend), std::move(shared));
  std::vector<std::string> sets = options.common.sets;
  if (!options.device.empty()) sets.push_back("solver.device=" + options.device);
  return std::make_unique<Runner>(
      std::make_unique<Workbench>(bench, command::Load{options.scene, std::move(sets), false}));
}

std::string read_script(const ViewOptions& options) {
  return read_file(options.script, kMostScriptBytes, "a list of actions");
}

InputFiles inputs_of(const ViewOptions& options) {
  InputFiles inputs;
  inputs.add(options.script);
  inputs.add(options.scene);
  return inputs;
}
void print(const std::string& line) { write_stdout(line); }

// The folder of a sweep stands for its scene, with the sweep beside it. A scene that is not on this machine, where
// tasks were brought from a cluster, is missed by what needs it.
void open_sweep_of(ViewOptions& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::path(options.scene) / "plan.json", ignored)) return;
  options.sweep = options.scene;
  options.scene = scene_of_sweep(options.sweep);
  try {
    find_scene(options.scene);
  } catch (const Error&) {
    options.scene = kScene;
  }
}

void show_sweep(const ViewOptions& options, Viewer& viewer) {
  if (!options.sweep.empty()) viewer.send(ViewCommand(command::OpenSweep{options.sweep}));
}

int view_headless(const ViewOptions& options, const FrameSize& size) {
  const Script script(read_script(options), options.script);
  const auto shared = std::make_shared<SharedContext>();
  const auto runner = start_runner(options, shared);
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(parse_backend(options.backend), attempts);
  shared->put_beside(*context);
  Viewer viewer(*context, *runner, viewer_options(options, 1));
  show_sweep(options, viewer);
  script.run(viewer, *runner,
             {options.out, options.force, size.width, size.height, {}, {}, print, inputs_of(options)});
  if (!options.common.quiet)
    write_note(fmt::format("{}: {} done", options.script, counted(script.size(), "action")));
  return 0;
}

// How the window looked when it was left; a script always begins with the same looks.
Settings kept_settings(const ViewOptions& options, Runner& runner) {
  const auto path = settings_path();
  if (!path || !options.script.empty()) return {};
  try {
    return read_settings(*path);
  } catch (const Error& error) {
    runner.send(command::Tell{error.what(), true});
    return {};
  }
}

void keep_settings(const ViewOptions& options, const UiState& ui, int width, int height) {
  const auto path = settings_path();
  if (!path || !options.script.empty()) return;
  try {
    write_settings(*path, {ui, width, height});
  } catch (const Error& error) {
    if (!options.common.quiet) write_note(std::string("pabd: note: ") + error.what());
  }
}

int view_window(const ViewOptions& options, FrameSize size) {
  std::unique_ptr<Script> script;
  if (!options.script.empty()) script = std::make_unique<Script>(read_script(options), options.script);
  const InterruptGuard interrupt;  // before the window can be seen
  const auto shared = std::make_shared<SharedContext>();
  auto runner = start_runner(options, shared);
  const Settings kept = kept_settings(options, *runner);
  if (options.size.empty() && kept.width > 0 && kept.height > 0) size = {kept.width, kept.height};
  WindowOptions window_options;
  window_options.width = size.width;
  window_options.height = size.height;
  window_options.display_lost_status = exit_code(ErrorKind::no_context);
  const auto window = open_window(window_options);
  shared->put_beside(window->context());
  const RunnerEnd before_window{runner, *shared};
  ViewerOptions setup = viewer_options(options, window->content_scale());
  setup.start = kept.ui;
  setup.clipboard = [&] { return window->clipboard(); };
  setup.set_clipboard = [&](const std::string& text) { window->set_clipboard(text); };
  Viewer viewer(window->context(), *runner, setup);
  show_sweep(options, viewer);
  if (options.play) runner->send(command::Play{});

  std::string title;
  int width = 0, height = 0;
  const auto take_events = [&](double wait) {
    for (const WindowEvent& event : window->poll(wait)) {
      const auto* scaled = std::get_if<ScaleChanged>(&event);
      if (scaled && options.scale == 0) viewer.set_screen_scale(scaled->scale);
      viewer.handle(event);
    }
    if (window->should_close()) {
      window->keep_open();  // the viewer asks about what is not saved
      viewer.send(ViewCommand(command::Quit{}));
    }
    window->size(width, height);
  };
  const auto present = [&] {
    if (!window->answers()) return;
    viewer.renderer().blit_to_window(width, height);
    window->context().present();
    window->set_cursor(viewer.cursor());
    const std::string name =
        viewer.snapshot().scene->name + (viewer.snapshot().unsaved ? " • pabd" : " – pabd");
    if (name != title) window->set_title(title = name);
  };
  const auto leaving = [&] { return interrupt.requested() || window->display_lost() || viewer.ui().quit; };

  if (script) {
    ScriptOptions script_options{options.out, options.force, size.width, size.height,
                                 {},          present,       print,      inputs_of(options)};
    script_options.before_frame = [&] {
      take_events(0);
      if (interrupt.requested() || window->display_lost()) throw LeftScript();
    };
    try {
      script->run(viewer, *runner, script_options);
    } catch (const LeftScript&) {
    }
  }
  using Clock = std::chrono::steady_clock;
  for (auto last = Clock::now(); !leaving();) {
    const bool busy = viewer.has_input() || viewer.snapshot().playing;
    take_events(busy ? 0 : kIdle);
    if (width < 1 || height < 1) continue;  // minimised
    const auto now = Clock::now();
    viewer.draw(width, height, std::chrono::duration<double>(now - last).count());
    last = now;
    present();
  }
  keep_settings(options, viewer.ui(), width, height);
  if (window->display_lost())
    throw Error(ErrorKind::no_context, "the display was lost; nothing that is on disk was touched");
  return interrupt.exit_code();
}

int view(const ViewOptions& asked) {
  ViewOptions options = asked;
  if (options.actions) {
    write_stdout(action_list());
    return 0;
  }
  open_sweep_of(options);
  const FrameSize size = parse_size(options.size.empty() ? kWindowSize : options.size);
  if (options.scale != 0) check_range("--scale", options.scale, 0.5, 4);
  check_range("--memory", options.memory, 1, 1e6, "MB");
  if (options.headless && options.script.empty()) {
    throw Error(ErrorKind::bad_input,
                "--headless: nobody can press keys without a display; give --script ACTIONS.json");
  }
  return options.headless ? view_headless(options, size) : view_window(options, size);
}

}  // namespace

void add_view_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ViewOptions>();
  const Command command(app, "view", "the interactive window: tune N, d̂ and κ while it runs",
                        {"pabd view", "pabd view pyramid --set contact.N=8 --play", "pabd view sweep_out",
                         "pabd view two_boxes --script actions.json --headless -o pictures"},
                        options->common);
  constexpr const char *kWindow = "Window", *kScripts = "Scripts";
  command.argument(
      "SCENE", options->scene,
      "scene file, or the name of a shipped scene (default two_boxes), or the folder of a sweep");
  command.flag(kWindow, "--play", options->play, "start at once");
  command.option(kWindow, "--size", options->size,
                 "pixels of the window (default: as it was left, at first 1280x720)", "WxH");
  command.option(kWindow, "--scale", options->scale, "size of everything (default: what the screen asks for)",
                 "F");
  command.option(kScripts, "--script", options->script, "carry out a list of actions", "JSON");
  command.flag(kScripts, "--actions", options->actions, "list the actions of scripts and leave");
  command.flag(kScripts, "--headless", options->headless, "no window: only the script");
  command.option(kScripts, "-o,--out", options->out,
                 "folder for the frames that a script writes (default: here)", "FOLDER");
  command.flag(kScripts, "--force", options->force, "replace files that exist");
  command.option(group::kSimulation, "--memory", options->memory, "for states of the past (default 512)",
                 "MB");
  add_device_option(command, options->device);
  command.backend(options->backend);
  command.simulation(options->common);
  command.carry_out(action, options, view);
}

}  // namespace pabd::cli
