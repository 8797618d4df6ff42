// SPDX-License-Identifier: MIT
// Writing plots.
#include "app/cli/figure_output.h"

#include <fmt/format.h>

#include "app/cli/streams.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

enum class Format { png, svg, pdf, csv };

Format format_of(const FigureOutputOptions& options) {
  const std::string& path = options.output.path;
  const std::string ending = path == "-" ? (options.format.empty() ? ".csv" : "." + options.format)
                                         : std::filesystem::path(path).extension().string();
  if (ending == ".png" && path != "-") return Format::png;
  if (ending == ".svg") return Format::svg;
  if (ending == ".pdf") return Format::pdf;
  if (ending == ".csv") return Format::csv;
  throw Error(
      ErrorKind::bad_input,
      fmt::format(
          "-o {}: expected a name that ends in .png, .svg, .pdf or .csv, or - with --format svg, pdf or csv",
          path));
}

bool on_screen(const FigureOutputOptions& options) { return options.style == "screen"; }

// With its paper.
Picture styled(const Drawing& drawing, const FigureOutputOptions& options) {
  if (!on_screen(options)) return drawing.picture;
  if (!drawing.screen) {
    throw Error(ErrorKind::bad_input,
                "--style screen: this figure is a drawing on white; expected paper, or another figure");
  }
  return [&drawing](Canvas& canvas, double width, double height) {
    canvas.fill_rect({0, 0, width, height}, dark_theme().paper, 0);
    drawing.screen(canvas, width, height);
  };
}

void write_as_png(const Picture& picture, const Drawing& drawing, const PictureSize& size,
                  const FigureOutputOptions& options) {
  PngText text = drawing.text;
  text["Software"] = "pabd " PABD_VERSION;
  write_png(options.output.path, picture_to_image(picture, size.width, size.height), text);
}

void write_text(const std::string& text, const FigureOutputOptions& options) {
  TextOutput output("-o", options.output.path, options.output.force, options.inputs);
  output.write(text);
  output.finish();
}

}  // namespace

void add_figure_output_options(const Command& command, FigureOutputOptions& options) {
  using namespace group;
  command.output(options.output, ".png, .svg, .pdf or .csv; - is standard output");
  command.word(kOutput, "--format", options.format, {"svg", "pdf", "csv"},
               "what -o - writes: svg, pdf or csv (default csv)", "KIND");
  command.word(kPicture, "--style", options.style, {"paper", "screen"},
               "paper: on white; screen: light on dark, as the window (default paper)", "STYLE");
  command.option(kPicture, "--size", options.size, "pixels (default: what suits it)", "WxH");
}

void check_figure_output(const FigureOutputOptions& options) {
  format_of(options);
  if (!options.size.empty()) parse_size(options.size);
  const std::string& path = options.output.path;
  if (path != "-") check_overwrite("-o " + path, path, {options.output.force, &options.inputs});
}

Drawing drawing_of(const Figure& figure) {
  return {figure_picture(figure),
          default_size(figure),
          [figure] { return figure_to_csv(figure); },
          {},
          figure_picture(figure, dark_theme())};
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
  if (format == Format::csv && drawing.csv) {
    write_text(drawing.csv(), options);
    return;
  }
  const Picture picture = styled(drawing, options);
  if (format == Format::png) {
    write_as_png(picture, drawing, size, options);
    return;
  }
  if (format == Format::csv && !drawing.csv) {
    throw Error(ErrorKind::bad_input,
                fmt::format("-o {}: this figure is a drawing without data; name a .png, .svg or .pdf",
                            options.output.path));
  }
  write_text(format == Format::svg ? picture_to_svg(picture, size.width, size.height)
                                   : picture_to_pdf(picture, size.width, size.height),
             options);
}

}  // namespace pabd::cli
