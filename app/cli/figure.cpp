// pabd figure: the figures of the paper's supplement.
#include <fmt/format.h>

#include <memory>

#include "app/cli/backend_option.h"
#include "app/cli/figure_output.h"
#include "app/cli/frame_text.h"
#include "app/cli/simulation_setup.h"
#include "app/overlay/figure6.h"
#include "app/overlay/overlay.h"
#include "app/plots/figures/barrier.h"
#include "app/plots/figures/contact_pair.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/rich_text.h"
#include "render/gl/renderer.h"

namespace pabd::cli {
namespace {

struct FigureOptions {
  CommonOptions common;
  FigureOutputOptions output;
  int number = 0;
};

// Figures 6 and 7 are about the same scene.
Session two_boxes(const FigureOptions& options) { return open_session("two_boxes", options.common); }

Drawing draw(const FigureOptions& options) {
  switch (options.number) {
    case 1:
      return drawing_of(figure1());
    case 5:
      return {figure5(), {1600, 800}, [] { return contact_pair_csv(); }, {}};
    case 7: {
      const Session session = two_boxes(options);
      return drawing_of(
          figure7(session.model(), session.params(), session.state(), 100, options.common.thread_count()));
    }
    case 2:
    case 3:
    case 4:
      throw Error(
          ExitCode::bad_input,
          fmt::format("figure {} shows joints, which come with a later version; there are 1, 5, 6 and 7",
                      options.number));
    default:
      throw Error(
          ExitCode::bad_input,
          fmt::format("figure {}: the supplement has figures 1 … 7; expected 1, 5, 6 or 7", options.number));
  }
}

// The two boxes are drawn in three dimensions, as a frame is, with the chosen contact pair.
void write_figure6(const FigureOptions& options) {
  if (!is_png_output(options.output)) {
    throw Error(ExitCode::bad_input, fmt::format("-o {}: figure 6 is a rendered picture; name a .png",
                                                 options.output.output.path));
  }
  const PictureSize size = output_size(options.output, {1600, 1000});
  const Session session = two_boxes(options);
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(parse_backend(options.output.backend), attempts);
  Renderer renderer(*context, size.width, size.height);
  Overlay overlay(
      [&](const unsigned char* rgba, int w, int h) { return renderer.upload_font_atlas(rgba, w, h); });
  const Figure6 picture = figure6(session.model(), session.params(), session.state(),
                                  static_cast<double>(size.width) / size.height);
  renderer.draw(picture.scene, overlay.frame({}, {}, &picture.scene, size.width, size.height));
  renderer.queue_read();
  Image image;
  renderer.fetch(image);
  ViewFacts view{size.width, size.height, 0, "figure 6", "figure 6", renderer.gl_renderer()};
  PngText text = common_text(session, view);
  text["Caption"] = plain_text(picture.caption);
  write_png(options.output.output.path, image, text);
}

int figure(const FigureOptions& options) {
  check_figure_output(options.output);
  if (options.number == 6) {
    write_figure6(options);
    return 0;
  }
  write_drawing(draw(options), options.output);
  return 0;
}

}  // namespace

void add_figure_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<FigureOptions>();
  CLI::App* command =
      add_command(app, "figure", "draw a figure of the paper's supplement: 1, 5, 6 or 7",
                  {"pabd figure 1 -o barrier.svg", "pabd figure 7 -o convergence.png --size 1600x900",
                   "pabd figure 7 -o - > convergence.csv"},
                  options->common);
  command->add_option("K", options->number, "number of the figure")->required();
  add_figure_output_options(*command, options->output);
  add_scene_options(*command, options->common);
  command->callback([options, &action] { action = [options] { return figure(*options); }; });
}

}  // namespace pabd::cli
