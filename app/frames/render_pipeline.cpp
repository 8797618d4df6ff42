// SPDX-License-Identifier: MIT
// The middle stage, and what ties the three together.
#include "app/frames/render_pipeline.h"

#include <chrono>

#include "app/frames/frame_thread.h"
#include "app/session/step_at_time.h"

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// `next`: the frame to be drawn, none after the last one. `draw` starts copying its picture back. `result` gets the frames and
// how long drawing took.
template <class Next, class Draw>
void draw_frames(const Next& next, const Draw& draw, RunsPainter& painter, AsyncSink& sink,
                 const RenderWatch& watch, RenderResult& result) {
  Image image;

  // The copy back of a frame runs while the next one is drawn, so one is always on its way.
  const auto deliver = [&] {
    const auto begin = Clock::now();
    painter.fetch(image);
    result.times.draw += seconds_since(begin);
    sink.take(image);
    ++result.frames;
  };
  while (!watch.stop()) {
    const auto frame = next();
    if (!frame) break;
    const auto begin = Clock::now();
    draw(*frame);
    result.times.draw += seconds_since(begin);
    if (painter.queued() > 1) deliver();
    watch.progress(frame->number + 1, frame->a().report);
  }
  while (painter.queued() > 0) deliver();
}

// With what is known at the end.
RenderResult finished(RenderResult result, AsyncSink& sink, Clock::time_point start, double simulated) {
  if (result.frames > 0) sink.finish();
  result.times.simulate = simulated;
  result.times.encode = sink.busy_ms() / 1000;
  result.times.total = seconds_since(start);
  return result;
}

}  // namespace

RenderResult render_frames(FrameSource& source, RunsPainter& painter, AsyncSink& sink,
                           const RenderWatch& watch, int first) {
  const auto start = Clock::now();
  RenderResult result;
  FrameThread frames(source, watch.stop);
  const auto next = [&] {
    auto frame = frames.next(true);
    while (frame && frame->number < first && !watch.stop()) {
      painter.look_at(*frame);
      watch.progress(frame->number + 1, frame->a().report);
      frame = frames.next(true);
    }
    return frame;
  };
  draw_frames(
      next, [&](const Frame& frame) { painter.draw(frame); }, painter, sink, watch, result);
  frames.stop();
  return finished(result, sink, start, frames.busy_seconds());
}

RenderResult render_film(DeviceFilm& film, RunsPainter& painter, AsyncSink& sink, const RenderWatch& watch) {
  const auto start = Clock::now();
  RenderResult result;
  double simulated = 0;
  const auto next = [&] {
    const auto begin = Clock::now();
    auto frame = film.next(watch.stop);
    simulated += seconds_since(begin);
    return frame;
  };
  const auto draw = [&](const Frame& frame) {
    const BodiesOnDevice bodies = film.bodies();
    painter.draw(frame, &bodies);
  };
  draw_frames(next, draw, painter, sink, watch, result);
  return finished(result, sink, start, simulated);
}

SinkOptions sink_options(const FrameView& start, const PngText& common, const FrameRange& range, int width,
                         int height, int first_written) {
  SinkOptions options;
  options.width = width;
  options.height = height;
  options.fps = range.fps;
  options.first_frame = first_written;
  options.about = common;
  const double start_time = start.state->time;
  const double h = start.params.h;
  // A still is the only frame that its file sees, but not the first one of the run.
  const int skipped = range.first - first_written;
  options.png_text = [common, start_time, h, skipped, range](int written) {
    const int frame = written + skipped;
    const double time = range.time(frame);
    return frame_text(
        common, frame,
        start_time + (range.pace.is_real_time() ? h * static_cast<double>(steps_until(time, h)) : time));
  };
  return options;
}

}  // namespace pabd
