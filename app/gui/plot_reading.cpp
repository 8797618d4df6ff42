// SPDX-License-Identifier: MIT
// See plot_reading.h.
#include "app/gui/plot_reading.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/plots/rich_text.h"

namespace pabd {
namespace {

constexpr double kPointReach = 18, kHintText = 10.5;  // px of an ordinary screen
constexpr const char* kLong = "Save…";
constexpr const char* kShort = "…";  // where the line is full
constexpr const char* kEndings[] = {".csv", ".svg", ".pdf", ".png"};

void keep(const Series& from, std::size_t i, Series& to) {
  to.x.push_back(from.x[i]);
  to.y.push_back(from.y[i]);
}

void thin_line(Series& series, std::size_t most) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  const std::size_t piece = (4 * count + most - 1) / most;
  Series out;
  for (std::size_t begin = 0; begin < count; begin += piece) {
    const std::size_t end = std::min(count, begin + piece);
    std::size_t picks[4] = {begin, begin, begin, end - 1};
    for (std::size_t i = begin; i < end; ++i) {
      // Non-finite (a gap without contacts) breaks the line: no extreme.
      if (!std::isfinite(series.y[i])) continue;
      if (!(series.y[picks[1]] <= series.y[i])) picks[1] = i;
      if (!(series.y[picks[2]] >= series.y[i]) || !std::isfinite(series.y[picks[2]])) picks[2] = i;
    }
    std::sort(std::begin(picks), std::end(picks));
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == 0 || picks[k] != picks[k - 1]) keep(series, picks[k], out);
    }
  }
  series.x = std::move(out.x);
  series.y = std::move(out.y);
}

// Without what lies to the left and right of the range, but for the next point on either side.
void cut_line(Series& series, double lo, double hi) {
  if (!std::is_sorted(series.x.begin(), series.x.end())) return;
  auto first = std::lower_bound(series.x.begin(), series.x.end(), lo);
  auto last = std::upper_bound(series.x.begin(), series.x.end(), hi);
  if (first != series.x.begin()) --first;
  if (last != series.x.end()) ++last;
  const auto from = first - series.x.begin(), to = last - series.x.begin();
  series.x = {first, last};
  series.y = {series.y.begin() + from, series.y.begin() + to};
}

bool is_line(const Series& series) {
  return series.style == SeriesStyle::line || series.style == SeriesStyle::dashed;
}

// "E − E_min 1.2·10⁻³ J" of a label "E − E_{min} [J]".
std::string worded(const Plot& plot, const Series& series, const std::string& called, double y) {
  const std::string label_text = plain_text(series.right_axis ? plot.y_right.label : plot.y.label);
  const std::size_t bracket = label_text.rfind(" [");
  std::string name = bracket == label_text.npos ? label_text : label_text.substr(0, bracket), unit;
  if (bracket != label_text.npos) unit = label_text.substr(bracket + 2, label_text.size() - bracket - 3);
  if (unit == "1") unit.clear();
  if (!called.empty()) name = plain_text(called);
  return fmt::format("{}: {}{}{}", name, std::isfinite(y) ? format_value(y) : "–", unit.empty() ? "" : " ",
                     unit);
}

// Without its beginning where that has no room: words differ at their end more often.
std::string end_that_fits(const std::string& text, float width) {
  const auto fits = [&](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x <= width; };
  if (fits(text)) return text;
  std::size_t from = 0;
  const auto shown = [&] { return "…" + text.substr(from); };
  while (from < text.size() && (from == 0 || !fits(shown()))) {
    ++from;
    while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xc0) == 0x80) ++from;
  }
  return shown();
}

}  // namespace

void thin_lines(Plot& plot, std::size_t most) {
  most = std::max<std::size_t>(most, 8);
  for (Series& series : plot.series) {
    if (!is_line(series)) continue;
    if (plot.x.lo < plot.x.hi && series.x.size() == series.y.size()) cut_line(series, plot.x.lo, plot.x.hi);
    if (series.x.size() > most) thin_line(series, most);
  }
}

PlotTouch panel_plot(GuiFrame& f, const char* panel, const Plot& plot, ImVec2 size, bool grips) {
  const PlotTouch touch = plot_widget(f, panel, plot, size, grips ? PlotHand::grips : PlotHand::zooms);
  if (touch.zoom) f.out.send(ViewCommand(plot_view(panel, *touch.zoom)));
  if (!f.ui.zoom_of(panel).any()) return touch;
  ImFont* font = f.fonts.font(kHintText * f.unit);
  if (!font) return touch;
  static constexpr const char* kHint = "a part; double-click: all";
  const Rect& in = touch.layout.inner;
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, kHint).x;
  ImGui::GetWindowDrawList()->AddText(
      font, font->FontSize,
      {std::round(static_cast<float>(in.right()) - width - f.px(3)), static_cast<float>(in.y)},
      packed(f.theme().muted), kHint);
  return touch;
}

