// SPDX-License-Identifier: MIT
// pabd plot barrier: B_N and B_N' against d, for lists of N, d̂, κ and kinds; or the law of a scene with its contacts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "app/cli/figure_output.h"
#include "app/cli/plot_run.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/barrier_figure.h"
#include "app/plots/figures/run_caption.h"
#include "sim/base/error.h"
#include "sim/solver/params.h"

namespace pabd::cli {
namespace {

constexpr std::size_t kMostCurves = 64;

struct PlotBarrierOptions {
  CommonOptions common;
  FigureOutputOptions output;
  std::vector<std::string> kinds{"polynomial"};
  std::vector<int> N{1, 2, 3, 8};
  std::vector<double> d_hat{0.01};
  std::vector<double> kappa;
  double onset = ContactParams{}.onset;
  std::string against = "d";
  std::vector<double> gaps;
  PlotRunOptions run;  // without a scene: curves of the lists
};

const std::map<std::string, BarrierAbscissa> kAbscissas = {{"d", BarrierAbscissa::gap},
                                                           {"d-hat", BarrierAbscissa::d_hat},
                                                           {"N", BarrierAbscissa::order},
                                                           {"kappa", BarrierAbscissa::kappa}};

std::map<std::string, BarrierKind> kinds_by_word() {
  std::map<std::string, BarrierKind> out;
  for (const BarrierKind kind : kBarrierKinds) out[to_string(kind)] = kind;
  return out;
}

// The limits of the scene file hold here too.
void check_values(const BarrierCurves& curves) {
  const auto check = [](const char* option, double value, auto&& set) {
    Params params;
    params.contact.d_hat = 0.01;
    set(params.contact);
    if (const auto error = check_params(params)) {
      throw Error(ErrorKind::bad_input, fmt::format("{} {}: {}", option, value, error->message));
    }
  };
  for (const BarrierKind kind : curves.kinds) {
    const int least = traits_of(kind).least_N, most = *std::max_element(curves.N.begin(), curves.N.end());
    if (most < least)
      throw Error(ErrorKind::bad_input,
                  fmt::format("--N {}: the {} barrier has no term below N = {}; expected {} or more", most,
                              to_string(kind), least, least));
  }
  for (const int N : curves.N) check("--N", N, [&](ContactParams& c) { c.N = N; });
  for (const double d_hat : curves.d_hat) check("--d-hat", d_hat, [&](ContactParams& c) { c.d_hat = d_hat; });
  for (const double kappa : curves.kappa) check("--kappa", kappa, [&](ContactParams& c) { c.kappa = kappa; });
  check("--onset", curves.onset, [&](ContactParams& c) { c.onset = curves.onset; });
  for (const double gap : curves.gaps) {
    if (!std::isfinite(gap))
      throw Error(ErrorKind::bad_input, fmt::format("--gap {}: expected a distance in m", gap));
  }
  if (!curves.gaps.empty() && curves.abscissa == BarrierAbscissa::gap)
    throw Error(ErrorKind::bad_input, "--gap: the plot is against d; expected --against d-hat, N or kappa");
  if (curves.kappa.empty() && curves.abscissa == BarrierAbscissa::kappa)
    throw Error(ErrorKind::bad_input, "--against kappa: expected --kappa LIST, the values to be marked");
  const BarrierFigureSize size = size_of(curves);
  if (size.curves > kMostCurves) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{} curves in one plot: expected at most {}; shorten the lists", size.curves,
                            kMostCurves));
  }
  if (size.rows > kMostRows) {
    throw Error(ErrorKind::bad_input, fmt::format("{} rows of plots: expected at most {}; shorten the lists",
                                                  size.rows, kMostRows));
  }
}

int plot_contacts(const PlotBarrierOptions& options) {
  check_figure_output(options.output);
  FigureOutputOptions output = options.output;
  Session session = open_session(options.run.scene, options.common, options.run.from, output.inputs);
  check_figure_output(output);
  session.report_contacts(true);
  const int code = make_steps(session, plot_steps(options.run, session, "--at-step"), options.common.quiet,
                              [](const StepReport&) {});
  check_end(session, options.run.scene);
  const StepReport& report = session.report();
  Figure figure = contact_barrier_figure(session.params().contact, session.kappa(), report.step,
                                         report.contact_reports, contact_ink);
  figure.caption = run_caption(session.scene().name, report.step, session.params(), session.kappa(), true);
  write_drawing(drawing_of(figure), output);
  return code;
}

