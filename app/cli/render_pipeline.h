// The render pipeline: three stages that overlap.
//
//     simulating (FrameProducer, a thread) → drawing (the caller's thread, which has the GL context)
//                                          → encoding and writing (AsyncSink, a thread)
//
// The queues between them are short: a slow stage holds back those before it.
#pragma once

#include "app/cli/frame_painter.h"
#include "app/cli/frame_producer.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "render/output/async_sink.h"

namespace pabd::cli {

// Seconds that each stage worked, and the wall clock over all.
struct StageTimes {
  double simulate = 0;
  double draw = 0;
  double encode = 0;
  double total = 0;
};

struct RenderResult {
  int frames = 0;  // written
  bool diverged = false;
  StageTimes times;
};

// Renders the frames of `range` and publishes the output; when interrupted or diverged, with the frames that
// are whole by then. Throws what a stage threw.
RenderResult render_frames(Session& session, const FrameRange& range, FramePainter& painter, AsyncSink& sink,
                           const InterruptGuard& interrupt, Progress& progress);

}  // namespace pabd::cli
