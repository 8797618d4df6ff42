// SPDX-License-Identifier: MIT
// The glyphs of the embedded font as Dear ImGui fonts, one for every text size in use, and "d̂" as a glyph of
// its own.
//
// Sizes are found while painting: a size that is not there yet is noted, and the frame is painted once more
// after `bake`. So every glyph is rasterised for the very size it is drawn at, which is what keeps text
// crisp.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

struct ImFont;
struct ImFontAtlas;

namespace pabd {

class FontAtlas {
 public:
  using Upload = std::function<void*(const unsigned char* rgba, int width, int height)>;

  FontAtlas(ImFontAtlas& atlas, Upload upload);

  // The font for an em of `size` px (to half a pixel); while it is not baked, another one or null.
  ImFont* font(double size);
  // Notes a character that a font did not have.
  void request(char32_t code_point);

  // The next bake keeps only sizes asked for after this call. For a change of frame size.
  void forget_sizes();
  std::size_t size_count() const { return sizes_.size(); }

  bool stale() const { return stale_; }
  // Rasterises everything asked for so far and uploads it. Not within an ImGui frame.
  void bake();

  // Code points in every font whether or not a text asked for them: ASCII, Latin-1, Greek and the signs of
  // the method.
  static std::u32string standard_characters();

  std::u32string unknown() const { return {unknown_.begin(), unknown_.end()}; }

 private:
  struct Face {
    int half_pixels;  // em, in half pixels
    ImFont* font;
  };
  void add_d_hat(ImFont& font, double size, int oversample, int rect);

  ImFontAtlas& atlas_;
  Upload upload_;
  std::set<int> sizes_;  // half pixels
  std::vector<Face> faces_;
  std::set<char32_t> extra_;
  std::set<char32_t> unknown_;
  bool stale_ = true;
};

}  // namespace pabd
