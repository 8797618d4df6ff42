// SPDX-License-Identifier: MIT
// The picture of how a run of a sweep ended.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/sweep/task_run.h"
#include "render/gl/renderer.h"

namespace pabd {

// Draws many, one after the other, in the thread that made it. OpenGL is looked for when the first one is drawn.
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

}  // namespace pabd
