// SPDX-License-Identifier: MIT
// The bar along the bottom: play, step, speed, and every moment of the past to go back to.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/device_words.h"
#include "app/gui/panels.h"
#include "app/gui/track_events.h"
#include "app/gui/widgets.h"
#include "sim/base/counted.h"

namespace pabd {
namespace {

constexpr double kGrip = 6;                   // pixels beside the playhead where it can be taken hold of
constexpr double kShortest = 1e-3;            // s: of the track
constexpr double kSmall = 10.5;               // pixels: text on the track
constexpr double kMark = 4.5, kBeside = 6.5;  // pixels: half of a mark, and from it to its name
constexpr double kRoomForName = 110;          // pixels between two times
constexpr double kNarrow = 440;               // pixels: a telephone's screen
constexpr double kSpeeds[] = {0.01, 0.1, 0.25, 0.5, 1, 2, 0};

// `brief`: where there is little room.
std::string speed_text(double factor, bool brief = false) {
  if (brief) return factor == 0 ? "fastest" : fmt::format("{:g}×", factor);
  return factor == 0 ? "as fast as it goes" : fmt::format("{:g}× real time", factor);
}

// The next of 1, 2, 5, 10, … times a power of ten.
double time_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(std::max(least, 1e-4))));
  for (const double part : {1.0, 2.0, 5.0}) {
    if (part * power >= least * (1 - 1e-9)) return part * power;
  }
  return 10 * power;
}
int decimals(double step) { return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))); }

struct Track {
  ImVec2 lo, hi;
  double t0, t1;
  float x(double t) const {
    return lo.x + static_cast<float>((t - t0) / std::max(t1 - t0, 1e-9)) * (hi.x - lo.x);
  }
  double time(float px) const {
    return t0 + (t1 - t0) * std::clamp(static_cast<double>((px - lo.x) / (hi.x - lo.x)), 0.0, 1.0);
  }
};

// Penetrations as ticks, one a pixel column at most.
void draw_marks(const GuiFrame& f, const Track& track, const Reports& history, ImDrawList& list) {
  float last = -1;
  for (const StepSummary& r : history) {
    if (r.max_penetration <= 0) continue;
    const float x = std::floor(track.x(r.time));
    if (x == last) continue;
    last = x;
    list.AddRectFilled({x, track.hi.y - f.px(4)}, {x + std::max(1.0f, f.px(1)), track.hi.y},
                       packed(f.theme().color(1)));
  }
}

// Times along the track, as far apart as their labels need, with names farther. Returns where they stand.
std::vector<Span> draw_times(const GuiFrame& f, const Track& track, bool names, ImDrawList& list) {
  std::vector<Span> out;
  const ImFont* font = f.fonts.font(kSmall * f.unit);
  if (font == nullptr || track.t1 - track.t0 < 2 * kShortest) return out;  // no step yet
  const float width =
      font->CalcTextSizeA(font->FontSize, 1e4f, 0, "00.00 s").x + f.px(names ? kRoomForName : 20);
  const double step =
      time_step((track.t1 - track.t0) * static_cast<double>(width / (track.hi.x - track.lo.x)));
  const ImU32 ink = packed(f.theme().muted);
  const float y = std::round(0.5f * (track.lo.y + track.hi.y - font->FontSize));
  for (double k = std::ceil(track.t0 / step - 1e-9); k * step <= track.t1 + 1e-9 * step; ++k) {
    const float x = std::round(track.x(k * step));
    const std::string text = fmt::format("{:.{}f} s", k * step + 0.0, decimals(step)) /* no −0 */;
    list.AddRectFilled({x, track.hi.y - f.px(7)}, {x + std::max(1.0f, f.px(1)), track.hi.y}, ink);
    const float end = x + f.px(4) + font->CalcTextSizeA(font->FontSize, 1e4f, 0, text.c_str()).x;
    if (end <= track.hi.x) list.AddText(font, font->FontSize, {x + f.px(4), y}, ink, text.c_str());
    if (end <= track.hi.x) out.push_back({x - f.px(2), end + f.px(6)});
  }
  return out;
}

// Names of what happened where there is room between the times, which `taken` are.
void draw_names(const GuiFrame& f, const Track& track, const std::vector<TrackEvent>& events,
                std::vector<Span> taken, ImDrawList& list) {
  const ImFont* font = f.fonts.font(kSmall * f.unit);
  if (font == nullptr) return;
  const auto width = [&](const std::string& text) {
    return font->CalcTextSizeA(font->FontSize, 1e4f, 0, text.c_str()).x;
  };
  std::vector<NameAt> names;
  for (const TrackEvent& event : events) {
    const float x = std::round(track.x(event.time));
    names.push_back({x, width(event.name), event.brief.empty() ? 0 : width(event.brief)});
    if (event.marked) taken.push_back({x - f.px(kMark), x + f.px(kMark)});  // as high as the track
    if (!event.marked)
      list.AddRectFilled({x, track.lo.y}, {x + std::max(1.0f, f.px(1)), track.lo.y + f.px(7)},
                         packed(event.warning ? f.theme().color(1) : f.theme().text));
  }
  const float y = std::round(0.5f * (track.lo.y + track.hi.y - font->FontSize));
  for (const PlacedName& placed : place_names(names, taken, {track.lo.x, track.hi.x}, f.px(kBeside))) {
    const TrackEvent& event = events[placed.number];
    list.AddText(font, font->FontSize, {std::round(placed.left), y},
                 packed(event.warning ? f.theme().color(1) : f.theme().text),
                 (placed.brief ? event.brief : event.name).c_str());
  }
}

