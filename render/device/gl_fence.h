// SPDX-License-Identifier: MIT
// A place in the commands of a context, to wait for. It deletes itself; the context, or one that shares with it, must be
// current when it is made and when it goes.
#pragma once

#include <utility>

#include "render/device/compute_functions.h"
#include "sim/base/error.h"

namespace pabd {

class GlFence {
 public:
  // None yet.
  GlFence() = default;
  // Behind all that was asked for so far.
  explicit GlFence(const ComputeFunctions& gl)
      : gl_(&gl), sync_(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {}
  ~GlFence() {
    if (sync_) gl_->DeleteSync(sync_);
  }
  GlFence(GlFence&& other) noexcept : gl_(other.gl_), sync_(std::exchange(other.sync_, nullptr)) {}
  GlFence& operator=(GlFence&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(sync_, other.sync_);
    return *this;
  }

  // Whether the GPU has passed it. Precondition: there is one. Throws Error(no_context) when the GPU was lost.
  bool passed() const { return look(0, 0); }
  // Throws as passed().
  void wait() const {
    while (!look(GL_SYNC_FLUSH_COMMANDS_BIT, 100'000'000)) {
    }
  }

 private:
  bool look(GLbitfield flags, GLuint64 ns) const {
    const GLenum state = gl_->ClientWaitSync(sync_, flags, ns);
    if (state == GL_WAIT_FAILED) throw Error(ErrorKind::no_context, "the GPU was lost: --device cpu");
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
  }

  const ComputeFunctions* gl_ = nullptr;
  GLsync sync_ = nullptr;
};

}  // namespace pabd
