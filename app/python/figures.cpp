// SPDX-License-Identifier: MIT
// See figures.h.
#include "app/python/figures.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_figure.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/quantity_plot.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/figures/time_panel.h"
#include "app/plots/theme.h"
#include "app/python/painter.h"
#include "app/python/simulation.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/output_path.h"

namespace pabd::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr std::size_t kMostCurves = 64;
constexpr int kMostIterations = 100000;

const PlotTheme& theme_of(const std::string& style) {
  if (style == "paper") return light_theme();
  if (style == "screen") return dark_theme();
  throw Error(ErrorKind::bad_input, fmt::format("style {}: expected paper or screen", style));
}

PictureSize size_of(const Figure& figure, std::optional<int> width, std::optional<int> height) {
  const PictureSize usual = default_size(figure);
  const PictureSize size{width.value_or(usual.width), height.value_or(usual.height)};
  check_size(size.width, size.height);
  return size;
}

std::string svg(const Figure& figure, std::optional<int> width, std::optional<int> height,
                const std::string& style) {
  const PictureSize size = size_of(figure, width, height);
  return figure_to_svg(figure, size.width, size.height, theme_of(style));
}

std::string pdf(const Figure& figure, std::optional<int> width, std::optional<int> height) {
  const PictureSize size = size_of(figure, width, height);
  return picture_to_pdf(figure_picture(figure), size.width, size.height);
}

void save(const Figure& figure, const std::filesystem::path& path, bool force) {
  const std::string ending = path.extension().string();
  if (ending != ".svg" && ending != ".pdf" && ending != ".csv")
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a name that ends in .svg, .pdf or .csv", path.string()));
  check_overwrite(path.string(), path, {force, nullptr, "force=True replaces it"});
  write_file(path, ending == ".svg"   ? svg(figure, {}, {}, "paper")
                   : ending == ".pdf" ? pdf(figure, {}, {})
                                      : figure_to_csv(figure));
}

// The value of a word of a parameter that is a choice.
template <class Enum>
Enum choice(const char* key, const std::string& word) {
  const ParameterRow& row = *find_parameter(key);
  for (const ParameterChoice& choice : choices_of(row))
    if (word == choice.word) return std::get<Enum>(choice.value);
  throw Error(ErrorKind::bad_input, fmt::format("{} {}: expected {}", key, word, expected_of(row)));
}

const StepQuantity& quantity(const std::string& key) {
  if (const StepQuantity* found = find_step_quantity(key)) return *found;
  throw Error(ErrorKind::bad_input,
              fmt::format("quantity {}: expected one of {}", key, step_quantity_words()));
}

std::string caption_of(const Session& session, std::int64_t step) {
  return run_caption(session.scene().name, step, session.params(), session.kappa(), true);
}

Figure history_figure(const Simulation& simulation) {
  const Session& session = simulation.session();
  Figure figure = time_series_figure(simulation.history());
  figure.caption = caption_of(session, session.state().step);
  return figure;
}

Figure quantity_figure(const Simulation& simulation, const std::string& y, const std::string& x) {
  const Session& session = simulation.session();
  Figure figure;
  figure.plots.push_back(quantity_plot(simulation.history(), quantity(x), quantity(y)));
  figure.caption = caption_of(session, session.state().step);
  return figure;
}

Figure convergence(const Simulation& simulation, const std::vector<std::string>& words, int iterations) {
  const Session& session = simulation.session();
  if (iterations < 1 || iterations > kMostIterations)
    throw Error(ErrorKind::bad_input,
                fmt::format("iterations {}: expected a number from 1 to {}", iterations, kMostIterations));
  std::vector<SolverMethod> methods;
  for (const std::string& word : words) {
    methods.push_back(choice<SolverMethod>("solver.method", word));
    if (methods.back() == SolverMethod::automatic)
      throw Error(ErrorKind::bad_input, "methods auto: expected some of sissm, descent, newton");
  }
  if (methods.empty()) methods = {SolverMethod::sissm, SolverMethod::descent};
  // Copies: others may step meanwhile.
  const auto solve = [&, model = session.model(), params = session.params(), state = session.state()] {
    const py::gil_scoped_release others;
    return std::pair(run_methods(model, params, state, methods, iterations),
                     find_minimiser(model, params, state));
  };
  const auto [runs, minimiser] = solve();
  return convergence_figure(runs, minimiser, caption_of(session, session.state().step + 1));
}

// The limits of scene files hold here too.
void check_curves(const BarrierCurves& curves) {
  Params params;
  const auto check = [&params] {
    if (const auto error = check_params(params))
      throw Error(ErrorKind::bad_input, error->pointer + ": " + error->message);
    params = {};
  };
  params.contact.onset = curves.onset;
  check();
  for (const int N : curves.N) params.contact.N = N, check();
  for (const double d_hat : curves.d_hat) params.contact.d_hat = d_hat, check();
  for (const double kappa : curves.kappa) params.contact.kappa = kappa, check();
  const BarrierFigureSize size = size_of(curves);
  if (size.curves == 0 || size.curves > kMostCurves || size.rows > kMostRows)
    throw Error(ErrorKind::bad_input,
                fmt::format("{} curves in {} rows: expected 1 to {} curves in at most {} rows", size.curves,
                            size.rows, kMostCurves, kMostRows));
}

Figure barrier(const std::vector<int>& N, const std::vector<double>& d_hat, const std::vector<double>& kappa,
               const std::vector<std::string>& kinds, double onset) {
  if (N.empty() || d_hat.empty() || kinds.empty())
    throw Error(ErrorKind::bad_input, "plot_barrier: expected at least one N, d_hat and barrier");
  BarrierCurves curves;
  curves.N = N;
  curves.d_hat = d_hat;
  curves.kappa = kappa;
  curves.onset = onset;
  curves.kinds.clear();
  for (const std::string& kind : kinds) curves.kinds.push_back(choice<BarrierKind>("contact.barrier", kind));
  check_curves(curves);
  return barrier_figure(curves);
}

}  // namespace

void bind_figures(py::module_& module) {
  py::class_<Figure>(module, "Figure",
                     R"(Plots side by side, as the program draws them. A notebook shows it as SVG.)")
      .def("svg", &svg, "width"_a = py::none(), "height"_a = py::none(), "style"_a = "paper",
           R"(The figure as an SVG document.

width, height: pixels, 16 to 16384; None: what suits it.
style: "paper" (on white) or "screen" (light on dark).)")
      .def(
          "pdf",
          [](const Figure& figure, std::optional<int> width, std::optional<int> height) {
            return py::bytes(pdf(figure, width, height));
          },
          "width"_a = py::none(), "height"_a = py::none(),
          "The figure as the bytes of a PDF document of one page; 3/4 pt a pixel.")
      .def("csv", &figure_to_csv, "The data as CSV: plot,series,x,y; numbers read back exactly.")
      .def(
          "save", &save, "path"_a, "force"_a = false,
          R"(Write a .svg, .pdf or .csv, whole or not at all. A file that exists is replaced only with force=True.)")
      .def(
          "_repr_svg_", [](const Figure& figure) { return svg(figure, {}, {}, "paper"); },
          "What a notebook shows.");
  module.def("plot_history", &history_figure, "simulation"_a);
  module.def("plot_quantity", &quantity_figure, "simulation"_a, "y"_a, "x"_a);
  module.def("plot_convergence", &convergence, "simulation"_a, "methods"_a, "iterations"_a);
  module.def("plot_barrier", &barrier, "N"_a, "d_hat"_a, "kappa"_a, "barrier"_a, "onset"_a);
}

}  // namespace pabd::python
