// SPDX-License-Identifier: MIT
// The glyphs of the embedded font as Dear ImGui fonts.
#include "app/overlay/font_atlas.h"

#include <imgui.h>
#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/plots/font_data.h"
#include "app/plots/rich_text.h"

namespace pabd {
namespace {

// Frames up to 8K; beyond, glyphs are drawn enlarged.
constexpr int kLargestHalfPixels = 300;
constexpr std::size_t kMostExtra =
    2000;  // characters beyond the standard ones, from scene names and the like

// Dear ImGui measures a font by ascent − descent, the canvas by the em.
struct FontFile {
  stbtt_fontinfo info;
  float line_per_em;  // (ascent − descent) / em

  FontFile() {
    const unsigned char* bytes = font_bytes().data();
    if (stbtt_InitFont(&info, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)) == 0) {
      throw std::logic_error("the embedded font cannot be read");
    }
    int up = 0, down = 0, gap = 0;
    stbtt_GetFontVMetrics(&info, &up, &down, &gap);
    const float unit = stbtt_ScaleForMappingEmToPixels(&info, 1.0f);
    line_per_em = static_cast<float>(up - down) * unit;
  }
};

// Horizontal sub-pixel steps: small text needs them for even spacing, large text only pays for them.
int oversampling(double size) { return size < 22 ? 3 : size < 44 ? 2 : 1; }

struct PixelBox {
  int x0, y0, w, h;  // px, x oversampled; y down from the baseline
};

PixelBox d_hat_box(const stbtt_fontinfo& info, const DHat& glyph, double size, int oversample) {
  const double scale = size * static_cast<double>(stbtt_ScaleForMappingEmToPixels(&info, 1.0f));
  const int x0 = static_cast<int>(std::floor(glyph.x0 * scale * oversample)) - 1;
  const int x1 = static_cast<int>(std::ceil(glyph.x1 * scale * oversample)) + oversample;
  const int y0 = static_cast<int>(std::floor(-glyph.y1 * scale)) - 1;
  const int y1 = static_cast<int>(std::ceil(-glyph.y0 * scale)) + 1;
  return {x0, y0, x1 - x0, y1 - y0};
}

// Adds one glyph, shifted by (dx, dy) px, to a coverage bitmap; the darker one wins where two meet.
void blend_glyph(const stbtt_fontinfo& info, int glyph, double scale_x, double scale_y, double dx, double dy,
                 const PixelBox& box, std::vector<unsigned char>& bitmap) {
  const double fx = dx - std::floor(dx), fy = dy - std::floor(dy);
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  const auto sx = static_cast<float>(scale_x), sy = static_cast<float>(scale_y);
  stbtt_GetGlyphBitmapBoxSubpixel(&info, glyph, sx, sy, static_cast<float>(fx), static_cast<float>(fy), &x0,
                                  &y0, &x1, &y1);
  const int w = x1 - x0, h = y1 - y0;
  if (w <= 0 || h <= 0) return;
  std::vector<unsigned char> part(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  stbtt_MakeGlyphBitmapSubpixel(&info, part.data(), w, h, w, sx, sy, static_cast<float>(fx),
                                static_cast<float>(fy), glyph);
  const int left = x0 + static_cast<int>(std::floor(dx)) - box.x0,
            top = y0 + static_cast<int>(std::floor(dy)) - box.y0;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const int tx = left + x, ty = top + y;
      if (tx < 0 || ty < 0 || tx >= box.w || ty >= box.h) continue;
      unsigned char& target = bitmap[static_cast<std::size_t>(ty * box.w + tx)];
      target = std::max(target, part[static_cast<std::size_t>(y * w + x)]);
    }
  }
}

// Running mean over `n` columns, as the rasteriser of the other glyphs does when it oversamples.
void smooth_rows(const PixelBox& box, int n, std::vector<unsigned char>& bitmap) {
  if (n < 2) return;
  std::vector<unsigned char> row(static_cast<std::size_t>(box.w));
  for (int y = 0; y < box.h; ++y) {
    unsigned char* p = &bitmap[static_cast<std::size_t>(y * box.w)];
    std::copy(p, p + box.w, row.begin());
    for (int x = 0; x < box.w; ++x) {
      int sum = 0;
      for (int k = 0; k < n; ++k) sum += x >= k ? row[static_cast<std::size_t>(x - k)] : 0;
      p[x] = static_cast<unsigned char>(sum / n);
    }
  }
}

}  // namespace

FontAtlas::FontAtlas(ImFontAtlas& atlas, Upload upload) : atlas_(atlas), upload_(std::move(upload)) {
  atlas_.Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
  sizes_.insert(24);
}

std::u32string FontAtlas::standard_characters() {
  std::u32string out;
  for (char32_t c = 0x20; c < 0x7F; ++c) out += c;
  for (char32_t c = 0xA0; c < 0x100; ++c) out += c;
  for (char32_t c = 0x391; c < 0x3CA; ++c) {
    if (c != 0x3A2) out += c;  // not assigned
  }
  out += U"ϕ–—‘’“”•…′″‖←↑→↓∂∇∈−·√∝∞∥∫≈≠≤≥⊥⌊⌋ˆ∑±×Δ";
  out += U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻₀₁₂₃₄₅₆₇₈₉ₙ";
  out += U'\uFFFD';
  return out;
}

