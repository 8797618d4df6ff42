// SPDX-License-Identifier: MIT
// See tiles.h.
#include "app/serve/tiles.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pabd {
namespace {

struct Span {  // of tiles, ends excluded
  int left, top, right, bottom;
  int area() const { return (right - left) * (bottom - top); }
};

Span around(const Span& a, const Span& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

bool overlap(const Span& a, const Span& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// Joins adjacent rows of equal extent.
void join_rows(std::vector<Span>& spans) {
  std::vector<Span> out;
  for (const Span& span : spans) {
    const auto above = std::find_if(out.begin(), out.end(), [&](const Span& s) {
      return s.bottom == span.top && s.left == span.left && s.right == span.right;
    });
    if (above == out.end()) {
      out.push_back(span);
    } else {
      above->bottom = span.bottom;
    }
  }
  spans = std::move(out);
}

// Joins the pair whose area grows least.
void join_cheapest(std::vector<Span>& spans) {
  std::size_t a = 0, b = 1;
  int least = -1;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    for (std::size_t j = i + 1; j < spans.size(); ++j) {
      const int grown = around(spans[i], spans[j]).area() - spans[i].area() - spans[j].area();
      if (least >= 0 && grown >= least) continue;
      least = std::max(0, grown);
      a = i;
      b = j;
    }
  }
  spans[a] = around(spans[a], spans[b]);
  spans.erase(spans.begin() + static_cast<std::ptrdiff_t>(b));
}

void join_overlapping(std::vector<Span>& spans) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    for (std::size_t j = i + 1; j < spans.size(); ++j) {
      if (!overlap(spans[i], spans[j])) continue;
      spans[i] = around(spans[i], spans[j]);
      spans.erase(spans.begin() + static_cast<std::ptrdiff_t>(j));
      i = static_cast<std::size_t>(-1);  // it may overlap others now
      break;
    }
  }
}

}  // namespace

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + kSide - 1) / kSide),
      rows_((height + kSide - 1) / kSide),
      marked_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

Tiles Tiles::changed(const Image& before, const Image& after) {
  Tiles out(after.width, after.height);
  const std::size_t row = static_cast<std::size_t>(after.width) * 3;
  for (int y = 0; y < after.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * row;
    if (std::memcmp(&before.rgb[at], &after.rgb[at], row) == 0) continue;
    char* const marks =
        &out.marked_[static_cast<std::size_t>(y / kSide) * static_cast<std::size_t>(out.columns_)];
    for (int c = 0; c < out.columns_; ++c) {
      if (marks[c]) continue;
      const std::size_t begin = at + static_cast<std::size_t>(c) * kSide * 3;
      const std::size_t size = std::min<std::size_t>(kSide * 3, at + row - begin);
      marks[c] = std::memcmp(&before.rgb[begin], &after.rgb[begin], size) != 0;
    }
  }
  return out;
}

bool Tiles::any() const { return count() > 0; }
std::size_t Tiles::count() const {
  return static_cast<std::size_t>(std::count(marked_.begin(), marked_.end(), 1));
}
void Tiles::mark_all() { std::fill(marked_.begin(), marked_.end(), 1); }

void Tiles::set(const PixelRect& rect, char mark) {
  for (int r = rect.y / kSide; r * kSide < rect.y + rect.h && r < rows_; ++r)
    for (int c = rect.x / kSide; c * kSide < rect.x + rect.w && c < columns_; ++c)
      marked_[static_cast<std::size_t>(r * columns_ + c)] = mark;
}

Tiles Tiles::first(std::size_t most) const {
  Tiles out(width_, height_);
  for (std::size_t i = 0, taken = 0; i < marked_.size() && taken < most; ++i) {
    out.marked_[i] = marked_[i];
    taken += marked_[i] ? 1 : 0;
  }
  return out;
}

PixelRect Tiles::pixels(int left, int top, int right, int bottom) const {
  const int x = left * kSide, y = top * kSide;
  return {x, y, std::min(right * kSide, width_) - x, std::min(bottom * kSide, height_) - y};
}

std::vector<PixelRect> Tiles::cover(bool whole) const {
  constexpr std::size_t kMany =
      64;  // runs; with more of them each row becomes one run, since joining compares all pairs
  std::vector<Span> spans, coarse;
  for (int r = 0; r < rows_; ++r) {
    const char* const marks = &marked_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_)];
    int first = -1, last = -1;
    for (int c = 0; c < columns_; ++c) {
      if (!marks[c]) continue;
      if (c == 0 || !marks[c - 1]) spans.push_back({c, r, c + 1, r + 1});
      spans.back().right = c + 1;
      if (first < 0) first = c;
      last = c;
    }
    if (first >= 0) coarse.push_back({first, r, last + 1, r + 1});
  }
  join_rows(spans);
  if (spans.size() > kMany) {
    spans = std::move(coarse);
    join_rows(spans);
  }
  while (spans.size() > kMostRects) {
    join_cheapest(spans);
    join_overlapping(spans);
  }
  std::vector<PixelRect> out;
  std::int64_t area = 0;
  for (const Span& s : spans) {
    out.push_back(pixels(s.left, s.top, s.right, s.bottom));
    area += out.back().area();
  }
  if (whole && static_cast<double>(area) > kWorthIt * width_ * height_) return {{0, 0, width_, height_}};
  return out;
}

Image reduced(const Image& image, double scale) {
  Image out;
  out.resize(std::max(1, static_cast<int>(std::lround(image.width * scale))),
             std::max(1, static_cast<int>(std::lround(image.height * scale))));
  constexpr int kOne = 256;
  struct Weight {
    int first, second, part;  // of the second, of kOne
  };
  const auto weights = [](int to, int from) {
    std::vector<Weight> list(static_cast<std::size_t>(to));
    for (int i = 0; i < to; ++i) {
      const double at = std::clamp((i + 0.5) * from / to - 0.5, 0.0, from - 1.0);
      const int first = static_cast<int>(at);
      list[static_cast<std::size_t>(i)] = {first, std::min(first + 1, from - 1),
                                           static_cast<int>(std::lround((at - first) * kOne))};
    }
    return list;
  };
  const std::vector<Weight> columns = weights(out.width, image.width),
                            rows = weights(out.height, image.height);
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  std::uint8_t* to = out.rgb.data();
  for (const Weight& r : rows) {
    const std::uint8_t* const upper = &image.rgb[static_cast<std::size_t>(r.first) * row];
    const std::uint8_t* const lower = &image.rgb[static_cast<std::size_t>(r.second) * row];
    for (const Weight& c : columns) {
      for (int k = 0; k < 3; ++k) {
        const int a = 3 * c.first + k, b = 3 * c.second + k;
        const int above = upper[a] * (kOne - c.part) + upper[b] * c.part;
        const int below = lower[a] * (kOne - c.part) + lower[b] * c.part;
        *to++ = static_cast<std::uint8_t>((above * (kOne - r.part) + below * r.part + kOne * kOne / 2) /
                                          (kOne * kOne));
      }
    }
  }
  return out;
}

}  // namespace pabd
