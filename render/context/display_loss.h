// A display that goes away: Xlib ends the program then, unless it is asked not to.
#pragma once

#include <atomic>
#include <memory>

#include "render/context/shared_library.h"

namespace pabd {

// From its making on, a broken connection to the X server sets lost() instead of ending the program. Where
// the window system is another one, or Xlib is older than 1.7, it does nothing. GLFW must be initialised
// before, and be shut down before this goes, unless the display is lost.
class DisplayLoss {
 public:
  DisplayLoss();
  ~DisplayLoss();
  DisplayLoss(const DisplayLoss&) = delete;
  DisplayLoss& operator=(const DisplayLoss&) = delete;

  bool lost() const { return *lost_; }

 private:
  SharedLibrary xlib_;
  std::unique_ptr<std::atomic<bool>> lost_ = std::make_unique<std::atomic<bool>>(false);
};

}  // namespace pabd
