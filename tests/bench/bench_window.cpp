// SPDX-License-Identifier: MIT
// The window while a scene plays, without a display: frames a second, their parts, and how fast the simulation goes
// beside it.
//
//     bench_window [SCENE…]    (default pyramid pile, contacts shown, 1280×720, 300 frames after the first 30)
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "app/gui/viewer.h"
#include "render/context/context.h"

namespace {

using namespace pabd;
using Clock = std::chrono::steady_clock;

constexpr int kWidth = 1280, kHeight = 720, kFrames = 300, kWarm = 30;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void measure(GlContext& context, const std::string& name) {
  Runner runner(std::make_unique<Workbench>(WorkbenchOptions{},
                                            command::Load{PABD_SCENES "/" + name + ".json", {}, false}));
  Viewer viewer(context, runner, {});
  viewer.send(ViewCommand(command::Show{"contacts", true}));
  viewer.send(Command(command::Play{}));
  std::vector<double> ms;
  double simulated = 0;
  std::int64_t steps = 0;
  int contacts = 0;
  Clock::time_point begin{}, last = Clock::now();
  for (int k = -kWarm; k < kFrames; ++k) {
    if (k == 0) {
      begin = Clock::now();
      simulated = viewer.snapshot().a.state.time;
      steps = viewer.snapshot().a.state.step;
    }
    const auto start = Clock::now();
    viewer.draw(kWidth, kHeight, seconds_since(last));
    last = start;
    if (k >= 0) ms.push_back(1e3 * seconds_since(start));
    contacts = std::max(contacts, viewer.snapshot().a.report.StepSummary::contacts);
  }
  const double took = seconds_since(begin);
  const double time = viewer.snapshot().a.state.time;
  const std::int64_t step = viewer.snapshot().a.state.step;
  // What is left when nothing moves: the interface, and putting it together with the picture.
  viewer.send(Command(command::Pause{}));
  runner.settle();
  constexpr int kStill = 40;
  for (int k = 0; k < kStill; ++k) viewer.draw(kWidth, kHeight, 0.1);
  const auto still = Clock::now();
  for (int k = 0; k < kStill; ++k) viewer.draw(kWidth, kHeight, 0.1);
  const double interface = 1e3 * seconds_since(still) / kStill;
  std::sort(ms.begin(), ms.end());
  fmt::print(
      "{:10} {:5.1f} frames a second, median {:.1f} ms, worst in twenty {:.1f} ms; {:.1f} steps a second, "
      "{:.2f} of real time; "
      "up to {} contacts; {:.1f} ms a frame at rest\n",
      name, kFrames / took, ms[ms.size() / 2], ms[ms.size() * 19 / 20],
      static_cast<double>(step - steps) / took, (time - simulated) / took, contacts, interface);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"pyramid", "pile"};
  for (const std::string& name : names) measure(*context, name);
}
