// SPDX-License-Identifier: MIT
// Frames for visitors: one on its way, the newest wins, only what changed, lossless when still. What is sent
// is put together again as a page does, and compared with what was drawn.
#include <turbojpeg.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <random>

#include "app/serve/frame_stream.h"
#include "render/output/png.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_frame_stream {

namespace {

// What a page has on its canvas.
class Page {
 public:
  void take(const EncodedFrame& frame) {
    ++frames;
    for (std::size_t i = 0; i < frame.parts.size(); ++i) {
      const std::string& part = *frame.parts[i];
      head = read_frame_head(part);
      CHECK(head.left == frame.parts.size() - 1 - i);
      CHECK(((head.flags & FrameHead::kLast) != 0) == (head.left == 0));
      CHECK(((head.flags & FrameHead::kLossless) != 0) == (head.kind == FrameHead::png));
      if (canvas.width != head.width || canvas.height != head.height) {
        canvas.resize(head.width, head.height);
        std::fill(canvas.rgb.begin(), canvas.rgb.end(), 0);
      }
      put(decode(part.substr(FrameHead::kBytes)));
    }
    bytes += frame.bytes;
  }

  Image canvas;
  FrameHead head;
  int frames = 0;
  std::size_t bytes = 0, coarse = 0;  // coarse: pixels that came from fewer

 private:
  static Image enlarged(const Image& image, int width, int height) {
    Image out;
    out.resize(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto from =
            3 * (static_cast<std::size_t>(y * image.height / height) * static_cast<std::size_t>(image.width) +
                 static_cast<std::size_t>(x * image.width / width));
        std::memcpy(&out.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x))],
                    &image.rgb[from], 3);
      }
    }
    return out;
  }
  Image decode(const std::string& data) {
    Image out;
    if (head.kind == FrameHead::png) {
      const TempFolder folder;
      write_bytes(folder / "part.png", data);
      out = read_png(folder / "part.png");
    } else {
      const tjhandle handle = tjInitDecompress();
      const auto* jpeg = reinterpret_cast<const unsigned char*>(data.data());
      int w = 0, h = 0, subsampling = 0;
      REQUIRE(tjDecompressHeader2(handle, const_cast<unsigned char*>(jpeg), data.size(), &w, &h,
                                  &subsampling) == 0);
      out.resize(w, h);
      REQUIRE(tjDecompress2(handle, jpeg, data.size(), out.rgb.data(), w, 0, h, TJPF_RGB, 0) == 0);
      tjDestroy(handle);
      coarse += static_cast<std::size_t>(head.w * head.h > w * h ? head.w * head.h : 0);
      if (w != head.w || h != head.h) out = enlarged(out, head.w, head.h);
    }
    REQUIRE(out.width == head.w);
    REQUIRE(out.height == head.h);
    return out;
  }
  void put(const Image& part) {
    REQUIRE(head.x + head.w <= canvas.width);
    REQUIRE(head.y + head.h <= canvas.height);
    for (int y = 0; y < part.height; ++y)
      std::memcpy(
          &canvas.rgb[3 * (static_cast<std::size_t>(head.y + y) * static_cast<std::size_t>(canvas.width) +
                           static_cast<std::size_t>(head.x))],
          &part.rgb[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(part.width)],
          3 * static_cast<std::size_t>(part.width));
  }
};

// A smooth picture with a bright square.
Image scene(int square_x, int square_y, int width = 640, int height = 400) {
  Image out;
  out.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* const p = &out.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                            static_cast<std::size_t>(x))];
      const bool inside = x >= square_x && x < square_x + 40 && y >= square_y && y < square_y + 40;
      p[0] = static_cast<std::uint8_t>(inside ? 240 : 40 + 100 * x / width);
      p[1] = static_cast<std::uint8_t>(inside ? 200 : 60 + 80 * y / height);
      p[2] = static_cast<std::uint8_t>(inside ? 30 : 90);
    }
  }
  return out;
}

