// SPDX-License-Identifier: MIT
// See sweep_cells.h.
#include "app/gui/sweep_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/widgets.h"
#include "app/plots/axis_ticks.h"
#include "app/sweep/collect_plots.h"

namespace pabd {
namespace {

// Pixels of an ordinary screen.
constexpr double kLeastWidth = 5, kLeastHeight = 15, kMostHeight = 72;
constexpr double kLeastPictureCell = 34;             // width of a cell with a picture
constexpr double kLinePicture = 72, kLineCell = 44;  // width of the cells of a sample, which are in lines

double widest(const std::vector<std::string>& names, const FontMetrics& font, double size) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(font, name, size));
  return width;
}

// What the panel shows is one slice; of a sample as many columns as there is room for.
TaskGrid one_slice(const CollectedSweep& sweep, const ShownSweep& shown, double width, double cell) {
  TaskGrid grid = shown.grid;
  grid.slices = {shown.grid.slices[shown.slice]};
  grid.slices[0].name.clear();
  if (!grid.scattered) return grid;
  const std::size_t n = std::max<std::size_t>(1, sweep.tasks.size());
  const std::size_t columns = std::clamp<std::size_t>(static_cast<std::size_t>(width / cell), 1, n);
  const std::size_t rows = (n + columns - 1) / columns;
  for (GridAxis* axis : {&grid.x, &grid.y}) {
    const std::size_t size = axis == &grid.x ? columns : rows;
    axis->values.assign(size, {});
    axis->names.assign(size, "");
  }
  // The first line is the top one, and rows go upwards.
  std::vector<std::optional<std::size_t>>& tasks = grid.slices[0].tasks;
  tasks.assign(columns * rows, std::nullopt);
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i)
    tasks[(rows - 1 - i / columns) * columns + i % columns] = i;
  return grid;
}

constexpr double kTipWidth = 288, kTipPictureHeight = 162;  // pixels of an ordinary screen

void picture(GuiFrame& f, const SweptTask& task) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = {f.px(kTipWidth), f.px(kTipPictureHeight)};
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

SweepCells sweep_cells(const CollectedSweep& sweep, const ShownSweep& shown, bool pictures, double width,
                       double height, const PlotStyle& style, double unit, const FontMetrics& font) {
  SweepCells out;
  const TaskGrid grid = one_slice(sweep, shown, width, unit * (pictures ? kLinePicture : kLineCell));
  const bool measured = shown.criterion < shown.criteria.size();
  Criterion none;  // of a sweep without any metric
  none.sizes.resize(sweep.tasks.size());
  const Criterion& criterion = measured ? shown.criteria[shown.criterion] : none;
  out.map = heat_map_of(sweep, grid, criterion);
  out.tasks = grid.slices[0].tasks;
  const auto columns = static_cast<double>(out.columns()), rows = static_cast<double>(out.rows());

  HeatLayout& layout = out.layout;
  layout.style = style;
  layout.scale = color_scale_of(criterion, 5);
  const double line = FontMetrics::line * style.label;
  const double margin = 0.3 * style.label;  // for the hat of d̂, which is higher than a line
  layout.room_left =
      grid.y.label.empty() ? 0 : 2 * style.gap + widest(out.map.y_names, font, style.tick) + line;
  const double cell = std::max(std::floor((width - margin - layout.room_left) / columns), kLeastWidth * unit);
  const double names = widest(out.map.x_names, font, style.tick);
  layout.vertical = names > cell - 0.4 * style.tick;
  layout.room_below =
      grid.x.label.empty() ? 0 : 2 * style.gap + (layout.vertical ? names : style.tick) + line;
  out.pictures = pictures && cell >= kLeastPictureCell * unit;
  double cell_height = std::round(cell * 9 / 16) + (out.pictures ? unit * 5 : 0);
  if (!out.pictures) {
    const double share = std::floor((height - layout.room_below) / rows);
    cell_height = std::min({std::max(cell_height, share), cell, kMostHeight * unit});
  }
  cell_height = std::max(cell_height, kLeastHeight * unit);
  layout.panels = {{margin + layout.room_left, 0, cell * columns, cell_height * rows}};
  out.width = margin + layout.room_left + cell * columns;
  out.height = cell_height * rows + layout.room_below;
  return out;
}

std::optional<std::size_t> cell_at(const SweepCells& cells, const Point& at) {
  const Rect& inner = cells.layout.panels[0];
  if (at.x < inner.x || at.x >= inner.right() || at.y < inner.y || at.y >= inner.bottom())
    return std::nullopt;
  const auto part = [](double from, double size, std::size_t count) {
    return std::min(static_cast<std::size_t>(from / size * static_cast<double>(count)), count - 1);
  };
  return part(inner.bottom() - at.y, inner.h, cells.rows()) * cells.columns() +
         part(at.x - inner.x, inner.w, cells.columns());
}

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
  ImGui::SetNextWindowPos({std::min(right, ImGui::GetIO().DisplaySize.x - f.px(kTipWidth + 24)),
                           static_cast<float>(lower ? cell.bottom() : cell.y)},
                          ImGuiCond_Always, {0, lower ? 1.0f : 0.0f});
  ImGui::BeginTooltip();
  if (!task.picture.empty() || task.status == SweptStatus::done) picture(f, task);
  ImGui::Dummy({f.px(kTipWidth), 0});
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
