// SPDX-License-Identifier: MIT
// See worker.h.
#include "app/sweep/worker.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/frames/scene_framing.h"
#include "app/frames/thumbnail.h"
#include "render/output/png.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr std::array<std::string_view, 6> kWords = {"done",    "diverged", "refused",
                                                    "skipped", "busy",     "stopped"};

}  // namespace

std::string_view to_string(TaskEnding ending) { return kWords[static_cast<std::size_t>(ending)]; }

std::optional<TaskEnding> ending_of(std::string_view word) {
  const auto found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end()) return std::nullopt;
  return static_cast<TaskEnding>(found - kWords.begin());
}

bool EndPainter::ready() {
  if (renderer_ || !why_.empty()) return why_.empty();
  try {
    std::vector<ContextAttempt> attempts;
    context_ = create_headless_context(Backend::automatic, attempts);
    renderer_ = std::make_unique<Renderer>(*context_, 2 * kWidth, 2 * kHeight);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    why_ = error.what();
  }
  return why_.empty();
}

std::vector<std::uint8_t> EndPainter::draw(const TaskResult& result, const std::string& hash) {
  if (!ready()) return {};
  const Camera camera = scene_camera(*result.scene, result.end, static_cast<double>(kWidth) / kHeight);
  const Image image = draw_small(*renderer_, *result.scene, result.end, camera, kWidth, kHeight);
  return encode_png(image,
                    {{"Software", "pabd " PABD_VERSION}, {"Sweep task", hash}, {"Status", result.status}});
}

SweepWorker::SweepWorker(const SweepPlan& plan, std::filesystem::path folder, TaskOptions options)
    : plan_(plan), folder_(std::move(folder)), options_(std::move(options)) {}

TaskEnding SweepWorker::run(const SweepTask& task) {
  auto place = TaskFolder::take(folder_, task);
  if (!place) return TaskEnding::busy;
  if (place->was_done()) return TaskEnding::skipped;
  const auto result = run_task(plan_, task, place->checkpoint(), options_);
  if (!result) return TaskEnding::stopped;
  if (plan_.picture && result->scene) {
    const std::vector<std::uint8_t> png = painter_.draw(*result, task.hash);
    if (!png.empty()) place->write("end.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  }
  write_result(*place, task, *result, options_.threads);
  place->publish();
  return ending_of(result->status).value_or(TaskEnding::done);
}

}  // namespace pabd