double mean_error(const Image& a, const Image& b) {
  REQUIRE(a.rgb.size() == b.rgb.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

struct Visited {
  std::map<VisitorId, Page> pages;
  FrameStream stream{[this](VisitorId id, const EncodedFrame& frame) { pages[id].take(frame); }};
  void acknowledge(VisitorId id, double now) { stream.acknowledge(id, pages[id].head.frame, 1, now); }
};

}  // namespace

TEST_CASE("the head of a frame is 32 bytes, little endian") {
  FrameHead head;
  head.kind = FrameHead::png;
  head.flags = 3;
  head.left = 0x0102;
  head.frame = 0x01020304;
  head.x = 1, head.y = 2, head.w = 3, head.h = 4, head.width = 5, head.height = 6;
  head.stamp = 0xfffefdfc;
  head.draw_us = 7;
  head.encode_us = 8;
  const std::string bytes = to_bytes(head);
  REQUIRE(bytes.size() == 32);
  CHECK(bytes.substr(0, 8) == std::string("\x02\x03\x02\x01\x04\x03\x02\x01", 8));
  CHECK(bytes.substr(20, 4) == "\xfc\xfd\xfe\xff");
  CHECK(read_frame_head(bytes) == head);
}

TEST_CASE("one frame is on its way, then the newest, and only what changed of it") {
  Visited v;
  v.stream.arrive(1);
  CHECK(v.stream.show(scene(0, 0), 1, 5, 0));
  v.stream.deliver(0);
  CHECK(v.pages[1].frames == 1);
  CHECK(mean_error(v.pages[1].canvas, scene(0, 0)) < 4);
  const std::size_t whole = v.pages[1].bytes;

  CHECK_FALSE(v.stream.show(scene(0, 0), 2, 5, 0.01));  // nothing new
  for (int i = 1; i <= 3; ++i) {
    CHECK(v.stream.show(scene(10 * i, 0), 2, 5, 0.02 * i));
    v.stream.deliver(0.02 * i);
    CHECK(v.pages[1].frames == 1);  // not acknowledged
  }
  v.acknowledge(1, 0.1);
  v.stream.deliver(0.1);
  CHECK(v.pages[1].frames == 2);
  CHECK(v.pages[1].head.stamp == 2);
  CHECK(v.pages[1].head.frame == 4);
  CHECK(mean_error(v.pages[1].canvas, scene(30, 0)) < 4);
  CHECK(v.pages[1].bytes - whole < whole / 2);

  // Who comes later, or acknowledges something else, gets a whole frame, or none.
  v.stream.arrive(2);
  v.stream.acknowledge(1, 999, 1, 0.1);
  v.stream.deliver(0.11);
  CHECK(v.pages[1].frames == 2);
  CHECK(mean_error(v.pages[2].canvas, scene(30, 0)) < 4);
}

TEST_CASE("200 ms after the last change the frame is exact, and then nothing is sent") {
  Visited v;
  v.stream.arrive(1);
  v.stream.show(scene(0, 0, 1280, 720), 0, 1, 0);
  double now = 0;
  v.stream.deliver(now);
  v.acknowledge(1, 0.01);
  v.stream.deliver(0.19);
  CHECK(v.pages[1].frames == 1);
  REQUIRE(v.stream.due());
  CHECK(*v.stream.due() == Approx(0.2));
  for (now = 0.2; v.stream.due() && v.pages[1].frames < 20; now += 0.01) {
    v.stream.deliver(now);
    v.acknowledge(1, now);
  }
  CHECK(v.pages[1].canvas.rgb == scene(0, 0, 1280, 720).rgb);
  CHECK(v.pages[1].head.kind == FrameHead::png);
  const int frames = v.pages[1].frames;
  CHECK(frames < 8);
  v.stream.deliver(now + 100);
  CHECK(v.pages[1].frames == frames);
  // A small change costs a small lossless part.
  v.stream.show(scene(1, 0, 1280, 720), 0, 1, now);
  const std::size_t before = v.pages[1].bytes;
  v.stream.deliver(now);
  v.acknowledge(1, now);
  v.stream.deliver(now + 0.3);
  CHECK(v.pages[1].canvas.rgb == scene(1, 0, 1280, 720).rgb);
  CHECK(v.pages[1].bytes - before < 30000);
}

TEST_CASE("whatever is shown and whoever reads how fast, all end with the same exact window") {
  std::mt19937 random(11);
  Visited v;
  for (VisitorId id = 1; id <= 3; ++id) v.stream.arrive(id);
  double now = 0;
  Image last;
  for (int i = 0; i < 150; ++i) {
    now += 0.03;
    if (random() % 40 == 0)
      v.stream.choose(random() % 2 ? Adaptation::Mode::fast : Adaptation::Mode::automatic);
    const bool larger = i / 50 == 1;
    last = scene(static_cast<int>(random() % 500), static_cast<int>(random() % 300), larger ? 800 : 640, 400);
    v.stream.show(last, static_cast<std::uint32_t>(i), 1, now,
                  i % 3 == 0 ? PixelRect{} : PixelRect{30, 40, 333, 222});
    v.stream.deliver(now);
    for (VisitorId id = 1; id <= 3; ++id)
      if (random() % (2 * id) == 0) v.acknowledge(id, now);
  }
  for (int i = 0; i < 30; ++i) {
    now += 0.1;
    for (VisitorId id = 1; id <= 3; ++id) v.acknowledge(id, now);
    v.stream.deliver(now);
  }
  for (VisitorId id = 1; id <= 3; ++id) CHECK(v.pages[id].canvas.rgb == last.rgb);
}

TEST_CASE("on a slow link the picture becomes coarser, and text beside it stays as it is") {
  // Left of 400 the picture; right of it strokes of one pixel, as letters have, which move as well.
  constexpr int kEdge = 401, kWidth = 640, kHeight = 400;
  const auto window = [](int step) {
    Image out = scene(7 * step % 300, 50, kWidth, kHeight);
    std::mt19937 random(static_cast<unsigned>(step));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kEdge; ++x)
        out.rgb[3 * static_cast<std::size_t>(y * kWidth + x)] = static_cast<std::uint8_t>(random() % 128);
      for (int x = kEdge; x < kWidth; ++x) {
        const bool ink = (x + y + step / 10) % 3 == 0;
        std::memset(&out.rgb[3 * static_cast<std::size_t>(y * kWidth + x)], ink ? 230 : 25, 3);
      }
    }
    return out;
  };
  const auto right_error = [](const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
      for (std::size_t k = 3 * kEdge; k < 3 * kWidth; ++k) {
        const std::size_t at = 3 * static_cast<std::size_t>(y * kWidth) + k;
        sum += std::abs(int{a.rgb[at]} - int{b.rgb[at]});
      }
    return sum / (3.0 * kHeight * (kWidth - kEdge));
  };
  Visited v;
  v.stream.arrive(1);
  double now = 0;
  int step = 0;
  const PixelRect picture{0, 0, kEdge, kHeight};
  // Every frame takes 120 ms.
  for (; step < 60; ++step) {
    v.stream.show(window(step), 0, 1, now, picture);
    v.stream.deliver(now);
    now += 0.12;
    v.acknowledge(1, now);
  }
  Page& page = v.pages[1];
  CHECK(page.coarse > 0);
  // Whatever is on the page beside the picture was sent within the last two tenths of a second.
  double least = 1e9;
  for (int back = 1; back <= 3; ++back)
    least = std::min(least, right_error(page.canvas, window(step - back)));
  CHECK(least < 12);
  // The same strokes at half the size are grey: an error of about 90.
  const Image half = reduced(window(step - 1), 0.5);
  Image grey = window(step - 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      std::memcpy(&grey.rgb[3 * static_cast<std::size_t>(y * kWidth + x)],
                  &half.rgb[3 * static_cast<std::size_t>(y / 2 * half.width + x / 2)], 3);
  CHECK(right_error(grey, window(step - 1)) > 50);
  // At rest all of it is exact.
  for (int i = 0; i < 20; ++i) {
    now += 0.1;
    v.stream.deliver(now);
    v.acknowledge(1, now);
  }
  CHECK(page.canvas.rgb == window(step - 1).rgb);
}