std::optional<PlotPick> read_point(GuiFrame& f, const Plot& plot, const PlotTouch& touch,
                                   const char* x_name) {
  if (!touch.hovered) return std::nullopt;
  const auto pick = nearest_point(plot, touch.layout, touch.mouse, f.px(kPointReach));
  if (!pick) return std::nullopt;
  ImGui::GetWindowDrawList()->AddCircle({static_cast<float>(pick->at.x), static_cast<float>(pick->at.y)},
                                        f.px(5), packed(f.theme().text), 20, f.px(1.5));
  ImGui::BeginTooltip();
  muted_label(f, fmt::format("{} {}", x_name, format_value(pick->x)));
  const Series& series = plot.series[pick->series];
  label(worded(plot, series, series.name, pick->y));
  ImGui::EndTooltip();
  return pick;
}

std::optional<PlotPick> read_time(GuiFrame& f, const Plot& plot, const PlotTouch& touch,
                                  const std::vector<std::string>& names) {
  if (!touch.hovered && !touch.held) return std::nullopt;
  Point at = touch.mouse;
  const Rect& inner = touch.layout.inner;
  if (touch.held) {  // a drag goes on outside
    at = {std::clamp(at.x, inner.x, inner.right()), std::clamp(at.y, inner.y, inner.bottom())};
  }
  const auto pick = nearest_in_x(plot, touch.layout, at);
  if (!pick) return std::nullopt;
  const auto x = static_cast<float>(std::round(pick->at.x));
  ImGui::GetWindowDrawList()->AddRectFilled({x, static_cast<float>(inner.y)},
                                            {x + f.px(1), static_cast<float>(inner.bottom())},
                                            packed(f.theme().text));
  ImGui::BeginTooltip();
  muted_label(f, fmt::format("{:.4g} s, a click goes there", pick->x));
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    if (!is_line(series) || series.x.empty()) continue;
    if (pick->x < series.x.front() || pick->x > series.x.back()) continue;  // a run that is shorter
    auto next = std::lower_bound(series.x.begin(), series.x.end(), pick->x);
    if (next == series.x.end() || (next != series.x.begin() && pick->x - next[-1] < *next - pick->x)) --next;
    label(worded(plot, series, s < names.size() ? names[s] : series.name,
                 series.y[static_cast<std::size_t>(next - series.x.begin())]));
  }
  ImGui::EndTooltip();
  return pick;
}

float combo_width(const char* word) {
  return ImGui::CalcTextSize(ui_text(word).c_str()).x + ImGui::GetFrameHeight() +
         2 * ImGui::GetStyle().FramePadding.x;
}

std::optional<std::size_t> word_combo(const char* id, const char* const* words, std::size_t count,
                                      std::size_t now, float width, const char* help) {
  std::optional<std::size_t> chosen;
  ImGui::SetNextItemWidth(width);
  const std::string word = ui_text(words[now]);
  const std::string seen =
      end_that_fits(word, width - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x);
  const bool open = ImGui::BeginCombo(id, seen.c_str(), ImGuiComboFlags_HeightLarge);
  if (!open) {
    tooltip(seen == word ? help : fmt::format("{}\n{}", words[now], help));
    return chosen;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (ImGui::Selectable(ui_text(words[i]).c_str(), i == now)) chosen = i;
  }
  ImGui::EndCombo();
  return chosen;
}

const char* choice_combo(const char* id, std::span<const Choice> choices, std::string_view now, float width,
                         const char* help) {
  std::vector<const char*> words;
  for (const Choice& choice : choices) words.push_back(label_of(choice));
  const auto chosen = word_combo(id, words.data(), words.size(), place_in(choices, now), width, help);
  return chosen ? choices[*chosen].name : nullptr;
}

float export_width(const GuiFrame&) { return button_width(kLong); }

void export_button(GuiFrame& f, const char* panel, std::string& path) {
  ImGui::SameLine(0, f.px(2));
  const float end = ImGui::GetWindowContentRegionMax().x, here = ImGui::GetCursorPosX();
  const char* text = here + button_width(kLong) <= end ? kLong : kShort;
  ImGui::SetCursorPosX(std::max(here, end - button_width(text)));
  if (ImGui::Button(text)) {
    if (path.empty()) path = fmt::format("{}_{}.pdf", f.sim.scene->name, panel);
    ImGui::OpenPopup("export");
  }
  tooltip(
      "The plot as it is seen, as CSV, SVG, PDF or PNG.\n"
      "On the plot the wheel goes nearer, a right drag moves, a double-click shows all again.");
  if (!ImGui::BeginPopup("export")) return;
  muted_label(f, "plot as a file");
  for (const char* ending : kEndings) {
    if (ending != kEndings[0]) ImGui::SameLine(0, f.px(2));
    const bool on = std::filesystem::path(path).extension() == ending;
    if (toggle_button(f, ending + 1, on, fmt::format("Changes the name to one that ends in {}", ending)))
      path = std::filesystem::path(path).replace_extension(ending).string();
  }
  ImGui::SetNextItemWidth(f.px(230));
  const bool enter = ImGui::InputText("##path", &path, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if (ImGui::Button("Save") || enter) {
    f.out.send(command::ExportPlot{panel, path});
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pabd
