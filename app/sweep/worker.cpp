// SPDX-License-Identifier: MIT
// See worker.h.
#include "app/sweep/worker.h"

#include <algorithm>
#include <array>
#include <utility>

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
