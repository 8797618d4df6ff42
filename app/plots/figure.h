// SPDX-License-Identifier: MIT
// A figure laid out and painted, and written as SVG, PDF, pixels or CSV.
#pragma once

#include <string>
#include <vector>

#include "app/plots/canvas.h"
#include "app/plots/plot_layout.h"
#include "render/output/image.h"

namespace pabd {

struct FigureLayout {
  PlotStyle style;
  Rect title;
  std::vector<Rect> cells;  // one a plot, in rows of `columns`
  Rect caption;
  std::vector<std::string> caption_lines;
};

struct PictureSize {
  int width, height;
};
// What a figure looks best at: 1600 × 700 for two columns.
PictureSize default_size(const Figure& figure);

// A small figure leaves out what would not be readable: its caption, its title, its last plots.
FigureLayout layout_figure(const Figure& figure, double width, double height, const FontMetrics& font,
                           const PlotTheme& theme = light_theme());
// What figures and heat maps have in the middle: a title with its top at y, and the lines of a caption from y down.
void paint_title(const std::string& title, double width, double y, const PlotStyle& style, Canvas& canvas);
void paint_caption(const std::vector<std::string>& lines, double width, double y, const PlotStyle& style,
                   Canvas& canvas);
Picture figure_picture(Figure figure, const PlotTheme& theme = light_theme());

// A whole SVG document. Text stays text, in DejaVu Sans or what comes next to it.
std::string picture_to_svg(const Picture& picture, int width, int height, Color paper = ink::paper);
// The same as a PDF document of one page, its font embedded; 3/4 pt a pixel. Throws Error(defect).
std::string picture_to_pdf(const Picture& picture, int width, int height, Color paper = ink::paper);
// The same as pixels. Throws Error(defect).
Image picture_to_image(const Picture& picture, int width, int height, Color paper = ink::paper);
std::string figure_to_svg(const Figure& figure, int width, int height,
                          const PlotTheme& theme = light_theme());

// Long format with a header: plot,series,x,y. Names without markup; numbers as short as reading them back
// exactly allows, "nan", "inf" and "-inf" included. A level has an empty x (or y). Lines end with \n; names
// that need it are quoted as in RFC 4180.
std::string figure_to_csv(const Figure& figure);

}  // namespace pabd
