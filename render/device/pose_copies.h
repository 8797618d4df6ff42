// SPDX-License-Identifier: MIT
// Where bodies were after a step, in buffers of their own: whoever draws has them as long as it likes while steps go on,
// in another context that shares them (GlContext::share).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "render/device/compute_functions.h"
#include "sim/solver/step_engine.h"

namespace pabd {

class GlPoses;

// Of one group of contexts. Any thread may use it; buffers that are let go are used again, and go with their contexts.
class PoseCopies {
 public:
  // Of `bytes` bytes of a buffer, once what was asked for before is done. A context of the group is current; waits for
  // nothing.
  std::shared_ptr<const GlPoses> copy(const ComputeFunctions& gl, GLuint from, std::size_t bytes);

 private:
  friend class GlPoses;
  struct Buffer {
    GLuint id = 0;
    std::size_t bytes = 0;
    GLsync copied = nullptr;
    GLsync drawn = nullptr;  // null: nobody drew from it
  };
  struct Shelf {
    std::mutex mutex;
    std::vector<Buffer> free;
  };
  Buffer take(const ComputeFunctions& gl, std::size_t bytes);

  std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
};

class GlPoses : public PoseCopy {
 public:
  GlPoses(std::shared_ptr<PoseCopies::Shelf> shelf, const PoseCopies::Buffer& buffer)
      : shelf_(std::move(shelf)), buffer_(buffer) {}
  ~GlPoses() override;
  GlPoses(const GlPoses&) = delete;
  GlPoses& operator=(const GlPoses&) = delete;

  // GL name, as of DeviceSolver::pose_buffer(). For one thread at a time, whose context is current: what draws from it is
  // asked for between the two calls. Neither waits; the GPU does.
  GLuint begin(const ComputeFunctions& gl) const;
  void end(const ComputeFunctions& gl) const;

 private:
  std::shared_ptr<PoseCopies::Shelf> shelf_;
  mutable PoseCopies::Buffer buffer_;
};

}  // namespace pabd
