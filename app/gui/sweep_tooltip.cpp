// SPDX-License-Identifier: MIT
// See sweep_tooltip.h.
#include "app/gui/sweep_tooltip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/widgets.h"
#include "app/plots/axis_ticks.h"

namespace pabd {
namespace {

constexpr double kWidth = 288, kPictureHeight = 162;  // pixels of an ordinary screen

void picture(GuiFrame& f, const SweptTask& task) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = {f.px(kWidth), f.px(kPictureHeight)};
  ImGui::Dummy(size);
  const Rect room{at.x, at.y, size.x, size.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  const SweepPicture end = f.sweeps.picture(task, true);
  if (end.status == SweepPicture::Status::there) return draw_inside(list, end, room);
  const char* text = end.status == SweepPicture::Status::waiting ? "…"
                     : task.picture.empty()                      ? "no picture"
                                                                 : "the picture is damaged";
  const ImVec2 words = ImGui::CalcTextSize(text);
  list.AddText({std::round(at.x + 0.5f * (size.x - words.x)), std::round(at.y + 0.5f * (size.y - words.y))},
               packed(f.theme().muted), text);
}

std::string value_words(const SweptValue& value, const std::string& unit) {
  return value.number ? in_words(*value.number, unit) : value.text;
}

}  // namespace

void draw_inside(ImDrawList& list, const SweepPicture& picture, const Rect& room) {
  const double scale = std::min(room.w / picture.width, room.h / picture.height);
  const double w = scale * picture.width, h = scale * picture.height;
  const auto x = static_cast<float>(room.x + 0.5 * (room.w - w)),
             y = static_cast<float>(room.y + 0.5 * (room.h - h));
  list.AddImage(picture.texture, {x, y}, {x + static_cast<float>(w), y + static_cast<float>(h)});
}

void sweep_tooltip(GuiFrame& f, const CollectedSweep& sweep, const ShownSweep& shown, const SweptTask& task,
                   bool loaded, const Rect& cell) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowSize().x + f.px(10);
  const float most = ImGui::GetIO().DisplaySize.y;
  // As high as its lines, known after a frame: placed by its middle, within the screen by ImGui.
  const bool lower = cell.y > 0.5 * static_cast<double>(most);
  ImGui::SetNextWindowPos({std::min(right, ImGui::GetIO().DisplaySize.x - f.px(kWidth + 24)),
                           static_cast<float>(lower ? cell.bottom() : cell.y)},
                          ImGuiCond_Always, {0, lower ? 1.0f : 0.0f});
  ImGui::BeginTooltip();
  if (!task.picture.empty() || task.status == SweptStatus::done) picture(f, task);
  ImGui::Dummy({f.px(kWidth), 0});
  heading(f, (task.index < 0 ? "task " + task.hash : fmt::format("task {}", task.index)) +
                 (task.status == SweptStatus::done ? "" : ": " + std::string(status_word(task.status))) +
                 (loaded ? " (shown here)" : ""));
  if (!task.why.empty()) wrapped_label(task.why);
  if (!task.faults.empty()) wrapped_label("Not acceptable: " + task.faults);
  for (const std::size_t p : varied_parameters(sweep)) {
    if (!task.parameters[p].absent())
      read_out(f, sweep.parameters[p].words, value_words(task.parameters[p], sweep.parameters[p].unit));
  }
  if (!shown.criteria.empty() && task.status == SweptStatus::done) ImGui::Separator();
  const auto place = static_cast<std::size_t>(&task - sweep.tasks.data());
  for (const Criterion& criterion : shown.criteria) {
    if (criterion.sizes[place])
      read_out(f, criterion.quantity.words, in_words(*criterion.sizes[place], criterion.quantity.unit));
  }
  if (task.step && task.time)
    read_out(f, "ended at", fmt::format("{} s, step {}", format_value(*task.time, 4), *task.step));
  if (task.index >= 0) {
    ImGui::Separator();
    muted_label(f, "click: this run from its start");
    muted_label(f, "shift+click: as it ended");
  }
  ImGui::EndTooltip();
}

}  // namespace pabd