// What happened about a place of the track, in words; pixels.
std::string events_at(const GuiFrame& f, const Track& track, const std::vector<TrackEvent>& events, float x) {
  const auto near = [&](double time) { return std::abs(track.x(time) - x) <= f.px(kGrip); };
  std::string out;
  const auto say = [&](const std::string& words) { out += "\n" + words; };
  for (const TrackEvent& event : events) {
    if (near(event.time)) say(event.words);
  }
  double deepest = 0;
  std::int64_t unsolved = 0, halved = 0;
  int halvings = 0;
  for (const StepSummary& r : f.sim.a.history) {
    if (std::abs(track.x(r.time) - x) > f.px(1.5)) continue;
    deepest = std::max(deepest, r.max_penetration);
    unsolved += r.status == StepStatus::iteration_limit ? 1 : 0;
    halved += r.halved_bodies > 0 ? 1 : 0;
    halvings = std::max(halvings, r.halvings);
  }
  if (deepest > 0) say(fmt::format("bodies overlap by {:.3g} m", deepest));
  if (unsolved > 0) say(counted(unsolved, "step") + " ended at the iteration limit");
  if (halved > 0) say(fmt::format("{} made again in up to {} parts", counted(halved, "step"), 1 << halvings));
  return out;
}

void draw_flag(const GuiFrame& f, const Track& track, double time, Color color, ImDrawList& list) {
  const float x = std::round(track.x(time));
  list.AddRectFilled({x, track.lo.y}, {x + f.px(1.5), track.hi.y}, packed(color));
  list.AddTriangleFilled({x, track.lo.y}, {x + f.px(7), track.lo.y + f.px(3.5)}, {x, track.lo.y + f.px(7)},
                         packed(color));
}

// At the right end: who makes the steps, and what is kept of them, as far as there is room.
void draw_kept(const GuiFrame& f) {
  const std::size_t moments = f.sim.a.history.size();
  const std::string kept =
      f.sim.a.gone > 0 ? fmt::format(", {} kept", moments - std::min(f.sim.a.gone, moments)) : "";
  const std::string memory = fmt::format("{}{}, {:.0f} of {:.0f} MB", counted(moments, "moment"), kept,
                                         static_cast<double>(f.sim.timeline_bytes) / 1e6,
                                         static_cast<double>(f.sim.timeline_budget) / 1e6);
  const std::string device = device_words(f.sim);
  const float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + f.px(12);
  std::string text;
  for (const std::string& words : {device.empty() ? memory : device + " · " + memory, device}) {
    if (words.empty() ||
        ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(ui_text(words).c_str()).x <= left)
      continue;
    text = words;
    break;
  }
  if (text.empty()) return;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(ui_text(text).c_str()).x);
  muted_label(f, text);
  tooltip(
      device.empty() && kept.empty()
          ? "Older states are thinned out when the memory is full, and computed again when they are needed"
          : device_story(f.sim) +
                "\nWhat a GPU made is not computed again: when the memory is full, every so many of the "
                "older "
                "states are kept, and those are what one can go back to");
}

}  // namespace

