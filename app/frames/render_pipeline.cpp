// SPDX-License-Identifier: MIT
// The middle stage, and what ties the three together.
#include "app/frames/render_pipeline.h"

#include <chrono>

#include "app/frames/frame_schedule.h"
#include "app/frames/frame_thread.h"

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

RenderResult render_frames(FrameSource& source, AbPainter& painter, AsyncSink& sink,
                           const RenderWatch& watch) {
  const auto start = Clock::now();
  RenderResult result;
  Image image;
  FrameThread frames(source, watch.stop);

  // The copy back of a frame runs while the next one is drawn, so one is always on its way.
  const auto deliver = [&] {
    const auto begin = Clock::now();
    painter.fetch(image);
    result.times.draw += seconds_since(begin);
    sink.take(image);
    ++result.frames;
  };
  while (!watch.stop()) {
    const auto frame = frames.next(true);
    if (!frame) break;
    const auto begin = Clock::now();
    painter.draw(*frame);
    result.times.draw += seconds_since(begin);
    if (painter.queued() > 1) deliver();
    watch.progress(frame->number + 1, frame->a.report);
  }
  while (painter.queued() > 0) deliver();
  frames.stop();
  if (result.frames > 0) sink.finish();

  result.times.simulate = frames.busy_seconds();
  result.times.encode = sink.busy_ms() / 1000;
  result.times.total = seconds_since(start);
  return result;
}

SinkOptions sink_options(const FrameView& start, const PngText& common, const FrameRange& range, int width,
                         int height, int first_written) {
  SinkOptions options;
  options.width = width;
  options.height = height;
  options.fps = range.fps;
  options.first_frame = first_written;
  options.about = common;
  const double start_time = start.state.time;
  const double h = start.params.h;
  // A still is the only frame that its file sees, but not the first one of the run.
  const int skipped = range.first - first_written;
  options.png_text = [common, start_time, h, skipped, fps = range.fps](int written) {
    const int frame = written + skipped;
    return frame_text(common, frame, start_time + h * static_cast<double>(step_of_frame(frame, fps, h)));
  };
  return options;
}

}  // namespace pabd
