// SPDX-License-Identifier: MIT
// The work of a desk's thread: passes inputs to the viewer and frames to the stream, runs scripts, sends texts.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "app/gui/viewer.h"
#include "app/serve/desk_queue.h"
#include "app/serve/frame_stream.h"

namespace pabd {

class DeskWork {
 public:
  // Precondition: the turn is held and the context is current. `on_news` receives the news.
  DeskWork(GlContext& context, Runner& runner, const DeskOptions& options, DeskQueue& queue,
           const std::function<void(DeskNews)>& on_news);

  // True when the window may look different now. While a script runs, urgent inputs are taken from the queue, and
  // stopping the queue ends the script. Precondition: the turn is not held.
  bool take(DeskInput& input);

  // Whether the simulation has changed since the last call; with `events` the changes are sent as events.
  bool look(bool events);

  // Draws a frame. Precondition: the turn is held. True when it differs from the last one.
  bool draw();

  void send_stats(double now);

  Viewer& viewer() { return viewer_; }
  FrameStream& stream() { return stream_; }

 private:
  void resize(const desk::Resize& size);
  static std::string refusal_of_window(int width,
                                       int height);  // for a size that resize() would reduce; empty: it fits
  void release_input();
  void run(const desk::Run& run);
  void answer(const desk::AskState& ask);
  void answer(const desk::AskPicture& ask);
  bool take_frame(double began);
  void send_changes();
  void send_files();
  void send_scene();
  void send_scheme();
  void send_events(const Snapshot& sim);
  void send_text(const OrderedJson& json, bool control_only);  // to the pages

  GlContext& context_;
  Runner& runner_;
  DeskOptions options_;
  DeskQueue& queue_;
  const std::function<void(DeskNews)>& on_news_;
  std::string clipboard_;
  Viewer viewer_;
  FrameStream stream_;
  int width_, height_;
  double last_draw_ = 0;

  std::deque<std::uint32_t> stamps_;  // of events that the viewer has not processed yet
  std::uint32_t stamp_ = 0;           // newest that it processed

  std::uint64_t scene_ = 0;
  std::uint64_t seen_ = 0, event_serial_ = 0, messages_ = 0, event_messages_ = 0, event_scene_ = 0;
  std::int64_t event_step_ = -1;
  bool event_playing_ = false;
  MouseCursor cursor_ = MouseCursor::arrow;
  bool wants_text_ = false;
  bool dark_ = true;
  std::vector<FileRoot::Entry> files_;
  OrderedJson stats_;  // as last sent
};

}  // namespace pabd