void TimelineBar::draw(GuiFrame& f) {
  const Reports& history = f.sim.a.history;
  const double now = f.sim.a.state->time;
  if (icon_button(f, "restart", "From the beginning, with the present parameters (r)"))
    f.out.send(Command(command::Restart{}));
  ImGui::SameLine();
  if (icon_button(f, "back", "One step back (←)", f.sim.a.cursor > 0)) f.out.send(Command(command::Step{-1}));
  ImGui::SameLine();
  if (icon_button(f, f.sim.playing ? "pause" : "play", f.sim.playing ? "Pause (space)" : "Play (space)")) {
    if (f.sim.playing) {
      f.out.send(Command(command::Pause{}));
    } else {
      f.out.send(Command(command::Play{}));
    }
  }
  ImGui::SameLine();
  if (icon_button(f, "forward", "One step forward (→)")) f.out.send(Command(command::Step{1}));
  ImGui::SameLine();
  const bool narrow = ImGui::GetContentRegionMax().x < f.px(kNarrow);
  ImGui::SetNextItemWidth(f.px(narrow ? 78 : 146));
  if (ImGui::BeginCombo("##speed", speed_text(f.sim.speed, narrow).c_str())) {
    for (const double factor : kSpeeds) {
      if (ImGui::Selectable(speed_text(factor).c_str(), factor == f.sim.speed))
        f.out.send(Command(command::Speed{factor}));
    }
    ImGui::EndCombo();
  }
  tooltip("How fast it plays");
  ImGui::SameLine(0, f.px(narrow ? 8 : 16));
  // As wide for every number of up to so many digits: what follows stays where it is.
  const float time_left = ImGui::GetCursorPosX();
  label(fmt::format("{:.3f} s", now));
  ImGui::SameLine(std::max(time_left + ImGui::CalcTextSize("000.000 s").x,
                           ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x) +
                  ImGui::GetStyle().ItemSpacing.x);
  const std::string step = fmt::format("step {}", f.sim.a.state->step);
  float step_end = ImGui::GetCursorPosX() +
                   std::max(ImGui::CalcTextSize("step 00000").x, ImGui::CalcTextSize(step.c_str()).x);
  if (step_end <= ImGui::GetContentRegionMax().x) {
    muted_label(f, step);
  } else {
    step_end = ImGui::GetCursorPosX() - ImGui::GetStyle().ItemSpacing.x;
    ImGui::NewLine();
  }
  // What does not fit any more is left out.
  const auto room_for = [&](const std::string& text) {
    return step_end + ImGui::GetStyle().ItemSpacing.x + ImGui::CalcTextSize(ui_text(text).c_str()).x <=
           ImGui::GetContentRegionMax().x;
  };
  const bool past = f.sim.a.cursor + 1 < history.size();
  std::string story;
  if (past) {
    story = "in the past: play replays, a change starts a branch";
    if (!room_for(story)) story = "in the past";
  } else if (f.sim.a.parting) {
    const Parting& p = *f.sim.a.parting;
    story = p.parted
                ? fmt::format("parts from the run before at {:.3f} s (a body is more than d̂ away)", *p.parted)
            : p.differs
                ? fmt::format("differs from the run before since {:.3f} s, by less than d̂", *p.differs)
                : "equal to the run before so far";
    if (!room_for(story)) story = p.parted ? fmt::format("parts at {:.3f} s", *p.parted) : "";
  }
  if (!story.empty() && room_for(story)) {
    ImGui::SameLine(step_end + ImGui::GetStyle().ItemSpacing.x);
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(past ? f.theme().color(0) : f.theme().muted));
    label(story);
    ImGui::PopStyleColor();
  }
  draw_kept(f);

  // The track.
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = {ImGui::GetContentRegionAvail().x, f.px(24)};
  ImGui::InvisibleButton("##track", size);
  double end = std::max(history.back().time, now);
  if (f.sim.a.left && !f.sim.a.left->empty()) end = std::max(end, f.sim.a.left->back().time);
  const double start = history.front().time;
  // The bar goes on beyond both ends of time, so that the playhead can be taken hold of there as well.
  const float room = f.px(kGrip);
  const Track track{{at.x + room, at.y},
                    {at.x + std::max(size.x - room, room + 1), at.y + size.y},
                    start,
                    std::max(end, start + kShortest)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, track.hi.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), f.px(4));
  list.AddRectFilled(at, {track.x(history.back().time) + room, track.hi.y},
                     ImGui::GetColorU32(ImGuiCol_FrameBgHovered), f.px(4));
  const std::vector<TrackEvent> events = track_events(f.sim, f.ui);
  const std::vector<Span> times = draw_times(f, track, !events.empty(), list);
  draw_marks(f, track, history, list);
  draw_names(f, track, events, times, list);
  if (f.sim.a.parting) {
    draw_flag(f, track, f.sim.a.parting->time, f.theme().muted, list);
    if (f.sim.a.parting->parted) draw_flag(f, track, *f.sim.a.parting->parted, f.theme().color(1), list);
  }
  draw_camera_marks(
      f, [&](double t) { return track.x(t); }, track.lo.y + f.px(7));
  const float x = std::round(track.x(now));
  const bool at_head =
      ImGui::IsItemActive() || (ImGui::IsItemHovered() && std::abs(ImGui::GetMousePos().x - x) <= room);
  const ImU32 head = ImGui::GetColorU32(at_head ? ImGuiCol_SliderGrab : ImGuiCol_SliderGrabActive);
  list.AddRectFilled({x - f.px(1.5), track.lo.y - f.px(2)}, {x + f.px(1.5), track.hi.y + f.px(2)}, head,
                     f.px(1.5));
  // A knob as wide as where it can be taken hold of.
  const float knob = f.px(at_head ? 6 : 5);
  list.AddTriangleFilled({x - knob, track.lo.y - f.px(3)}, {x + knob, track.lo.y - f.px(3)},
                         {x, track.lo.y + knob}, head);
  if (at_head) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    const float mouse = ImGui::GetMousePos().x;
    if (ImGui::IsItemActivated()) {
      // Taken hold of, the playhead stays where it is until the mouse moves.
      const bool held = std::abs(mouse - x) <= room;
      offset_ = held ? x - mouse : 0;
      wanted_ = held ? track.time(x) : -1;
    }
    const double t = track.time(mouse + (ImGui::IsItemActive() ? offset_ : 0));
    if (ImGui::IsItemActive() && t != wanted_) {
      f.out.send(Command(command::Seek{t}));
      wanted_ = t;
    }
    tooltip(fmt::format("{:.3f} s", t) +
            events_at(f, track, events, ImGui::IsItemActive() ? track.x(t) : mouse));
  }
}

}  // namespace pabd
