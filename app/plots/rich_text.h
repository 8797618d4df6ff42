// SPDX-License-Identifier: MIT
// Text with sub- and superscripts, and its measures. Both painters place the same runs, so a plot is laid out
// once.
//
// Markup: `_{…}` subscript, `^{…}` superscript, `*{…}` italic; a subscript directly followed by a superscript
// (or the other way round) is stacked over it: "*{y}_{j}^{⊥}". Everything else is printed as it is. Malformed
// markup (no closing brace) is printed as it is too.
//
// Lengths are in em of the base size or in pixels as said; x to the right, y down, origin at the start of the
// baseline.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pabd {

// "d̂" is two code points, and few text engines put the hat in a good place. It is drawn as one glyph with
// this code point of the private-use area.
inline constexpr char32_t kDHat = 0xE000;

// Decodes UTF-8; "d" + U+0302 becomes kDHat. Invalid bytes become U+FFFD.
std::u32string decode_text(std::string_view utf8);

// UTF-8 in which "d̂" is replaced by the private-use glyph: for text that Dear ImGui draws itself.
std::string ui_text(std::string_view utf8);

// Without markup, as it would be typed: "B_{N}" → "B_N", "*{y}_{j}^{⊥}" → "y_j^⊥". For CSV.
std::string plain_text(std::string_view rich);

class FontMetrics {
 public:
  FontMetrics();
  ~FontMetrics();
  FontMetrics(FontMetrics&&) noexcept;
  FontMetrics& operator=(FontMetrics&&) noexcept;

  double advance(char32_t code_point) const;  // em
  bool has(char32_t code_point) const;

  // Of the whole font, in em: lines set `line` apart do not touch; digits and capitals are `cap` high.
  static constexpr double cap = 0.729;
  static constexpr double descent = 0.236;
  static constexpr double line = 1.35;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The two parts of d̂: the hat stands over the right stem of the d, a gap above it.
struct DHat {
  int d, hat;           // glyph indices in the embedded font
  double hat_x, hat_y;  // shift of the hat, in font units, y up
  int x0, y0, x1, y1;   // bounds of the whole, in font units
  int em;               // font units
};
DHat compose_d_hat();

struct TextRun {
  std::string text;  // UTF-8, no markup
  double x, y;       // start of its baseline; px
  double size;       // em in px
  double width;      // px
  bool italic;
};

struct TextLayout {
  std::vector<TextRun> runs;
  double width = 0;  // px
};

// Places `rich` at an em of `size` px.
TextLayout layout_text(const FontMetrics& font, std::string_view rich, double size);
double text_width(const FontMetrics& font, std::string_view rich, double size);

// `size`, or as much less as makes the text `width` px wide; 0 where that is less than `least`: then there is no room.
double fitted_size(const FontMetrics& font, std::string_view rich, double size, double least, double width);

// Breaks at blanks, though not within "N = 3", so that no line is wider than `width` px (a single word may be).
std::vector<std::string> wrap_text(const FontMetrics& font, std::string_view rich, double size, double width);

}  // namespace pabd
