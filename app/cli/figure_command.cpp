// SPDX-License-Identifier: MIT
// pabd figure: the figures of the paper's supplement.
#include <fmt/format.h>

#include <memory>

#include "app/cli/figure_output.h"
#include "app/cli/simulation_setup.h"
#include "app/frames/frame_text.h"
#include "app/overlay/figure2.h"
#include "app/overlay/figure6.h"
#include "app/overlay/overlay.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/contact_pair.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/slider_joint.h"
#include "app/plots/figures/spherical_joint.h"
#include "app/plots/rich_text.h"
#include "render/gl/renderer.h"

namespace pabd::cli {
namespace {

struct FigureOptions {
  CommonOptions common;
  FigureOutputOptions output;
  std::string backend = "auto";  // of figures 2 and 6
  int number = 0;
};

// Figures 6 and 7 are about the same scene.
Session two_boxes(const FigureOptions& options) {
  InputFiles inputs;  // shipped with the program, and no output
  return open_session("two_boxes", options.common, "", inputs);
}

Drawing draw(const FigureOptions& options) {
  switch (options.number) {
    case 1:
      return drawing_of(figure1());
    case 3:
      return {figure3(), {1600, 800}, [] { return spherical_joint_csv(); }, {}};
    case 4:
      return {figure4(), {1600, 800}, [] { return slider_joint_csv(); }, {}};
    case 5:
      return {figure5(), {1600, 800}, [] { return contact_pair_csv(); }, {}};
    case 7: {
      const Session session = two_boxes(options);
      return drawing_of(
          figure7(session.model(), session.params(), session.state(), 100, options.common.thread_count()));
    }
    default:
      throw Error(
          ErrorKind::bad_input,
          fmt::format("figure {}: the supplement has figures 1 … 7; expected one of them", options.number));
  }
}

// Size of a rendered picture.
PictureSize rendered_size(const FigureOptions& options, PictureSize fallback) {
  if (!is_png_output(options.output)) {
    throw Error(ErrorKind::bad_input, fmt::format("-o {}: figure {} is a rendered picture; name a .png",
                                                  options.output.output.path, options.number));
  }
  return output_size(options.output, fallback);
}

// A scene as a frame is drawn; returns the name of the driver.
std::string render_scene(const VisualScene& scene, const PictureSize& size, Image& image) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  Renderer renderer(*context, size.width, size.height);
  Overlay overlay(
      [&](const unsigned char* rgba, int w, int h) { return renderer.upload_font_atlas(rgba, w, h); });
  renderer.draw(scene, overlay.frame({}, {}, &scene, size.width, size.height));
  renderer.queue_read();
  renderer.fetch(image);
  return renderer.gl_renderer();
}

double aspect(const PictureSize& size) { return static_cast<double>(size.width) / size.height; }

void write_figure2(const FigureOptions& options) {
  const PictureSize size = rendered_size(options, {1600, 700});
  Image image;
  const std::string driver = render_scene(figure2(aspect(size)), size, image);
  write_png(options.output.output.path, image,
            {{"Software", "pabd " PABD_VERSION},
             {"Caption", "The three lower pairs slider, hinge and spherical joint"},
             {"GL_RENDERER", driver}});
}

// The two boxes with the chosen contact pair.
void write_figure6(const FigureOptions& options) {
  const PictureSize size = rendered_size(options, {1600, 1000});
  const Session session = two_boxes(options);
  const Figure6 picture = figure6(session.model(), session.params(), session.state(), aspect(size));
  Image image;
  const std::string driver = render_scene(picture.scene, size, image);
  PngText text = common_text(session.scene(), {size.width, size.height, 0, "figure 6", "figure 6", driver},
                             session.view());
  text["Caption"] = plain_text(picture.caption);
  write_png(options.output.output.path, image, text);
}

int figure(const FigureOptions& options) {
  check_figure_output(options.output);
  if (options.number == 2) {
    write_figure2(options);
  } else if (options.number == 6) {
    write_figure6(options);
  } else {
    write_drawing(draw(options), options.output);
  }
  return 0;
}

}  // namespace

void add_figure_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<FigureOptions>();
  const Command command(
      app, "figure", "draw a figure of the paper's supplement: 1 … 7",
      {"pabd figure 1 -o barrier.svg", "pabd figure 2 -o joints.png",
       "pabd figure 7 -o convergence.png --size 1600x900", "pabd figure 7 -o - > convergence.csv"},
      options->common);
  command.argument("K", options->number, "number of the figure")->required();
  add_figure_output_options(command, options->output);
  command.simulation(options->common);
  command.carry_out(action, options, figure);
}

}  // namespace pabd::cli
