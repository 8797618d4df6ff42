// What is inside the panels.
#include "app/overlay/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/barrier.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/time_series.h"
#include "app/plots/palette.h"
#include "app/plots/plot_layout.h"
#include "render/visual/build_visual.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/palette.h"
#include "render/visual/srgb.h"

namespace pabd {
namespace {

constexpr Color kPanel{255, 255, 255, 232};
constexpr Color kRim{0, 0, 0, 26};
constexpr double kPad = 10;
constexpr double kTitle = 12, kText = 10.5;

Color screen_ink(const Vec4f& c) { return {srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z()), 255}; }

struct Row {
  std::string name;
  std::string value;
};

std::size_t joints_of(const OverlayData& data) {
  return data.view && data.view->model ? data.view->model->joints.size() : 0;
}

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
  std::u32string points = decode_text(text);
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
  const Rect in = rect.inset(kPad * s);
  const std::string title = data.scene_name.empty() ? "parameters" : data.scene_name;
  canvas.text({in.x, in.y}, shortened(canvas.font(), title, kTitle * s, in.w),
              {kTitle * s, ink::text, AnchorX::left, AnchorY::top});
  const std::vector<Row> rows = parameter_rows(data);
  const double top = in.y + 1.9 * kTitle * s;
  const double pitch = (in.bottom() - top) / std::max<double>(1, static_cast<double>(rows.size()) - 0.27);
  double y = top;
  for (const Row& row : rows) {
    const double baseline = y + FontMetrics::cap * kText * s;
    canvas.text({in.x, baseline}, row.name, {kText * s, ink::muted});
    canvas.text({in.right(), baseline}, row.value, {kText * s, ink::text, AnchorX::right});
    y += std::min(pitch, 1.75 * kText * s);
  }
}

void paint_small_plot(const Plot& plot, const Rect& rect, double s, Canvas& canvas) {
  const PlotStyle style = panel_style().scaled(s);
  paint_plot(plot, layout_plot(plot, rect.inset(kPad * s), style, canvas.font()), style, canvas);
}

void paint_legend(const Rect& rect, double s, Canvas& canvas) {
  const Rect in = rect.inset(kPad * s);
  const TextStyle text{kText * s, ink::text, AnchorX::left, AnchorY::middle};
  constexpr double lo = -0.5, hi = 1;
  const std::string name = "contact *{d}/*{d̂}";
  const double bar_left = in.x + text_width(canvas.font(), name, kText * s) + 12 * s;
  const Rect bar{std::round(bar_left), std::round(in.y), std::round(in.right() - bar_left - 8 * s),
                 std::round(11 * s)};
  canvas.text({in.x, bar.y + 0.5 * bar.h}, name, text);
  // One strip a pixel column: the colour map has knees that a few triangles would cut off.
  for (int k = 0; k < static_cast<int>(bar.w); ++k) {
    canvas.fill_rect({bar.x + k, bar.y, 1, bar.h}, contact_ink(lo + (hi - lo) * (k + 0.5) / bar.w));
  }
  for (const double v : {-0.5, 0.0, 0.5, 1.0}) {
    const double x = bar.x + bar.w * (v - lo) / (hi - lo);
    canvas.vertical(std::clamp(x, bar.x, bar.right() - 1), bar.bottom(), bar.bottom() + 3 * s, ink::axis, s);
    canvas.text({x, bar.bottom() + 6 * s}, v == 0 ? "0" : format_value(v),
                {kText * s, ink::text, AnchorX::center, AnchorY::top});
  }
}

// What the glyphs of bonds and joints mean: the points, and below them the types that the scene has.
void paint_joint_legend(const Rect& rect, double s, unsigned types, Canvas& canvas) {
  const Rect in = rect.inset(kPad * s);
  const TextStyle text{kText * s, ink::text, AnchorX::left, AnchorY::middle};
  double x = in.x, y = in.y + 0.22 * in.h;
  const auto name = [&](const char* words, double gap) {
    canvas.text({x, y}, words, text);
    x += text_width(canvas.font(), words, kText * s) + gap * s;
  };
  const auto points = [&](bool on_j, bool on_i, const char* words) {
    const Point at{x + 6 * s, y};
    if (on_j) {
      canvas.fill_circle(at, 5.6 * s, screen_ink(bond_line_color()));
      canvas.fill_circle(at, 4.4 * s, screen_ink(bond_point_j_color()));
    }
    if (on_i) canvas.fill_circle(at, 2.7 * s, screen_ink(bond_point_i_color()));
    x += 17 * s;
    name(words, 16);
  };
  points(false, true, "*{y}_{i}");
  points(true, false, "*{y}_{j}");
  points(true, true, "joined");
  x = in.x;
  y = in.y + 0.78 * in.h;
  for (const JointType type : kJointTypes) {
    if ((types >> static_cast<unsigned>(type) & 1u) == 0) continue;
    canvas.fill_rect({x, std::round(y - 1.5 * s), 10 * s, std::max(2.0, std::round(3 * s))},
                     screen_ink(joint_color(type)));
    x += 14 * s;
    name(to_string(type), 8);
  }
}

Plot empty_plot(const std::string& title) {
  Plot plot;
  plot.title = title;
  return plot;
}

