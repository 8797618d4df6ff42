// SPDX-License-Identifier: MIT
// Plots of any size: no text is cut by the edge or written over another, no two ticks of an axis read the same, and
// curves keep some room.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/barrier_figure.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/quantity_plot.h"
#include "app/plots/figures/reactions.h"
#include "app/plots/figures/time_panel.h"

namespace pabd::test_small_plots {

namespace {

struct Word {
  std::string text;
  Rect box;
};

// Keeps the places of texts: from the baseline, or from the foot of letters that reach below it, to the top of capitals.
class TextBoxes : public Canvas {
 public:
  explicit TextBoxes(const FontMetrics& font) : Canvas(font) {}
  void polyline(std::span<const Point>, const Stroke&, bool) override {}
  void fill_polygon(std::span<const Point>, Color) override {}
  void fill_rect(const Rect&, Color, double) override {}
  void fill_circle(const Point&, double, Color) override {}
  void push_clip(const Rect&) override {}
  void pop_clip() override {}
  void text(const Point& at, std::string_view rich, const TextStyle& style) override {
    const double w = text_width(font(), rich, style.size), h = FontMetrics::cap * style.size;
    const double left = style.x == AlignX::left ? 0 : style.x == AlignX::center ? 0.5 * w : w;
    const double up = h - baseline_offset(style.y, style.size);
    words.push_back({std::string(rich), style.vertical ? Rect{at.x - up, at.y - (w - left), h, w}
                                                       : Rect{at.x - left, at.y - up, w, h}});
  }
  std::vector<Word> words;
};

std::vector<StepSummary> some_steps() {
  std::vector<StepSummary> out(200);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto t = static_cast<double>(k);
    StepSummary& s = out[k];
    s.step = static_cast<std::int64_t>(k);
    s.time = t / 60;
    s.kinetic = 12345 * std::exp(-t / 30);
    s.potential = -2e4 + 40 * t;
    s.elastic = 1e-3 * t;
    s.kappa = 1250;
    s.contacts = static_cast<int>(7 * k);
    s.iterations = static_cast<int>(k % 17);
    s.max_penetration = 1e-5 * std::abs(std::sin(t));
    s.min_gap = 0.01 * std::cos(0.1 * t);
    s.max_joint_error = 1e-9 * (1 + t);
    s.residual = std::exp(-0.1 * t);
    s.max_normal_force = 3e5 * std::abs(std::sin(0.05 * t));
    s.times.total = 2;
  }
  return out;
}

std::vector<Figure> figures() {
  std::vector<Figure> out;
  BarrierCurves curves;
  out.push_back(barrier_figure(curves));
  curves.kinds = {BarrierKind::polynomial, BarrierKind::log};
  curves.d_hat = {0.01, 0.02};
  curves.kappa = {50};
  out.push_back(barrier_figure(curves));
  ContactParams contact;
  std::vector<ContactReport> contacts(40);
  for (std::size_t k = 0; k < contacts.size(); ++k) contacts[k].d = 0.0003 * static_cast<double>(k) - 0.002;
  out.push_back(contact_barrier_figure(contact, 1250, 60, contacts, [](double) { return Color{}; }));
  out.back().caption = "pyramid, step 60, h = 0.01667 s, N = 3, d̂ = 0.01 m, κ = 1250 J, ε = 0.2";
  const std::vector<StepSummary> steps = some_steps();
  out.push_back(time_series_figure(steps));
  std::vector<const StepQuantity*> all;
  for (const StepQuantity& quantity : step_quantities()) all.push_back(&quantity);
  out.push_back(quantities_figure(steps, all));
  const StepQuantity* const some[] = {find_step_quantity("kinetic"), find_step_quantity("residual"),
                                      find_step_quantity("max_normal_force")};
  out.push_back(quantities_figure(steps, some));
  use_log_axes(out.back());
  std::vector<double> time;
  std::vector<JointSeries> joints(8);
  for (const StepSummary& step : steps) {
    time.push_back(step.time);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      joints[k].name = "hanger of plank " + std::to_string(k);
      joints[k].force.push_back(step.max_normal_force + 1000 * static_cast<double>(k));
      joints[k].error.push_back(step.max_joint_error * (1 + static_cast<double>(k)));
    }
  }
  out.push_back(reactions_figure(time, joints));
  return out;
}

}  // namespace

TEST_CASE("no text of a figure is cut or written over another, whatever its size") {
  const FontMetrics font;
  for (const Figure& figure : figures()) {
    for (const auto& [width, height] : {std::pair{1600, 700},
                                        {1280, 720},
                                        {720, 1280},
                                        {640, 400},
                                        {320, 240},
                                        {240, 320},
                                        {200, 150},
                                        {2000, 500},
                                        {500, 160}}) {
      TextBoxes canvas(font);
      figure_picture(figure)(canvas, width, height);
      CAPTURE(figure.title, width, height);
      CHECK(canvas.words.size() > 4);
      const Rect picture{-0.5, -0.5, width + 1.0, height + 1.0};
      for (std::size_t i = 0; i < canvas.words.size(); ++i) {
        const Word& word = canvas.words[i];
        CAPTURE(word.text, word.box.x, word.box.y, word.box.w, word.box.h);
        CHECK(picture.contains(word.box));
        for (std::size_t j = 0; j < i; ++j) {
          CAPTURE(canvas.words[j].text);
          CHECK_FALSE(word.box.inset(0.5).overlaps(canvas.words[j].box.inset(0.5)));
        }
      }
    }
  }
}

TEST_CASE("no two ticks of an axis read the same, and curves have room") {
  const FontMetrics font;
  for (const Figure& figure : figures()) {
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {640, 400}, {320, 240}, {200, 150}, {2000, 500}}) {
      CAPTURE(figure.title, width, height);
      const FigureLayout layout = layout_figure(figure, width, height, font);
      REQUIRE_FALSE(layout.cells.empty());
      for (std::size_t i = 0; i < layout.cells.size(); ++i) {
        const PlotLayout plot = layout_plot(figure.plots[i], layout.cells[i], layout.style, font);
        CHECK(plot.inner.w >= 8 * layout.style.tick);
        CHECK(plot.inner.h >= 4 * layout.style.tick);
        for (const AxisScale* axis : {&plot.x, &plot.y, &plot.y_right}) {
          std::set<std::string> labels;
          for (const Tick& tick : axis->ticks)
            if (tick.major) CHECK(labels.insert(tick.label).second);
        }
      }
    }
  }
}

}  // namespace pabd::test_small_plots
