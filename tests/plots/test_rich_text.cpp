// SPDX-License-Identifier: MIT
// Markup, widths, and the one glyph for "d̂".
#include <catch2/catch.hpp>

#include "app/plots/font_data.h"
#include "app/plots/rich_text.h"

namespace pabd::test_rich_text {

TEST_CASE("the embedded font is a TrueType file") {
  const auto bytes = font_bytes();
  REQUIRE(bytes.size() > 100000);
  CHECK(bytes[0] == 0);
  CHECK(bytes[1] == 1);
  CHECK(bytes[2] == 0);
  CHECK(bytes[3] == 0);
}

TEST_CASE("sub- and superscripts are smaller, moved, and stacked when they follow each other") {
  const FontMetrics font;
  const TextLayout text = layout_text(font, "*{y}_{j}^{⊥} x", 20);
  REQUIRE(text.runs.size() == 4);
  CHECK(text.runs[0].text == "y");
  CHECK(text.runs[0].italic);
  CHECK(text.runs[1].y > 0);
  CHECK(text.runs[2].y < 0);
  CHECK(text.runs[1].size < 20);
  CHECK(text.runs[1].x == text.runs[2].x);
  CHECK(text.runs[3].x == Approx(text.runs[2].x + std::max(text.runs[1].width, text.runs[2].width)));
  CHECK(text.width == Approx(text.runs[3].x + text.runs[3].width));
}

TEST_CASE("what is no markup is printed as it is") {
  const FontMetrics font;
  for (const char* text : {"two_boxes", "a^b", "2*3", "_{open", "^", "*{"}) {
    const TextLayout layout = layout_text(font, text, 10);
    std::string joined;
    for (const TextRun& run : layout.runs) joined += run.text;
    CHECK(joined == text);
    CHECK(plain_text(text) == text);
  }
  CHECK(plain_text("B_{N}′(d) [1/m]") == "B_N′(d) [1/m]");
  CHECK(plain_text("*{y}_{j}^{⊥}") == "y_j^⊥");
}

TEST_CASE("d with a combining circumflex is one character as wide as d") {
  CHECK(decode_text("d̂ = 1") == std::u32string{kDHat, U' ', U'=', U' ', U'1'});
  CHECK(ui_text("d̂") == "\xEE\x80\x80");
  const FontMetrics font;
  CHECK(text_width(font, "d̂", 10) == Approx(text_width(font, "d", 10)));
}

TEST_CASE("broken UTF-8 becomes replacement characters") {
  CHECK(decode_text("a\xFF\x62") == std::u32string{U'a', U'\uFFFD', U'b'});
  CHECK(decode_text("\xE2\x82") == std::u32string{U'\uFFFD'});
}

TEST_CASE("wrapped lines keep every word and the width") {
  const FontMetrics font;
  const std::string text = "one two three four five six seven eight nine ten";
  const auto lines = wrap_text(font, text, 10, 80);
  REQUIRE(lines.size() > 1);
  std::string joined;
  for (const std::string& line : lines) {
    CHECK(text_width(font, line, 10) <= 80);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(joined == text);
}

TEST_CASE("an equation is not broken between lines") {
  const FontMetrics font;
  const std::string text = "a pile, N = 3, ε = 0.2, a = b = c and the end of it";
  for (double width = 10; width < 500; width += 7) {
    CAPTURE(width);
    std::string joined;
    for (const std::string& line : wrap_text(font, text, 12, width)) {
      CHECK_FALSE(line.starts_with("="));
      CHECK_FALSE(line.ends_with("="));
      joined += (joined.empty() ? "" : " ") + line;
    }
    CHECK(joined == text);
  }
}

TEST_CASE("a text that is too wide gets smaller, and none where it could not be read") {
  const FontMetrics font;
  const double width = text_width(font, "a title", 20);
  CHECK(fitted_size(font, "a title", 20, 10, width + 1) == 20);
  CHECK(text_width(font, "a title", fitted_size(font, "a title", 20, 10, 0.7 * width)) ==
        Approx(0.7 * width));
  CHECK(fitted_size(font, "a title", 20, 10, 0.4 * width) == 0);
}

}  // namespace pabd::test_rich_text
