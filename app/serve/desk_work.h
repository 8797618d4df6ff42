// SPDX-License-Identifier: MIT
// What a served desk does in its thread: inputs into the viewer, frames out of it, scripts, texts for the page.
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
  // The turn is held, and the context current. `hear` gets the news.
  DeskWork(GlContext& context, Runner& runner, const DeskOptions& options, DeskQueue& queue,
           const std::function<void(DeskNews)>& hear);

  // True when the window may look different now. While a script is carried out the queue gives what must not wait, and
  // ends it when it is stopped. The turn is not held.
  bool take(DeskInput& input);

  // Whether the simulation is elsewhere than in the last frame; with `events` says so.
  bool look(bool events);

  // A frame, with the turn held. True when it differs from the last one.
  bool draw();

  void tell_stats(double now);

  Viewer& viewer() { return viewer_; }
  FrameStream& stream() { return stream_; }

 private:
  void resize(const desk::Resize& size);
  static std::string refusal_of_window(int width, int height);  // of one that resize() would make smaller
  void let_go();
  void run(const desk::Run& run);
  void answer(const desk::AskState& ask);
  void answer(const desk::AskPicture& ask);
  bool take_frame(double began);
  void tell_changes();
  void tell_files();
  void tell_scene();
  void tell_scheme();
  void tell_events(const Snapshot& sim);
  void tell(const OrderedJson& json, bool control_only);  // to the pages

  GlContext& context_;
  Runner& runner_;
  DeskOptions options_;
  DeskQueue& queue_;
  const std::function<void(DeskNews)>& hear_;
  std::string clipboard_;
  Viewer viewer_;
  FrameStream stream_;
  int width_, height_;
  double last_draw_ = 0;

  std::deque<std::uint32_t> stamps_;  // of events that the viewer has not taken yet
  std::uint32_t stamp_ = 0;           // newest that it took

  std::uint64_t scene_ = 0;
  std::uint64_t seen_ = 0, event_serial_ = 0, messages_ = 0, event_messages_ = 0, event_scene_ = 0;
  std::int64_t event_step_ = -1;
  bool event_playing_ = false;
  MouseCursor cursor_ = MouseCursor::arrow;
  bool wants_text_ = false;
  bool dark_ = true;
  std::vector<FileRoot::Entry> files_;
  OrderedJson stats_;  // as they were told last
};

}  // namespace pabd
