// SPDX-License-Identifier: MIT
// See desk_work.h.
#include "app/serve/desk_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/gui/panel.h"
#include "app/serve/clock.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kLeastWidth = 320, kLeastHeight = 240, kMostSide = 4096;
constexpr double kSecondsOfFirst = 1.0 / 60;
constexpr double kMostPixels = 3840.0 * 2400;

const char* word(MouseCursor cursor) {
  switch (cursor) {
    case MouseCursor::text:
      return "ibeam";
    case MouseCursor::cross:
      return "cross";
    case MouseCursor::hand:
      return "hand";
    case MouseCursor::resize_horizontal:
      return "resize_ew";
    case MouseCursor::resize_vertical:
      return "resize_ns";
    case MouseCursor::arrow:
      break;
  }
  return "arrow";
}

const char* word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

std::string scene_name(const Snapshot& sim) {
  const std::string file = std::filesystem::path(sim.scene_path).stem().string();
  return file.empty() ? sim.scene->name : file;
}

double tenth(double x) { return std::round(10 * x) / 10; }

}  // namespace

DeskWork::DeskWork(GlContext& context, Runner& runner, const DeskOptions& options, DeskQueue& queue,
                   const std::function<void(DeskNews)>& on_news)
    : context_(context),
      runner_(runner),
      options_(options),
      queue_(queue),
      on_news_(on_news),
      viewer_(context, runner,
              [this, &options] {
                ViewerOptions out;
                out.shipped_scenes = options.shipped_scenes;
                out.clipboard = [this] { return clipboard_; };
                out.set_clipboard = [this](const std::string& copied) {
                  clipboard_ = copied;
                  send_text({{"t", "clipboard"}, {"text", copied}}, true);
                };
                out.files = options.files;
                out.can_quit = false;
                return out;
              }()),
      stream_([this](VisitorId to, const EncodedFrame& frame) {
        on_news_(desk::Frame{to, frame});
      }),
      width_(options.width),
      height_(options.height),
      files_(options.files->list()) {}

void DeskWork::send_text(const OrderedJson& json, bool control_only) {
  on_news_(desk::Text{json_line(json), control_only});
}

void DeskWork::resize(const desk::Resize& size) {
  width_ = std::clamp(size.width, kLeastWidth, kMostSide);
  height_ = std::clamp(size.height, kLeastHeight, kMostSide);
  const double much = static_cast<double>(width_) * height_ / kMostPixels;
  if (much > 1) {
    width_ = static_cast<int>(width_ / std::sqrt(much));
    height_ = static_cast<int>(height_ / std::sqrt(much));
  }
  viewer_.set_screen_scale(std::clamp(size.scale, 0.5, 4.0));
}

std::string DeskWork::refusal_of_window(int width, int height) {
  if (std::max(width, height) <= kMostSide && static_cast<double>(width) * height <= kMostPixels) return "";
  return fmt::format("a served window has at most {} pixels a side and {:.0f} in all", kMostSide,
                     kMostPixels);
}

// Releases buttons, keys and pulled bodies.
void DeskWork::release_input() {
  for (const MouseButton button : {MouseButton::left, MouseButton::right, MouseButton::middle})
    viewer_.handle(MouseClicked{button, false, {}});
  viewer_.handle(FocusChanged{false});
  viewer_.handle(MouseLeft{});
  for (int i = 0; i < 5; ++i) stamps_.push_back(stamp_);
}

bool DeskWork::take(DeskInput& input) {
  if (const auto* x = std::get_if<desk::Input>(&input)) {
    for (const WindowEvent& event : x->events) {
      viewer_.handle(event);
      stamps_.push_back(x->stamp);
    }
  } else if (const auto* shown = std::get_if<desk::Shown>(&input)) {
    stream_.acknowledge(shown->visitor, shown->frame, shown->ms, seconds_now());
    return false;
  } else if (const auto* arrive = std::get_if<desk::Arrive>(&input)) {
    stream_.arrive(arrive->visitor);
    send_scene();
    send_scheme();
    send_text({{"t", "cursor"}, {"cursor", word(cursor_)}}, true);
  } else if (const auto* scheme = std::get_if<desk::Scheme>(&input)) {
    viewer_.send(ViewCommand(command::Theme{scheme->dark}));
  } else if (const auto* depart = std::get_if<desk::Depart>(&input)) {
    stream_.depart(depart->visitor);
  } else if (const auto* over = std::get_if<desk::HandOver>(&input)) {
    stream_.follow(over->controller);
    release_input();
  } else if (const auto* size = std::get_if<desk::Resize>(&input)) {
    resize(*size);
  } else if (const auto* refresh = std::get_if<desk::Refresh>(&input)) {
    stream_.refresh(refresh->visitor);
  } else if (const auto* uploaded = std::get_if<desk::Uploaded>(&input)) {
    std::erase_if(files_, [&](const FileRoot::Entry& file) { return file.name == uploaded->name; });
    for (const FileRoot::Entry& file : options_.files->list())
      if (file.name == uploaded->name) files_.push_back(file);
    return false;
  } else if (const auto* paste = std::get_if<desk::Paste>(&input)) {
    clipboard_ = paste->text;
    return false;
  } else if (const auto* mode = std::get_if<desk::Choose>(&input)) {
    stream_.choose(mode->mode);
  } else if (const auto* open = std::get_if<desk::Open>(&input)) {
    try {
      viewer_.handle(FilesDropped{{viewer_.file_of(open->name)}});
      stamps_.push_back(stamp_);
    } catch (const Error& error) {
      send_text({{"t", "error"}, {"text", error.what()}}, true);
    }
  } else if (const auto* script = std::get_if<desk::Run>(&input)) {
    run(*script);
  } else if (const auto* state = std::get_if<desk::AskState>(&input)) {
    answer(*state);
  } else if (const auto* picture = std::get_if<desk::AskPicture>(&input)) {
    answer(*picture);
  }
  return true;
}

