// SPDX-License-Identifier: MIT
// A display that goes away: Xlib ends the program then, unless it is asked not to.
#pragma once

#include <atomic>
#include <memory>

#include "render/context/shared_library.h"

namespace pabd {

// To be made before GLFW is initialised: until opened() a broken connection to the X server ends the program
// with `exit_status` and a line. After that it sets lost(). watch() once GLFW is there. Where the window
// system is another one, or Xlib is older than 1.7, it does nothing. GLFW must be shut down before this goes,
// unless the display is lost. One at a time.
class DisplayLoss {
 public:
  explicit DisplayLoss(int exit_status);
  ~DisplayLoss();
  DisplayLoss(const DisplayLoss&) = delete;
  DisplayLoss& operator=(const DisplayLoss&) = delete;

  void watch();
  void opened();
  bool lost() const { return *lost_; }

 private:
  SharedLibrary xlib_;
  std::unique_ptr<std::atomic<bool>> lost_ = std::make_unique<std::atomic<bool>>(false);
};

}  // namespace pabd
