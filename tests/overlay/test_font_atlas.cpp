// SPDX-License-Identifier: MIT
// The atlas holds every glyph the texts use, and a d̂ that is a d with a hat.
#include <imgui.h>
#include <catch2/catch.hpp>

#include "app/overlay/font_atlas.h"
#include "app/plots/rich_text.h"

namespace pabd::test_font_atlas {

namespace {

struct Baked {
  ImFontAtlas atlas;
  int uploads = 0;
  FontAtlas fonts{atlas, [this](const unsigned char*, int, int) {
                    ++uploads;
                    return nullptr;
                  }};
  explicit Baked(double size) {
    fonts.font(size);
    fonts.bake();
  }
};

// Darkness of the glyph's pixels in rows [from, to) of its quad, 0 … 1 of its height.
double coverage(ImFontAtlas& atlas, const ImFontGlyph& glyph, double from, double to) {
  unsigned char* alpha = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&alpha, &width, &height);
  const int x0 = static_cast<int>(glyph.U0 * static_cast<float>(width) + 0.5f);
  const int x1 = static_cast<int>(glyph.U1 * static_cast<float>(width) + 0.5f);
  const double v0 = static_cast<double>(glyph.V0) * height, v1 = static_cast<double>(glyph.V1) * height;
  double sum = 0;
  for (int y = static_cast<int>(v0 + from * (v1 - v0)); y < static_cast<int>(v0 + to * (v1 - v0)); ++y) {
    for (int x = x0; x < x1; ++x) sum += alpha[y * width + x] / 255.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("every character of the method has a glyph at every size") {
  for (const double size : {8.0, 12.0, 25.0, 60.0}) {
    Baked baked(size);
    const ImFont* font = baked.fonts.font(size);
    REQUIRE(font);
    for (const char32_t c : decode_text("d̂κφεΨψλμρθω‖⊥∥⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃ₙ′″·×−≤≥≠≈→∞∇√–—…°AZaz09[]/")) {
      INFO("U+" << std::hex << static_cast<unsigned>(c) << " at " << size);
      CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(c)) != nullptr);
    }
    for (const char32_t c : FontAtlas::standard_characters()) {
      INFO("U+" << std::hex << static_cast<unsigned>(c));
      CHECK(font->FindGlyphNoFallback(static_cast<ImWchar>(c)) != nullptr);
    }
  }
}

TEST_CASE("d̂ is a d with a hat above, as wide as d") {
  Baked baked(16);
  const ImFont* font = baked.fonts.font(16);
  const ImFontGlyph* d = font->FindGlyphNoFallback('d');
  const ImFontGlyph* hatted = font->FindGlyphNoFallback(static_cast<ImWchar>(kDHat));
  REQUIRE(d);
  REQUIRE(hatted);
  CHECK(hatted->Y0 < d->Y0 - 2);                   // rises above the d
  CHECK(hatted->Y1 == Approx(d->Y1).margin(1.5));  // same foot
  CHECK(hatted->AdvanceX == Approx(d->AdvanceX).margin(0.05));
  const double whole = coverage(baked.atlas, *hatted, 0, 1), bare = coverage(baked.atlas, *d, 0, 1);
  CHECK(whole > 1.05 * bare);
  CHECK(whole < 1.6 * bare);
  CHECK(coverage(baked.atlas, *hatted, 0, 0.2) > 0.02 * whole);  // the hat itself
}

TEST_CASE("new sizes and characters make the atlas stale, unknown ones do not") {
  Baked baked(12);
  CHECK(baked.uploads == 1);
  CHECK_FALSE(baked.fonts.stale());
  baked.fonts.font(12.1);  // rounds to the same half pixel
  CHECK_FALSE(baked.fonts.stale());
  baked.fonts.request(0x4E00);  // not in DejaVu Sans
  CHECK_FALSE(baked.fonts.stale());
  CHECK(baked.fonts.unknown() == U"一");
  baked.fonts.request(0x416);  // Cyrillic: is
  CHECK(baked.fonts.stale());
  baked.fonts.bake();
  CHECK(baked.fonts.font(12)->FindGlyphNoFallback(0x416) != nullptr);
}

}  // namespace pabd::test_font_atlas
