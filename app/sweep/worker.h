// SPDX-License-Identifier: MIT
// Does tasks of a sweep, one after the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/sweep/task_run.h"
#include "render/gl/renderer.h"

namespace pabd {

// What became of a task: it has a result, old or new; another process has it; or it was stopped, with a checkpoint.
enum class TaskEnding { done, diverged, refused, skipped, busy, stopped };
std::string_view to_string(TaskEnding ending);               // "done", …
std::optional<TaskEnding> ending_of(std::string_view word);  // empty: none of them
inline bool has_result(TaskEnding e) { return e < TaskEnding::busy; }

// Draws how runs end, one after the other, in the thread that made it. OpenGL is looked for when the first one is drawn.
class EndPainter {
 public:
  static constexpr int kWidth = 320, kHeight = 180;  // pixels

  // The bytes of a PNG. Empty when there is no OpenGL that can; why() says so then. Precondition: the result has a
  // scene.
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
  // The plan must live as long.
  SweepWorker(const SweepPlan& plan, std::filesystem::path folder, TaskOptions options);

  // Throws what is no result: Error(file), Error(diverged) of the reference.
  TaskEnding run(const SweepTask& task);
  // Why there are no pictures; empty: there are, or none was asked for.
  const std::string& no_picture() const { return painter_.why(); }

 private:
  const SweepPlan& plan_;
  std::filesystem::path folder_;
  TaskOptions options_;
  EndPainter painter_;
};

}  // namespace pabd
