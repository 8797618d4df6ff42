// SPDX-License-Identifier: MIT
// Which parts of a frame changed.
#include <catch2/catch.hpp>
#include <random>

#include "app/serve/tiles.h"

namespace pabd::test_tiles {

namespace {

Image plain(int width, int height, std::uint8_t value = 10) {
  Image out;
  out.resize(width, height);
  std::fill(out.rgb.begin(), out.rgb.end(), value);
  return out;
}

void set(Image& image, int x, int y, std::uint8_t value) {
  image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                 static_cast<std::size_t>(x))] = value;
}

std::int64_t area_of(const std::vector<PixelRect>& rects) {
  std::int64_t out = 0;
  for (const PixelRect& rect : rects) out += rect.area();
  return out;
}

}  // namespace

TEST_CASE("one pixel is one tile, and the last tiles end with the image") {
  const Image before = plain(200, 130);
  Image after = before;
  CHECK_FALSE(Tiles::changed(before, after).any());
  CHECK(Tiles::changed(before, after).cover().empty());
  set(after, 199, 129, 99);
  CHECK(Tiles::changed(before, after).cover() == std::vector<PixelRect>{{192, 128, 8, 2}});
  after = before;
  set(after, 64, 63, 99);
  CHECK(Tiles::changed(before, after).cover() == std::vector<PixelRect>{{64, 0, 64, 64}});
}

TEST_CASE("few rectangles without overlap cover all that changed") {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const int width = 65 + static_cast<int>(random() % 1500), height = 65 + static_cast<int>(random() % 900);
    const Image before = plain(width, height);
    Image after = before;
    const int changes = 1 + static_cast<int>(random() % 60);
    std::vector<std::pair<int, int>> at;
    for (int i = 0; i < changes; ++i) {
      at.emplace_back(random() % static_cast<unsigned>(width), random() % static_cast<unsigned>(height));
      set(after, at.back().first, at.back().second, 200);
    }
    const Tiles tiles = Tiles::changed(before, after);
    for (const bool whole : {false, true}) {
      const auto rects = tiles.cover(whole);
      CAPTURE(width, height, changes, whole, rects.size());
      CHECK(rects.size() <= Tiles::kMostRects);
      CHECK(area_of(rects) <= std::int64_t{width} * height);
      for (std::size_t i = 0; i < rects.size(); ++i) {
        const PixelRect& a = rects[i];
        CHECK((a.x >= 0 && a.y >= 0 && a.w > 0 && a.h > 0 && a.x + a.w <= width && a.y + a.h <= height));
        for (std::size_t j = i + 1; j < rects.size(); ++j) {
          const PixelRect& b = rects[j];
          CHECK((a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y));
        }
      }
      for (const auto& [x, y] : at) {
        CHECK(std::any_of(rects.begin(), rects.end(), [x = x, y = y](const PixelRect& r) {
          return x >= r.x && x < r.x + r.w && y >= r.y && y < r.y + r.h;
        }));
      }
    }
  }
}

TEST_CASE("much of the image is sent as a whole") {
  const Image before = plain(640, 640);
  Image after = before;
  for (int y = 0; y < 448; y += 64)
    for (int x = 0; x < 640; x += 64) set(after, x, y, 1);
  CHECK(Tiles::changed(before, after).cover() == std::vector<PixelRect>{{0, 0, 640, 640}});
  CHECK(Tiles::changed(before, after).cover(false) == std::vector<PixelRect>{{0, 0, 640, 448}});
}

TEST_CASE("tiles are taken away in parts until none is left") {
  Tiles tiles(1280, 720);
  tiles.mark_all();
  const std::size_t all = tiles.count();
  CHECK(all == 20 * 12);
  int parts = 0;
  while (tiles.any()) {
    const std::size_t before = tiles.count();
    for (const PixelRect& rect : tiles.first(50).cover(false)) tiles.clear(rect);
    REQUIRE(tiles.count() < before);
    ++parts;
  }
  CHECK(parts <= 5);
  tiles.mark({64, 64, 65, 1});
  CHECK(tiles.count() == 2);
}

TEST_CASE("a reduced image keeps what is plain, and means of pairs") {
  const Image small = reduced(plain(100, 60, 77), 0.75);
  CHECK(small.width == 75);
  CHECK(small.height == 45);
  CHECK(std::all_of(small.rgb.begin(), small.rgb.end(), [](int v) { return v == 77; }));
  Image two = plain(2, 2, 0);
  set(two, 0, 0, 40);
  set(two, 1, 1, 60);
  CHECK(reduced(two, 0.5).rgb[0] == 25);
}

}  // namespace pabd::test_tiles