void FontAtlas::forget_sizes() { sizes_.clear(); }

ImFont* FontAtlas::font(double size) {
  const int wanted = std::clamp(static_cast<int>(std::lround(2 * size)), 4, kLargestHalfPixels);
  if (sizes_.insert(wanted).second) stale_ = true;
  const auto nearest = std::min_element(faces_.begin(), faces_.end(), [wanted](const Face& a, const Face& b) {
    return std::abs(a.half_pixels - wanted) < std::abs(b.half_pixels - wanted);
  });
  return nearest == faces_.end() ? nullptr : nearest->font;
}

void FontAtlas::request(char32_t code_point) {
  if (code_point > IM_UNICODE_CODEPOINT_MAX || unknown_.contains(code_point) || extra_.size() >= kMostExtra) {
    unknown_.insert(code_point);
    return;
  }
  const FontFile face;
  if (stbtt_FindGlyphIndex(&face.info, static_cast<int>(code_point)) == 0) {
    unknown_.insert(code_point);
  } else if (extra_.insert(code_point).second) {
    stale_ = true;
  }
}

void FontAtlas::bake() {
  const FontFile face;
  atlas_.Clear();
  faces_.clear();
  std::set<char32_t> characters(extra_);
  for (const char32_t c : standard_characters()) characters.insert(c);
  std::vector<ImWchar> ranges;  // pairs first, last; ends with 0; must live until Build
  for (const char32_t c : characters) {
    const auto w = static_cast<ImWchar>(c);
    if (!ranges.empty() && ranges.back() + 1 == w) {
      ranges.back() = w;
    } else {
      ranges.insert(ranges.end(), {w, w});
    }
  }
  ranges.push_back(0);

  const DHat glyph = compose_d_hat();
  std::vector<int> rects;
  for (const int half_pixels : sizes_) {
    const double size = 0.5 * half_pixels;
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = oversampling(size);
    config.OversampleV = 1;
    config.PixelSnapH = false;
    config.GlyphRanges = ranges.data();
    const std::span<const unsigned char> bytes = font_bytes();
    // The atlas only reads the bytes; its interface has no const.
    ImFont* font =
        atlas_.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()),
                                    static_cast<float>(size) * face.line_per_em, &config);
    faces_.push_back({half_pixels, font});
    const PixelBox box = d_hat_box(face.info, glyph, size, config.OversampleH);
    rects.push_back(atlas_.AddCustomRectRegular(box.w + 2, box.h + 2));
  }
  if (!atlas_.Build()) throw std::logic_error("the font atlas cannot be built");
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double size = 0.5 * faces_[i].half_pixels;
    add_d_hat(*faces_[i].font, size, oversampling(size), rects[i]);
  }
  unsigned char* rgba = nullptr;
  int width = 0, height = 0;
  atlas_.GetTexDataAsRGBA32(&rgba, &width, &height);
  atlas_.SetTexID(upload_ ? upload_(rgba, width, height) : nullptr);
  stale_ = false;
}

void FontAtlas::add_d_hat(ImFont& font, double size, int oversample, int rect) {
  const FontFile face;
  const DHat glyph = compose_d_hat();
  const PixelBox box = d_hat_box(face.info, glyph, size, oversample);
  const double scale = size * static_cast<double>(stbtt_ScaleForMappingEmToPixels(&face.info, 1.0f));
  std::vector<unsigned char> bitmap(static_cast<std::size_t>(box.w) * static_cast<std::size_t>(box.h));
  blend_glyph(face.info, glyph.d, scale * oversample, scale, 0, 0, box, bitmap);
  blend_glyph(face.info, glyph.hat, scale * oversample, scale, glyph.hat_x * scale * oversample,
              -glyph.hat_y * scale, box, bitmap);
  smooth_rows(box, oversample, bitmap);

  const ImFontAtlasCustomRect* place = atlas_.GetCustomRectByIndex(rect);
  for (int y = 0; y < box.h; ++y) {
    const auto target = static_cast<std::size_t>((place->Y + 1 + y) * atlas_.TexWidth + place->X + 1);
    std::copy_n(&bitmap[static_cast<std::size_t>(y * box.w)], box.w, atlas_.TexPixelsAlpha8 + target);
  }
  // Smoothing moved the picture by half its width to the right.
  const double shift = -0.5 * (oversample - 1) / oversample;
  const auto x0 = static_cast<float>(static_cast<double>(box.x0) / oversample + shift);
  const float y0 = std::round(font.Ascent) + static_cast<float>(box.y0);
  const auto u = [&](int x) { return static_cast<float>(x) * atlas_.TexUvScale.x; };
  const auto v = [&](int y) { return static_cast<float>(y) * atlas_.TexUvScale.y; };
  font.AddGlyph(nullptr, static_cast<ImWchar>(kDHat), x0, y0,
                x0 + static_cast<float>(box.w) / static_cast<float>(oversample),
                y0 + static_cast<float>(box.h), u(place->X + 1), v(place->Y + 1), u(place->X + 1 + box.w),
                v(place->Y + 1 + box.h), static_cast<float>(FontMetrics().advance(kDHat) * size));
  font.BuildLookupTable();
}

}  // namespace pabd
