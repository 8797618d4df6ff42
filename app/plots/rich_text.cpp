// SPDX-License-Identifier: MIT
// Text with sub- and superscripts: parsing, measuring, breaking.
#include "app/plots/rich_text.h"

#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/plots/font_data.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr double kScriptSize = 0.72;
constexpr double kSubShift = 0.20;
constexpr double kSuperShift = -0.38;
constexpr double kItalicCorrection =
    0.08;  // room that a slanted letter needs before an upright one or a superscript

enum class Script { base, sub, super };

struct Piece {
  std::string text;
  Script script = Script::base;
  bool italic = false;
};

std::vector<Piece> parse(std::string_view rich) {
  std::vector<Piece> pieces;
  const auto append = [&](std::string_view text, Script script, bool italic) {
    if (text.empty()) return;
    if (pieces.empty() || pieces.back().script != script || pieces.back().italic != italic ||
        script != Script::base) {
      pieces.push_back({std::string(text), script, italic});
    } else {
      pieces.back().text += text;
    }
  };
  std::size_t i = 0;
  while (i < rich.size()) {
    const std::size_t mark = rich.find_first_of("_^*", i);
    if (mark == std::string_view::npos) break;
    const bool opens = mark + 1 < rich.size() && rich[mark + 1] == '{';
    const std::size_t close = opens ? rich.find('}', mark + 2) : std::string_view::npos;
    if (close == std::string_view::npos) {
      append(rich.substr(i, mark + 1 - i), Script::base, false);
      i = mark + 1;
      continue;
    }
    append(rich.substr(i, mark - i), Script::base, false);
    const std::string_view inner = rich.substr(mark + 2, close - mark - 2);
    if (rich[mark] == '*') {
      append(inner, Script::base, true);
    } else {
      append(inner, rich[mark] == '_' ? Script::sub : Script::super, false);
    }
    i = close + 1;
  }
  append(rich.substr(std::min(i, rich.size())), Script::base, false);
  return pieces;
}

}  // namespace

std::u32string decode_text(std::string_view utf8) {
  std::u32string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t c = next_character(utf8, i);
    if (c == 0x302 && !out.empty() && out.back() == U'd') {
      out.back() = kDHat;
    } else {
      out += c;
    }
  }
  return out;
}

std::string ui_text(std::string_view utf8) {
  std::string out;
  for (const char32_t c : decode_text(utf8)) append_character(out, c);
  return out;
}

std::string plain_text(std::string_view rich) {
  std::string out;
  for (const Piece& piece : parse(rich)) {
    if (piece.script == Script::sub) out += '_';
    if (piece.script == Script::super) out += '^';
    out += piece.text;
  }
  return out;
}

struct FontMetrics::Impl {
  stbtt_fontinfo info;
  double em_per_unit;
};

FontMetrics::FontMetrics() : impl_(std::make_unique<Impl>()) {
  const unsigned char* bytes = font_bytes().data();
  if (stbtt_InitFont(&impl_->info, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)) == 0) {
    throw std::logic_error("the embedded font cannot be read");
  }
  impl_->em_per_unit = static_cast<double>(stbtt_ScaleForMappingEmToPixels(&impl_->info, 1.0f));
}
FontMetrics::~FontMetrics() = default;
FontMetrics::FontMetrics(FontMetrics&&) noexcept = default;
FontMetrics& FontMetrics::operator=(FontMetrics&&) noexcept = default;

double FontMetrics::advance(char32_t code_point) const {
  if (code_point >= 0x300 && code_point < 0x370) return 0;  // combining marks
  const int c = static_cast<int>(code_point == kDHat ? U'd' : code_point);
  int width = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&impl_->info, c, &width, &bearing);
  return width * impl_->em_per_unit;
}

bool FontMetrics::has(char32_t code_point) const {
  return code_point == kDHat || stbtt_FindGlyphIndex(&impl_->info, static_cast<int>(code_point)) != 0;
}

