// SPDX-License-Identifier: MIT
// Frames of a session, simulated as they are asked for: with the details of each step that the session is told to report.
// They show the steps that LiveSource's do.
#pragma once

#include "app/frames/frame_source.h"
#include "app/session/session.h"

namespace pabd {

class SessionSource : public FrameSource {
 public:
  // Frames 0 to count − 1, the first of them where the session is.
  SessionSource(Session session, std::int64_t count, double fps, Stepped stepped = {});

  std::optional<Frame> next(const Stop& stop) override;

  // The step that left the numbers; none: none did.
  const std::optional<StepSummary>& diverged() const { return diverged_; }

 private:
  Session session_;
  std::int64_t count_, next_ = 0;
  double fps_;
  Stepped stepped_;
  std::int64_t first_step_;  // a state to continue from may be at any step
  std::optional<StepSummary> diverged_;
};

}  // namespace pabd
