// SPDX-License-Identifier: MIT
// The window while a scene plays, without a display: frames a second, their parts, and how fast the simulation goes
// beside it.
//
//     bench_window [--first] [--gpu] [--plain] [--size W H] [--frames N] [SCENE…]
//
// Default: pyramid pile, contacts and panels shown, 1280×720, 300 frames after the first 30. --gpu makes the steps.
// --first: the longest frames after the window opens, after play, and while what it shows is switched.
// --plain: neither contacts nor panels. SCENE: a shipped one, or a file. As on a display there are at most 60 frames a
// second: more would take the GPU from the steps, for nothing.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "app/gui/viewer.h"
#include "render/context/context.h"
#include "tests/support/gpu_steps.h"

namespace {

using namespace pabd;
using Clock = std::chrono::steady_clock;

constexpr int kWarm = 30;
constexpr double kLeast = 5;                                 // s
constexpr auto kDisplay = std::chrono::microseconds(16667);  // between its frames

struct Options {
  bool first = false, gpu = false, plain = false;
  int width = 1280, height = 720, frames = 300;
  std::vector<std::string> scenes;
};

Options parse(int argc, char** argv) {
  Options out;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    const auto number = [&] { return k + 1 < argc ? std::max(1, std::atoi(argv[++k])) : 1; };
    if (word == "--first") {
      out.first = true;
    } else if (word == "--gpu") {
      out.gpu = true;
    } else if (word == "--plain") {
      out.plain = true;
    } else if (word == "--size") {
      out.width = number();
      out.height = number();
    } else if (word == "--frames") {
      out.frames = number();
    } else {
      out.scenes.push_back(word.ends_with(".json") ? word : PABD_SCENES "/" + word + ".json");
    }
  }
  if (out.scenes.empty()) out.scenes = {PABD_SCENES "/pyramid.json", PABD_SCENES "/pile.json"};
  return out;
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void measure(GlContext& context, const Options& options, const std::string& scene) {
  const auto shared = std::make_shared<SharedContext>();
  shared->put_beside(context);
  WorkbenchOptions bench;
  std::vector<std::string> sets;
  if (options.gpu) {
    bench.devices = std::make_shared<test::GpuSteps>(shared);
    sets = {"solver.device=gpu"};
  }
  Runner runner(std::make_unique<Workbench>(bench, command::Load{scene, sets, false}));
  context.make_current();
  ViewerOptions window;
  if (options.plain) window.start.open = {};
  window.start.contacts = window.start.bonds = !options.plain;
  Viewer viewer(context, runner, window);
  viewer.send(Command(command::Play{}));
  if (options.gpu) viewer.send(Command(command::Speed{0}));
  while (viewer.snapshot().a.state->step < 2) {  // shaders are compiled first
    viewer.draw(options.width, options.height, 0.02);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  int away = 0;
  std::vector<double> ms;
  int pictures = 0;
  std::int64_t shown = -1;
  double simulated = 0;
  std::int64_t steps = 0;
  int contacts = 0;
  Clock::time_point begin{}, last = Clock::now();
  for (int k = -kWarm; k < options.frames || seconds_since(begin) < kLeast; ++k) {
    if (k == 0) {
      begin = Clock::now();
      simulated = viewer.snapshot().a.state->time;
      steps = viewer.snapshot().a.state->step;
    }
    const auto start = Clock::now();
    viewer.draw(options.width, options.height, seconds_since(last));
    last = start;
    if (k >= 0) ms.push_back(1e3 * seconds_since(start));
    std::this_thread::sleep_until(start + kDisplay);
    const std::int64_t now = viewer.snapshot().a.state->step;
    if (k < 0 || now == shown) continue;
    shown = now;
    ++pictures;
    if (viewer.snapshot().a.poses) ++away;
    contacts = std::max(contacts, viewer.snapshot().a.report.StepSummary::contacts);
  }
  const double took = seconds_since(begin);
  const double time = viewer.snapshot().a.state->time;
  const std::int64_t step = viewer.snapshot().a.state->step;
  // What is left when nothing moves: the interface, and putting it together with the picture.
  viewer.send(Command(command::Pause{}));
  runner.settle();
  constexpr int kStill = 40;
  for (int k = 0; k < kStill; ++k) viewer.draw(options.width, options.height, 0.1);
  const auto still = Clock::now();
  for (int k = 0; k < kStill; ++k) viewer.draw(options.width, options.height, 0.1);
  const double interface = 1e3 * seconds_since(still) / kStill;
  std::sort(ms.begin(), ms.end());
  fmt::print(
      "{:10} {:5.1f} frames a second, median {:.1f} ms, worst in twenty {:.1f} ms; {:.1f} steps a second, "
      "{:.2f} of real time; "
      "up to {} contacts; {:.1f} ms a frame at rest; {:.1f} new pictures a second, {} of {} from the GPU's "
      "memory\n",
      viewer.snapshot().scene->name, static_cast<double>(ms.size()) / took, ms[ms.size() / 2],
      ms[ms.size() * 19 / 20], static_cast<double>(step - steps) / took, (time - simulated) / took, contacts,
      interface, pictures / took, away, pictures);
  for (const Message& message : viewer.snapshot().messages) fmt::print("{}\n", message.text);
}

// Frames for `seconds` after `what`: the longest ones, and when the first was done.
void watch(Viewer& viewer, const Options& options, const char* what, double seconds) {
  std::vector<double> ms;
  const auto begin = Clock::now();
  for (auto last = begin; ms.empty() || seconds_since(begin) < seconds;) {
    const auto start = Clock::now();
    viewer.draw(options.width, options.height, seconds_since(last));
    // What is queued counts as well.
    Image image;
    viewer.renderer().queue_read();
    viewer.renderer().fetch(image);
    last = start;
    ms.push_back(1e3 * seconds_since(start));
    std::this_thread::sleep_until(start + kDisplay);
  }
  const double first = ms.front();
  std::sort(ms.rbegin(), ms.rend());
  fmt::print("  {:28} first {:6.0f} ms, longest {:6.0f} {:6.0f} {:6.0f} ms, median {:4.0f} ms\n", what, first,
             ms[0], ms[std::min<std::size_t>(1, ms.size() - 1)], ms[std::min<std::size_t>(2, ms.size() - 1)],
             ms[ms.size() / 2]);
}

void measure_first(GlContext& context, const Options& options, const std::string& scene) {
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{}, command::Load{scene, {}, false}));
  context.make_current();
  const auto begin = Clock::now();
  Viewer viewer(context, runner, {});
  fmt::print("{}\n  opening the window {:.0f} ms\n", scene, 1e3 * seconds_since(begin));
  watch(viewer, options, "window opens", 2);
  viewer.send(Command(command::Play{}));
  watch(viewer, options, "play", 4);
  for (const bool on : {false, true}) {
    for (const char* what : {"contacts", "bonds"}) {
      viewer.send(ViewCommand(command::Show{what, on}));
      watch(viewer, options, fmt::format("{} {}", what, on ? "on" : "off").c_str(), 1.5);
    }
  }
  viewer.send(ViewCommand(command::ContactsBy{"force"}));
  watch(viewer, options, "contacts by force", 1.5);
  viewer.send(Command(command::Pause{}));
  watch(viewer, options, "pause", 2);
  fmt::print("  step {}, {} contacts\n", viewer.snapshot().a.state->step,
             viewer.snapshot().a.report.StepSummary::contacts);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  const Options options = parse(argc, argv);
  for (const std::string& scene : options.scenes)
    options.first ? measure_first(*context, options, scene) : measure(*context, options, scene);
}
