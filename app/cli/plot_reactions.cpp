// SPDX-License-Identifier: MIT
// pabd plot reactions: forces and errors of joints over time.
#include <fmt/format.h>

#include <memory>

#include "app/cli/figure_output.h"
#include "app/cli/plot_run.h"
#include "app/plots/figures/reactions.h"
#include "app/plots/figures/run_caption.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

constexpr std::size_t kMostJoints = 8;            // in one plot
constexpr std::size_t kMostNumbers = 20'000'000;  // forces that are kept until the strongest are known

struct PlotReactionsOptions {
  CommonOptions common;
  FigureOutputOptions output;
  PlotRunOptions run;
  std::vector<std::string> joints;
};

// The joints with these names; without names all.
std::vector<std::size_t> chosen(const Model& model, const std::vector<std::string>& names,
                                const std::string& scene) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; names.empty() && k < model.joints.size(); ++k) out.push_back(k);
  for (const std::string& name : names) {
    const std::size_t before = out.size();
    for (std::size_t k = 0; k < model.joints.size(); ++k)
      if (model.joints[k].name == name) out.push_back(k);
    if (out.size() > before) continue;
    std::string known;
    for (std::size_t k = 0; k < std::min<std::size_t>(model.joints.size(), 20); ++k)
      known += (k == 0 ? "" : ", ") + model.joints[k].name;
    throw Error(ErrorKind::bad_input,
                fmt::format("--joint {}: {} has none of this name; expected one of {}{}", name, scene, known,
                            model.joints.size() > 20 ? ", …" : ""));
  }
  if (!names.empty() && out.size() > kMostJoints)
    throw Error(ErrorKind::bad_input, fmt::format("--joint: {} have these names; expected at most {}",
                                                  counted(out.size(), "joint"), kMostJoints));
  return out;
}

int plot_reactions(const PlotReactionsOptions& options) {
  check_figure_output(options.output);
  FigureOutputOptions output = options.output;
  const std::string& scene = options.run.scene;
  Session session = open_session(scene, options.common, options.run.from, output.inputs);
  check_figure_output(output);
  const Model& model = session.model();
  if (model.joints.empty())
    throw Error(ErrorKind::bad_input, scene, "no joints; expected a scene that has some");
  const std::vector<std::size_t> shown = chosen(model, options.joints, scene);
  const std::int64_t steps = plot_steps(options.run, session);
  if (static_cast<double>(steps) * static_cast<double>(shown.size()) > kMostNumbers)
    throw Error(ErrorKind::bad_input,
                fmt::format("{} steps of {}: expected at most {} forces; name joints with --joint", steps,
                            counted(shown.size(), "joint"), kMostNumbers));
  std::vector<double> time;
  std::vector<JointSeries> series;
  for (const std::size_t k : shown) series.push_back({model.joints[k].name, {}, {}});
  session.report_joints(true);
  const int code = make_steps(session, steps, options.common.quiet, [&](const StepReport& report) {
    time.push_back(report.time);
    for (std::size_t k = 0; k < shown.size(); ++k) {
      series[k].force.push_back(report.joint_reports[shown[k]].force.norm());
      series[k].error.push_back(report.joint_reports[shown[k]].error);
    }
  });
  if (options.joints.empty()) keep_strongest(series, kMostJoints);
  Figure figure = reactions_figure(time, series);
  figure.caption =
      run_caption(session.scene().name, session.state().step, session.params(), session.kappa(), true);
  if (series.size() < model.joints.size())
    figure.caption += fmt::format(". {} of {}{}", series.size(), counted(model.joints.size(), "joint"),
                                  options.joints.empty() ? ": those with the largest forces" : "");
  write_drawing(drawing_of(figure), output);
  check_end(session, scene);
  return code;
}

}  // namespace

void add_plot_reactions_command(CLI::App& plot, Action& action) {
  auto options = std::make_shared<PlotReactionsOptions>();
  const Command command(plot, "reactions", "forces through joints, and their errors, over time",
                        {"pabd plot reactions bridge -o bridge.png --time 4",
                         "pabd plot reactions four_bar -o crank.svg --joint drive --joint 'joint 3'"},
                        options->common);
  command.scene(options->run.scene);
  command.repeated(
      group::kOwn, "--joint", options->joints,
      "name of a joint, or the number of one without; may be given several times (default: the joints "
      "with the largest forces, at most 8)",
      "NAME");
  add_figure_output_options(command, options->output);
  add_plot_run_options(command, options->run);
  command.simulation(options->common);
  command.carry_out(action, options, plot_reactions);
}

}  // namespace pabd::cli