bool DeskWork::look(bool events) {
  const auto sim = runner_.latest();
  if (events && sim->serial != event_serial_) send_events(*sim);
  event_serial_ = sim->serial;
  const bool changed = sim->serial != seen_;
  seen_ = sim->serial;
  return changed;
}

bool DeskWork::draw() {
  const double began = seconds_now();
  viewer_.draw(width_, height_, last_draw_ > 0 ? began - last_draw_ : kSecondsOfFirst);
  last_draw_ = began;
  return take_frame(began);
}

// Passes the drawn frame to the stream and the accompanying texts to the page.
bool DeskWork::take_frame(double began) {
  while (stamps_.size() > viewer_.waiting_events()) {
    stamp_ = stamps_.front();
    stamps_.pop_front();
  }
  Image image;
  viewer_.renderer().queue_read();
  viewer_.renderer().fetch(image);
  send_changes();
  const double now = seconds_now();
  const Rect& view = viewer_.layout().view;
  const auto x = static_cast<int>(std::floor(view.x)), y = static_cast<int>(std::floor(view.y));
  const PixelRect picture{x, y, static_cast<int>(std::ceil(view.right())) - x,
                          static_cast<int>(std::ceil(view.bottom())) - y};
  return stream_.show(std::move(image), stamp_, 1000 * (now - began), now, picture);
}

void DeskWork::send_changes() {
  if (const MouseCursor cursor = viewer_.cursor(); cursor != cursor_) {
    cursor_ = cursor;
    send_text({{"t", "cursor"}, {"cursor", word(cursor)}}, true);
  }
  if (const bool wants = viewer_.wants_text(); wants != wants_text_) {
    wants_text_ = wants;
    send_text({{"t", "text_input"}, {"on", wants}}, true);
  }
  if (viewer_.snapshot().scene_serial != scene_) send_scene();
  if (viewer_.ui().dark != dark_) send_scheme();
  const auto& messages = viewer_.snapshot().messages;
  if (messages.empty() || messages.back().number == messages_) return;
  messages_ = messages.back().number;
  send_files();
}

void DeskWork::send_scene() {
  scene_ = viewer_.snapshot().scene_serial;
  send_text({{"t", "scene"}, {"scene", scene_name(viewer_.snapshot())}}, false);
}

void DeskWork::send_scheme() {
  dark_ = viewer_.ui().dark;
  send_text({{"t", "scheme"}, {"dark", dark_}}, false);
}

// Announces new and changed files.
void DeskWork::send_files() {
  std::vector<FileRoot::Entry> files = options_.files->list();
  for (const FileRoot::Entry& file : files) {
    if (std::find(files_.begin(), files_.end(), file) == files_.end())
      send_text({{"t", "file"}, {"name", file.name}, {"bytes", file.bytes}}, true);
  }
  files_ = std::move(files);
}

void DeskWork::send_events(const Snapshot& sim) {
  const auto send = [&](const OrderedJson& json) { on_news_(desk::Event{json_line(json)}); };
  if (sim.scene_serial != event_scene_) {
    event_scene_ = sim.scene_serial;
    event_step_ = -1;
    send({{"event", "scene"}, {"name", sim.scene->name}, {"bodies", sim.scene->model.size()}});
  }
  if (sim.playing != event_playing_) {
    event_playing_ = sim.playing;
    send({{"event", sim.playing ? "play" : "pause"}});
  }
  if (sim.a.state->step != event_step_) {
    event_step_ = sim.a.state->step;
    send({{"event", "step"},
          {"step", sim.a.state->step},
          {"time", sim.a.state->time},
          {"iterations", sim.a.report.iterations},
          {"max_penetration", sim.a.report.max_penetration}});
  }
  for (const Message& m : sim.messages) {
    if (m.number <= event_messages_) continue;
    event_messages_ = m.number;
    send({{"event", "message"}, {"severity", word(m.severity)}, {"text", m.text}});
  }
}

void DeskWork::send_stats(double now) {
  const auto stats = stream_.stats(now);
  OrderedJson json = {{"t", "stats"}, {"fps", 0}};
  if (stats) {
    json["fps"] = tenth(stats->fps);
    json["kbps"] = std::round(stats->kbps);
    json["encode_ms"] = tenth(stats->encode_ms);
    json["draw_ms"] = tenth(stats->draw_ms);
    json["quality"] = stats->look.quality;
    json["scale"] = stats->look.scale;
    json["rtt_ms"] = tenth(stats->link_ms);
  }
  if (json != stats_) send_text(json, false);
  stats_ = std::move(json);
}

}  // namespace pabd
