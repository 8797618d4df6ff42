// SPDX-License-Identifier: MIT
// Writing plots.
#include "app/cli/figure_output.h"

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "app/cli/backend_option.h"
#include "app/cli/streams.h"
#include "app/overlay/overlay.h"
#include "render/gl/renderer.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

enum class Format { png, svg, csv };

Format format_of(const FigureOutputOptions& options) {
  const std::string& path = options.output.path;
  const std::string ending = path == "-" ? (options.format.empty() ? ".csv" : "." + options.format)
                                         : std::filesystem::path(path).extension().string();
  if (ending == ".png" && path != "-") return Format::png;
  if (ending == ".svg") return Format::svg;
  if (ending == ".csv") return Format::csv;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("-o {}: expected a name that ends in .png, .svg or .csv, or - with --format svg or csv",
                  path));
}

void write_as_png(const Drawing& drawing, const PictureSize& size, const FigureOutputOptions& options) {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(parse_backend(options.backend), attempts);
  Renderer renderer(*context, size.width, size.height);
  Overlay overlay(
      [&](const unsigned char* rgba, int w, int h) { return renderer.upload_font_atlas(rgba, w, h); });
  renderer.draw_plain(overlay.paint(drawing.picture, size.width, size.height), Vec3f(1, 1, 1));
  renderer.queue_read();
  Image image;
  renderer.fetch(image);
  PngText text = drawing.text;
  text["Software"] = "pabd " PABD_VERSION;
  text["GL_RENDERER"] = renderer.gl_renderer();
  write_png(options.output.path, image, text);
}

}  // namespace

void add_figure_output_options(CLI::App& command, FigureOutputOptions& options) {
  add_output_options(command, options.output, ".png, .svg or .csv; - is standard output");
  command.add_option("--format", options.format, "for -o - (default csv)")
      ->check(CLI::IsMember({"svg", "csv"}));
  command.add_option("--size", options.size, "pixels (default: what suits it)")->type_name("WxH");
  add_backend_option(command, options.backend);
}

void check_figure_output(const FigureOutputOptions& options) {
  format_of(options);
  if (!options.size.empty()) parse_size(options.size);
  const std::string& path = options.output.path;
  if (path != "-") check_overwrite("-o " + path, path, {options.output.force, &options.inputs});
}

Drawing drawing_of(const Figure& figure) {
  return {figure_picture(figure), default_size(figure), [figure] { return figure_to_csv(figure); }, {}};
}

bool is_png_output(const FigureOutputOptions& options) { return format_of(options) == Format::png; }

PictureSize output_size(const FigureOutputOptions& options, PictureSize fallback) {
  if (options.size.empty()) return fallback;
  const FrameSize size = parse_size(options.size);
  return {size.width, size.height};
}

void write_drawing(const Drawing& drawing, const FigureOutputOptions& options) {
  const Format format = format_of(options);
  const PictureSize size = output_size(options, drawing.size);
  if (format == Format::png) {
    write_as_png(drawing, size, options);
    return;
  }
  if (format == Format::csv && !drawing.csv) {
    throw Error(ErrorKind::bad_input,
                fmt::format("-o {}: this figure is a drawing without data; name a .png or .svg",
                            options.output.path));
  }
  TextOutput output("-o", options.output.path, options.output.force, options.inputs);
  output.write(format == Format::svg ? picture_to_svg(drawing.picture, size.width, size.height)
                                     : drawing.csv());
  output.finish();
}

}  // namespace pabd::cli