int plot_barrier(const PlotBarrierOptions& options) {
  if (!options.run.scene.empty()) return plot_contacts(options);
  BarrierCurves curves;
  curves.kinds.clear();
  for (const std::string& kind : options.kinds) curves.kinds.push_back(kinds_by_word().at(kind));
  curves.N = options.N;
  curves.d_hat = options.d_hat;
  curves.kappa = options.kappa;
  curves.onset = options.onset;
  curves.abscissa = kAbscissas.at(options.against);
  curves.gaps = options.gaps;
  check_values(curves);
  check_figure_output(options.output);
  write_drawing(drawing_of(barrier_figure(curves)), options.output);
  return 0;
}

}  // namespace

void add_plot_barrier_command(CLI::App& plot, Action& action) {
  auto options = std::make_shared<PlotBarrierOptions>();
  const Command command(
      plot, "barrier", "barrier curves against d, d̂, N or κ; of a scene, its law with the contacts of a step",
      {"pabd plot barrier -o barrier.png --N 1,2,3,8 --d-hat 0.01,0.02",
       "pabd plot barrier -o barrier.svg --kind polynomial,log,even --kappa 50 --onset 0",
       "pabd plot barrier -o thickness.pdf --against d-hat --N 3 --d-hat 0.01 --gap 0.005,0,-0.002",
       "pabd plot barrier -o - --N 3 > barrier.csv", "pabd plot barrier pyramid -o contacts.png --time 2"},
      options->common);
  using group::kOwn;
  using group::kSimulation;
  std::vector<std::string> words;
  for (const BarrierKind kind : kBarrierKinds) words.emplace_back(to_string(kind));
  auto* scene = command.argument(
      "SCENE", options->run.scene,
      "scene file, or the name of a shipped scene, for its own law; without it the lists below are drawn");
  command.list(kOwn, "--N", options->N, "highest orders (default 1,2,3,8)")->excludes(scene);
  command.list(kOwn, "--d-hat", options->d_hat, "contact thicknesses in m (default 0.01)", "m")
      ->excludes(scene);
  command.list(kOwn, "--kappa", options->kappa, "stiffnesses in J (default: plain B_N)", "J")
      ->excludes(scene);
  command
      .list(kOwn, "--kind", options->kinds, fmt::format("{} (default polynomial)", fmt::join(words, ", ")))
      ->check(CLI::IsMember(kinds_by_word()))
      ->excludes(scene);
  command
      .option(kOwn, "--onset", options->onset,
              fmt::format("onset width, 0 … below 1 (default {}, that of runs); 0: the printed formula",
                          options->onset),
              "E")
      ->excludes(scene);
  command
      .option(kOwn, "--against", options->against,
              "what stands on the horizontal axis: d, d-hat, N or kappa; the values given for it are "
              "marked there (default d)",
              "WORD")
      ->check(CLI::IsMember(kAbscissas))
      ->excludes(scene);
  command
      .list(kOwn, "--gap", options->gaps,
            "with --against d-hat, N or kappa: distances d in m that curves are for (default: half of the "
            "first d̂, 0, and an overlap of a quarter of it)",
            "m")
      ->excludes(scene);
  add_figure_output_options(command, options->output);
  auto* time =
      command.option(kSimulation, "--time", options->run.time,
                     "time whose contacts are drawn (default: the duration of the scene, or 5 s)", "S");
  time->needs(scene);
  command.option(kSimulation, "--at-step", options->run.steps, "the same as the number of a step", "K")
      ->excludes(time)
      ->needs(scene);
  command.from(options->run.from)->needs(scene);
  command.simulation(options->common);
  for (const char* name : {"--set", "--threads"}) command.app().get_option(name)->needs(scene);
  command.carry_out(action, options, plot_barrier);
}

}  // namespace pabd::cli
