// SPDX-License-Identifier: MIT
// Where plots go: .png, .svg, .pdf or .csv.
#pragma once

#include <functional>
#include <string>

#include "app/cli/common.h"
#include "app/plots/figure.h"
#include "render/output/png.h"
#include "sim/base/output_path.h"

namespace pabd::cli {

struct FigureOutputOptions {
  OutputOptions output;
  std::string
      format;  // "svg", "pdf" or "csv", for standard output; empty: csv there, and from the name elsewhere
  std::string style = "paper";  // or "screen": light on dark
  std::string size;             // "1600x700"; empty: what suits the figure
  InputFiles inputs;            // that are never overwritten
};
void add_figure_output_options(const Command& command, FigureOutputOptions& options);

// Throws Error(bad_input) for a name with another ending than .png, .svg, .pdf, .csv, a file that exists without
// --force, or one that is read: before the work.
void check_figure_output(const FigureOutputOptions& options);

// What is to be written, in every form it can have.
struct Drawing {
  Picture picture;                   // on white
  PictureSize size;                  // when --size does not say
  std::function<std::string()> csv;  // may be empty: a picture without data
  PngText text;                      // chunks of the PNG, besides Software
  Picture screen = {};               // --style screen; empty: it is a drawing for paper
};
Drawing drawing_of(const Figure& figure);

// True when the output is a .png: the only form that a picture in three dimensions has.
bool is_png_output(const FigureOutputOptions& options);
// The size asked for, or else `fallback`.
PictureSize output_size(const FigureOutputOptions& options, PictureSize fallback);

// Throws Error(file), Error(bad_input).
void write_drawing(const Drawing& drawing, const FigureOutputOptions& options);

}  // namespace pabd::cli
