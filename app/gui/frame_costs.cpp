// SPDX-License-Identifier: MIT
// See frame_costs.h.
//
//   x̄ ← x̄ + a (x − x̄), a = 0.1     about the mean of the last ten frames
#include "app/gui/frame_costs.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr double kNew = 0.1;

void smooth(double& mean, double value, bool first) { mean += (first ? 1 : kNew) * (value - mean); }

}  // namespace

void FrameCosts::begin() {
  const bool first = begun_ == Clock::time_point{};
  done(other);
  const double seconds = first ? 0 : std::chrono::duration<double>(last_ - begun_).count();
  begun_ = last_;
  if (first) {
    now_ = {};
    return;
  }
  // With the same weights, so that the parts add up to the frame.
  const bool second = frame_ == 0;
  for (std::size_t i = 0; i < kParts; ++i) smooth(ms_[i], now_[i], second);
  now_ = {};
  smooth(frame_, seconds, second);
}

void FrameCosts::done(Part part) {
  const auto now = Clock::now();
  now_[part] += std::chrono::duration<double, std::milli>(now - last_).count();
  last_ = now;
}

void draw_costs(GuiFrame& f, const Rect& view) {
  const float width = std::min(f.px(250), static_cast<float>(view.w) - f.px(24));
  // Popups come first.
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (!f.ui.costs || popup || width < f.px(120)) return;
  ImGui::SetNextWindowPos({static_cast<float>(view.x) + f.px(12), static_cast<float>(view.y) + f.px(12)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("##costs", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const bool steady = f.steady;
  const auto row = [&](const char* name, double value, const char* unit, bool known = true) {
    read_out(f, name, steady || !known ? fmt::format("– {}", unit) : fmt::format("{:.1f} {}", value, unit));
  };
  heading(f, "Window");
  row("frames", f.costs.frames_a_second(), "1/s");
  row("events and panels", f.costs.ms(FrameCosts::interface), "ms");
  row("picture of the scene", f.costs.ms(FrameCosts::picture), "ms");
  row("put together", f.costs.ms(FrameCosts::compose), "ms");
  row("show and wait", f.costs.ms(FrameCosts::other), "ms");
  heading(f, "Simulation");
  const PhaseTimes& t = f.sim.a.report.times;
  const bool known = f.sim.playing && f.sim.real_time_factor > 0;
  row("steps", f.sim.real_time_factor / f.sim.a.params.h, "1/s", known);
  row("times real time", f.sim.real_time_factor, "×", known);
  row("collision", t.detect + t.set_up, "ms");
  row("solver", t.solve, "ms");
  ImGui::End();
}

}  // namespace pabd
