// SPDX-License-Identifier: MIT
// Does tasks of a sweep, one after another.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/sweep/task_run.h"
#include "render/gl/renderer.h"

namespace pabd {

// done … skipped: it has a result, new or old; busy: another process has it; stopped: it wrote its checkpoint.
enum class TaskEnding { done, diverged, refused, skipped, busy, stopped };
std::string_view to_string(TaskEnding ending);               // "done", …
std::optional<TaskEnding> ending_of(std::string_view word);  // empty: none of them
inline bool has_result(TaskEnding e) { return e < TaskEnding::busy; }

// Draws the ends of runs, in the thread that made it. Creates its OpenGL context for the first one.
class EndPainter {
 public:
  static constexpr int kWidth = 320, kHeight = 180;  // pixels

  // A PNG. Empty: there is no usable OpenGL, and why() gives the reason. Precondition: the result has a scene.
  std::vector<std::uint8_t> draw(const TaskResult& result, const std::string& hash);
  const std::string& why() const { return why_; }

 private:
  bool ready();

  std::unique_ptr<GlContext> context_;
  std::unique_ptr<Renderer> renderer_;
  std::string why_;
};

class SweepWorker {
 public:
  // The plan must outlive the worker.
  SweepWorker(const SweepPlan& plan, std::filesystem::path folder, TaskOptions options);

  // Throws Error(file), and Error(diverged) of the reference.
  TaskEnding run(const SweepTask& task);
  // Why there are no pictures; empty: none is missing.
  const std::string& no_picture() const { return painter_.why(); }

 private:
  const SweepPlan& plan_;
  std::filesystem::path folder_;
  TaskOptions options_;
  EndPainter painter_;
};

}  // namespace pabd