Plot live_plot(Panel panel, const OverlayData& data) {
  const FrameView* view = data.view;
  if (panel == Panel::barrier) {
    if (!view) return empty_plot("Contact barrier");
    return contact_barrier_plot(view->params.contact, view->report.contact_reports, contact_ink);
  }
  if (panel == Panel::convergence) {
    return view ? convergence_plot(view->report.records, joints_of(data) > 0)
                : empty_plot("Convergence of the last step");
  }
  if (panel == Panel::difference)
    return difference_series_plot({}, {}, DifferenceQuantity::distance, data.distances);
  if (!view) return empty_plot("Over time");
  const auto plot_of = [&](const Reports& history) {
    return time_series_plot(history, view->params.contact.d_hat, joints_of(data) > 0);
  };
  Plot plot = plot_of(view->history);
  if (!data.other) return plot;
  plot.title = fmt::format("Over time: {} solid, {} dashed", view->label, data.other->label);
  for (Series& series : plot_of(data.other->history).series) {
    series.style = SeriesStyle::dashed;
    series.name.clear();
    plot.series.push_back(std::move(series));
  }
  return plot;
}

constexpr double kLetter = 1.5 * kTitle;               // of a caption
constexpr double kPitch = FontMetrics::line * kTitle;  // of its details

// Top centre of what the panels leave free.
void paint_caption(const PanelLayout& layout, const OverlayData& data, Canvas& canvas) {
  if (data.caption.empty()) return;
  const double s = layout.scale;
  const Rect& free = layout.free;
  const double most = free.w - 4 * kPad * s;
  if (!(most > 0)) return;
  const double letter = kLetter * s, text = kTitle * s;
  std::vector<std::string> lines;
  for (const std::string& detail : data.details) {
    for (std::string& line : wrap_text(canvas.font(), detail, text, most)) lines.push_back(std::move(line));
  }
  double width = text_width(canvas.font(), data.caption, letter);
  for (const std::string& line : lines) width = std::max(width, text_width(canvas.font(), line, text));
  const double pitch = kPitch * s;
  const double height = FontMetrics::cap * letter + static_cast<double>(lines.size()) * pitch;
  const double middle = free.x + 0.5 * free.w;
  const Rect box{std::round(middle - 0.5 * width - kPad * s), std::round(free.y + kPad * s),
                 std::round(width + 2 * kPad * s), std::round(height + 2 * kPad * s)};
  canvas.fill_rect({box.x - 1, box.y - 1, box.w + 2, box.h + 2}, kRim, 6 * s);
  canvas.fill_rect(box, kPanel, 5 * s);
  canvas.text({middle, box.y + kPad * s}, data.caption, {letter, ink::text, AnchorX::center, AnchorY::top});
  double y = box.y + kPad * s + FontMetrics::cap * letter + (pitch - FontMetrics::cap * text);
  for (const std::string& line : lines) {
    canvas.text({middle, y}, line, {text, ink::text, AnchorX::center, AnchorY::top});
    y += pitch;
  }
}

}  // namespace

int joint_row_count(const OverlayData& data) { return static_cast<int>(joint_rows(data).size()); }

Color contact_ink(double x) { return screen_ink(contact_color(x)); }

double caption_height(double scale, std::size_t details) {
  return (FontMetrics::cap * kLetter + static_cast<double>(details) * kPitch + 4 * kPad) * scale;
}

void paint_panels(const PanelLayout& layout, const OverlayData& data, Canvas& canvas) {
  const double s = layout.scale;
  for (const PlacedPanel& placed : layout.panels) {
    canvas.fill_rect({placed.rect.x - 1, placed.rect.y - 1, placed.rect.w + 2, placed.rect.h + 2}, kRim,
                     6 * s);
    canvas.fill_rect(placed.rect, kPanel, 5 * s);
    canvas.push_clip(placed.rect);
    switch (placed.panel) {
      case Panel::params:
        paint_params(placed.rect, s, data, canvas);
        break;
      case Panel::legend:
        paint_legend(placed.rect, s, canvas);
        break;
      case Panel::joints:
        paint_joint_legend(placed.rect, s, joints_of(data) ? joint_types(*data.view->model) : 0, canvas);
        break;
      default:
        paint_small_plot(live_plot(placed.panel, data), placed.rect, s, canvas);
    }
    canvas.pop_clip();
  }
  paint_caption(layout, data, canvas);
}

void paint_labels(const VisualScene& scene, int width, int height, double scale, Canvas& canvas) {
  if (scene.labels.empty() || width <= 0 || height <= 0) return;
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  // Only directions matter for the place in the frame; the depth range is free.
  const Mat4f clip = projection_matrix(scene.camera, aspect, 0.01f, 1000.0f) * view_matrix(scene.camera);
  for (const Label& label : scene.labels) {
    const Vec4f p = clip * label.position.homogeneous();
    if (!(p.w() > 0) || !p.allFinite()) continue;
    const double x = 0.5 * width * (1 + static_cast<double>(p.x() / p.w()));
    const double y = 0.5 * height * (1 - static_cast<double>(p.y() / p.w()));
    if (x < -width || x > 2.0 * width || y < -height || y > 2.0 * height) continue;
    canvas.text({x, y}, label.text,
                {static_cast<double>(label.size) * scale, ink::text, AnchorX::center, AnchorY::middle, false,
                 2 * scale});
  }
}

}  // namespace pabd
