// The render pipeline: three stages that overlap.
//
//     simulating (FrameProducer, a thread) → drawing (the caller's thread, which has the GL context)
//                                          → encoding and writing (AsyncSink, a thread)
//
// The queues between them are short: a slow stage holds back those before it.
#pragma once

#include "app/frames/frame_painter.h"
#include "app/frames/frame_producer.h"
#include "app/frames/frame_text.h"
#include "render/output/async_sink.h"

namespace pabd {

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
  bool in_b = false;  // it was the second run that diverged
  StageTimes times;
};

// Called while frames are made; both may be called from any thread.
struct RenderWatch {
  std::function<bool()> stop;  // asked often: true ends the run with the frames that are whole
  std::function<void(int frames, const StepReport& report)> progress;  // so many are simulated or drawn
};

// Renders the frames of `range` and publishes the output; when stopped or diverged, with the frames that are
// whole by then. Throws what a stage threw. `b`: a second run beside the first (AbPainter), or null.
RenderResult render_frames(Session& session, const FrameRange& range, FrameDrawer& painter, AsyncSink& sink,
                           const RenderWatch& watch, Session* b = nullptr);

// The sink for these frames: size, speed, and in every PNG where it came from (`common`). `session` is at the
// state of frame 0. Frames are written from `first_written` on (0: those before `range.first` are part of the
// run, but not of the output).
SinkOptions sink_options(const Session& session, const PngText& common, const FrameRange& range, int width,
                         int height, int first_written = 0);

}  // namespace pabd