TEST_CASE("a page that lost what it had gets the whole frame again") {
  Visited v;
  v.stream.arrive(1);
  v.stream.show(scene(0, 0), 0, 1, 0);
  v.stream.deliver(0);
  v.acknowledge(1, 0.01);
  std::fill(v.pages[1].canvas.rgb.begin(), v.pages[1].canvas.rgb.end(), 0);
  v.stream.refresh(1);
  v.stream.show(scene(10, 0), 0, 1, 0.02);
  v.stream.deliver(0.02);
  CHECK(mean_error(v.pages[1].canvas, scene(10, 0)) < 4);
  v.acknowledge(1, 0.03);
  std::fill(v.pages[1].canvas.rgb.begin(), v.pages[1].canvas.rgb.end(), 0);
  v.stream.refresh(1);
  v.stream.deliver(0.04);  // although nothing changed
  CHECK(mean_error(v.pages[1].canvas, scene(10, 0)) < 4);
}

TEST_CASE("somebody who never reads holds nobody up") {
  Visited v;
  v.stream.arrive(1);
  v.stream.arrive(2);
  for (int i = 0; i < 50; ++i) {
    v.stream.show(scene(5 * i, 20), 0, 1, 0.05 * i);
    v.stream.deliver(0.05 * i);
    v.acknowledge(2, 0.05 * i + 0.01);
    CHECK(v.stream.wants_frame());
  }
  CHECK(v.pages[1].frames == 1);
  CHECK(v.pages[2].frames == 50);
  v.stream.depart(2);
  v.stream.show(scene(300, 300), 0, 1, 10);
  CHECK_FALSE(v.stream.wants_frame());  // nothing is drawn for it alone
}

}  // namespace pabd::test_frame_stream
