// SPDX-License-Identifier: MIT
// The render pipeline: three stages that overlap.
//
//     simulating (FrameThread) → drawing (the caller's thread, which has the GL context)
//                              → encoding and writing (AsyncSink, a thread)
//
// The queues between them are short: a slow stage blocks those before it. When a GPU makes the steps and draws them from
// its own memory, the first two stages are one.
#pragma once

#include "app/frames/device_film.h"
#include "app/frames/frame_source.h"
#include "app/frames/frame_text.h"
#include "app/frames/runs_painter.h"
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
  StageTimes times;
};

// Called while frames are made; both may be called from any thread.
struct RenderWatch {
  std::function<bool()> stop;  // asked often: true ends the run with the frames that are whole
  std::function<void(int frames, const StepSummary& step)> progress;  // so many are simulated or drawn
};

// Renders the frames of a source and publishes the output, also when it is stopped early, with the frames that are
// complete. Frames before `first` are looked at, but not drawn. Throws what a stage threw.
RenderResult render_frames(FrameSource& source, RunsPainter& painter, AsyncSink& sink,
                           const RenderWatch& watch, int first = 0);

// The same for a film, whose steps are made in the caller's thread between the pictures.
RenderResult render_film(DeviceFilm& film, RunsPainter& painter, AsyncSink& sink, const RenderWatch& watch);

// Options of the sink for these frames: size, speed, and the text of every PNG (`common`). `start` is what frame 0
// shows. Frames are written from `first_written` on (0: those before `range.first` are simulated, but not written).
SinkOptions sink_options(const FrameView& start, const PngText& common, const FrameRange& range, int width,
                         int height, int first_written = 0);

}  // namespace pabd
