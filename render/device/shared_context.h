// SPDX-License-Identifier: MIT
// What whoever draws lends to whoever makes steps on the GPU: a context with the same buffers, so that bodies are drawn
// from where a step leaves them.
#pragma once

#include <memory>
#include <mutex>

#include "render/context/context.h"
#include "render/device/pose_copies.h"

namespace pabd {

// Any thread may use it.
class SharedContext {
 public:
  // One that shares with `drawer`, which is current; none where that cannot run compute shaders or be shared. At most once,
  // in the thread that may call GlContext::share. Engines that were opened before have contexts of their own.
  void put_beside(GlContext& drawer);

  struct Lent {
    std::shared_ptr<GlContext>
        context;  // comes back when it is let go; null: there is none, or somebody has it
    std::shared_ptr<PoseCopies> copies;  // of its group
  };
  Lent take();
  // The context goes, in this thread. Precondition: nobody has it.
  void drop();

 private:
  struct Place {
    std::mutex mutex;
    std::unique_ptr<GlContext> context;
  };
  std::shared_ptr<Place> place_ = std::make_shared<Place>();
  std::shared_ptr<PoseCopies> copies_ = std::make_shared<PoseCopies>();
};

}  // namespace pabd
