// The middle stage, and what ties the three together.
#include "app/cli/render_pipeline.h"

#include <chrono>

namespace pabd::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

RenderResult render_frames(Session& session, const FrameRange& range, FramePainter& painter, AsyncSink& sink,
                           const InterruptGuard& interrupt, Progress& progress) {
  const auto start = Clock::now();
  RenderResult result;
  Image image;
  FrameProducer producer(
      session, range, [&] { return interrupt.requested(); },
      [&](int frame, const StepReport& report) { progress.update(frame + 1, report); });

  // The copy back of a frame runs while the next one is drawn, so one is always on its way.
  const auto deliver = [&] {
    const auto begin = Clock::now();
    painter.fetch(image);
    result.times.draw += seconds_since(begin);
    sink.write(image);
    ++result.frames;
  };
  while (!interrupt.requested()) {
    auto packet = producer.next();
    if (!packet) break;
    const auto begin = Clock::now();
    painter.draw(*packet);
    result.times.draw += seconds_since(begin);
    if (painter.queued() > 1) deliver();
    progress.update(packet->frame + 1, packet->report);
    producer.recycle(*std::move(packet));
  }
  while (painter.queued() > 0) deliver();
  producer.stop();
  if (result.frames > 0) sink.finish();

  result.diverged = producer.diverged();
  result.times.simulate = producer.busy_seconds();
  result.times.encode = sink.busy_ms() / 1000;
  result.times.total = seconds_since(start);
  return result;
}

}  // namespace pabd::cli