DHat compose_d_hat() {
  const unsigned char* bytes = font_bytes().data();
  stbtt_fontinfo info;
  if (stbtt_InitFont(&info, bytes, stbtt_GetFontOffsetForIndex(bytes, 0)) == 0)
    throw std::logic_error("the embedded font cannot be read");
  DHat out{};
  out.d = stbtt_FindGlyphIndex(&info, 'd');
  out.hat = stbtt_FindGlyphIndex(&info, 0x2C6);
  int dx0 = 0, dy0 = 0, dx1 = 0, dy1 = 0, hx0 = 0, hy0 = 0, hx1 = 0, hy1 = 0;
  stbtt_GetGlyphBox(&info, out.d, &dx0, &dy0, &dx1, &dy1);
  stbtt_GetGlyphBox(&info, out.hat, &hx0, &hy0, &hx1, &hy1);
  out.em = static_cast<int>(1.0f / stbtt_ScaleForMappingEmToPixels(&info, 1.0f));
  // A hat centred over the stem alone would stick out far, so it moves a little in.
  const double stem = dx1 - 0.09 * out.em * 0.5;
  out.hat_x = stem - 0.07 * out.em - 0.5 * (hx0 + hx1);
  out.hat_y = dy1 + 0.045 * out.em - hy0;
  out.x0 = std::min(dx0, static_cast<int>(std::floor(hx0 + out.hat_x)));
  out.x1 = std::max(dx1, static_cast<int>(std::ceil(hx1 + out.hat_x)));
  out.y0 = std::min(dy0, static_cast<int>(std::floor(hy0 + out.hat_y)));
  out.y1 = std::max(dy1, static_cast<int>(std::ceil(hy1 + out.hat_y)));
  return out;
}

TextLayout layout_text(const FontMetrics& font, std::string_view rich, double size) {
  TextLayout layout;
  double pen = 0;
  double script_start = 0, script_end = 0;  // of the last script, for one stacked on it
  Script last = Script::base;
  bool last_italic = false;
  for (Piece& piece : parse(rich)) {
    TextRun run{std::move(piece.text), 0, 0, size, 0, piece.italic};
    if (piece.script != Script::base) {
      run.size = kScriptSize * size;
      run.y = (piece.script == Script::sub ? kSubShift : kSuperShift) * size;
    }
    for (const char32_t c : decode_text(run.text)) run.width += font.advance(c) * run.size;
    const bool stacked = piece.script != Script::base && last != Script::base && last != piece.script;
    if (last_italic && !piece.italic && piece.script != Script::sub) pen += kItalicCorrection * size;
    run.x = stacked ? script_start : pen;
    const double end = run.x + run.width;
    pen = stacked ? std::max(end, script_end) : end;
    if (piece.script != Script::base) {
      script_start = run.x;
      script_end = end;
    }
    // A third script in a row starts after the stack.
    last = stacked ? Script::base : piece.script;
    last_italic = piece.italic;
    layout.runs.push_back(std::move(run));
  }
  layout.width = pen;
  return layout;
}

double text_width(const FontMetrics& font, std::string_view rich, double size) {
  return layout_text(font, rich, size).width;
}

double fitted_size(const FontMetrics& font, std::string_view rich, double size, double least, double width) {
  const double natural = text_width(font, rich, size);
  const double fitted = natural > width ? size * width / natural : size;
  return fitted < least ? 0 : fitted;
}

std::vector<std::string> wrap_text(const FontMetrics& font, std::string_view rich, double size,
                                   double width) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t i = 0;
  while (i < rich.size()) {
    std::size_t end = std::min(rich.find(' ', i), rich.size());
    while (end < rich.size() &&
           (rich.substr(end).starts_with(" = ") || rich.substr(i, end - i).ends_with(" =")))
      end = std::min(rich.find(' ', end + 1), rich.size());
    const std::string_view word = rich.substr(i, end - i);
    i = end + 1;
    if (word.empty()) continue;
    std::string longer = line.empty() ? std::string(word) : line + ' ' + std::string(word);
    if (!line.empty() && text_width(font, longer, size) > width) {
      lines.push_back(std::move(line));
      line = word;
    } else {
      line = std::move(longer);
    }
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

}  // namespace pabd
