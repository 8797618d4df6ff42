// SPDX-License-Identifier: MIT
// The parameters of the run, as many of the joints' as the scene has, and what the last step counted.
#include <fmt/format.h>

#include <algorithm>

#include "app/overlay/overlay_style.h"
#include "app/plots/axis_ticks.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

using namespace overlay_style;

constexpr double kRowHeight = 18;  // px at scale 1, of a row about joints

struct Row {
  std::string name;
  std::string value;
};

std::vector<Row> joint_rows(const OverlayData& data) {
  std::vector<Row> rows;
  const std::size_t joints = joints_of(data);
  if (joints == 0) return rows;
  const std::string count = fmt::format("{}", joints);
  if (data.joint_law) {
    const BondLaw& law = *data.joint_law;
    const bool hard = law.potential == BondPotential::hard;
    rows.push_back({"joints", count + (hard ? fmt::format(", hard, *{{N}} = {}", law.N) : ", soft")});
    if (hard) rows.push_back({"joint scale *{d̂}", format_value(law.d_hat) + " m"});
    rows.push_back({"joint stiffness *{κ}", format_value(law.kappa, 3) + (hard ? " J" : " N/m")});
  } else {
    rows.push_back({"joints", count});
  }
  rows.push_back({"joint error", format_value(data.view->report.max_joint_error, 2) + " m"});
  return rows;
}

// The default goes without saying.
bool names_integrator(const OverlayData& data) {
  return data.view && data.view->params.solver.integrator != SolverParams{}.integrator;
}

std::vector<Row> parameter_rows(const OverlayData& data) {
  std::vector<Row> rows;
  if (data.view) {
    const Params& p = data.view->params;
    const StepReport& report = data.view->report;
    rows.push_back({"solver", to_string(report.method)});
    rows.push_back(
        {"barrier", traits_of(p.contact.barrier).least_N == 0
                        ? std::string(to_string(p.contact.barrier))
                        : fmt::format("{}, *{{N}} = {}", to_string(p.contact.barrier), p.contact.N)});
    rows.push_back({"thickness *{d̂}", format_value(p.contact.d_hat) + " m"});
    rows.push_back({"stiffness *{κ}", format_value(data.view->kappa) + " " + kappa_unit(p.contact.barrier) +
                                          (p.contact.kappa ? "" : ", auto")});
    rows.push_back({"onset *{ε}", format_value(p.contact.onset)});
    const std::string friction = format_value(p.contact.mu_static);
    rows.push_back({"friction *{μ}", p.contact.mu_static == p.contact.mu_dynamic
                                         ? friction
                                         : friction + " / " + format_value(p.contact.mu_dynamic)});
    rows.push_back({"time step *{h}", format_value(p.h) + " s"});
    if (names_integrator(data)) rows.push_back({"integrator", to_string(p.solver.integrator)});
    rows.push_back({"iterations", fmt::format("{} of {}", report.iterations, p.solver.iterations)});
  }
  for (Row& row : joint_rows(data)) rows.push_back(std::move(row));
  if (data.view) {
    const StepReport& report = data.view->report;
    rows.push_back({"contacts", fmt::format("{}", report.contacts)});
    rows.push_back({"step", fmt::format("{}", report.step)});
    rows.push_back({"time", fmt::format("{:.3f} s", report.time)});
  }
  return rows;
}

// Cuts with an ellipsis what is wider than `width`.
std::string shortened(const FontMetrics& font, const std::string& text, double size, double width) {
  if (text_width(font, text, size) <= width) return text;
  std::string out = text;
  std::size_t bytes = text.size();
  while (bytes > 0) {
    do {
      --bytes;
    } while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80);
    out = text.substr(0, bytes) + "…";
    if (text_width(font, out, size) <= width) break;
  }
  return out;
}

void paint_params(const Rect& rect, double s, const OverlayData& data, Canvas& canvas) {
  const PlotTheme& inks = inks_of(data);
  const Rect in = rect.inset(kPad * s);
  const std::string title = data.scene_name.empty() ? "parameters" : data.scene_name;
  canvas.text({in.x, in.y}, shortened(canvas.font(), title, kTitle * s, in.w),
              {kTitle * s, inks.text, AlignX::left, AlignY::top});
  const std::vector<Row> rows = parameter_rows(data);
  const double top = in.y + 1.9 * kTitle * s;
  const double pitch = (in.bottom() - top) / std::max<double>(1, static_cast<double>(rows.size()) - 0.27);
  double y = top;
  for (const Row& row : rows) {
    const double baseline = y + FontMetrics::cap * kText * s;
    canvas.text({in.x, baseline}, row.name, {kText * s, inks.muted});
    canvas.text({in.right(), baseline}, row.value, {kText * s, inks.text, AlignX::right});
    y += std::min(pitch, 1.75 * kText * s);
  }
}

// Of the rows that not every scene has.
double more_rows_height(const OverlayData& data) {
  return kRowHeight * static_cast<double>(joint_rows(data).size() + (names_integrator(data) ? 1 : 0));
}

}  // namespace

const OverlayPanel params_overlay = {.name = "params",
                                     .place = PanelPlace::top_left,
                                     .width = 196,
                                     .height = 236,
                                     .paint = paint_params,
                                     .more_height = more_rows_height};

}  // namespace pabd
