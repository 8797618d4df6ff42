// SPDX-License-Identifier: MIT
// H.264 for whoever looks now: every picture gives its unit at once, the units together are a stream that ffmpeg
// decodes to the pictures, and what is no stream is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "render/output/live_video.h"
#include "sim/base/child_process.h"
#include "tests/support/errors.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_live_video {

namespace {

using Planes = std::vector<std::uint8_t>;

// A bright square that moves over a smooth ground; Y, U, V.
Planes picture(int width, int height, int frame) {
  Planes out;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool inside = std::abs(x - 40 - 4 * frame) < 16 && std::abs(y - height / 2) < 16;
      out.push_back(static_cast<std::uint8_t>(inside ? 235 : 30 + 100 * x / width));
    }
  }
  for (int plane = 0; plane < 2; ++plane)
    out.insert(out.end(), static_cast<std::size_t>(width * height / 4),
               static_cast<std::uint8_t>(plane ? 90 : 170));
  return out;
}

// Kinds of the NAL units.
std::vector<int> kinds(const std::string& unit) {
  std::vector<int> out;
  for (std::size_t at = unit.find(std::string("\0\0\0\1", 4)); at != unit.npos;
       at = unit.find(std::string("\0\0\0\1", 4), at + 4))
    out.push_back(unit[at + 4] & 31);
  return out;
}

std::string number(std::size_t value, int bytes) {
  std::string out;
  for (int i = bytes - 1; i >= 0; --i) out += static_cast<char>((value >> (8 * i)) & 0xff);
  return out;
}
std::string tag(int kind, const std::string& data) {
  return number(static_cast<std::size_t>(kind), 1) + number(data.size(), 3) + std::string(7, '\0') + data +
         number(data.size() + 11, 4);
}
std::string nal(const std::string& bytes) { return number(bytes.size(), 4) + bytes; }

// A key frame with a delimiter and one without, and one that is none.
std::string small_stream() {
  const std::string record = std::string("\1\x42\xc0\x20\xff\xe1", 6) + number(3, 2) + "\x67st" +
                             number(1, 1) + number(2, 2) + "\x68p";
  return std::string("FLV\1\1\0\0\0\x9\0\0\0\0", 13) + tag(18, "names") +
         tag(9, std::string("\x17\0\0\0\0", 5) + record) +
         tag(9, std::string("\x17\1\0\0\0", 5) + nal("\x09\x10") + nal("\x65one")) +
         tag(9, std::string("\x27\1\0\0\0", 5) + nal("\x09\x30") + nal("\x41two")) +
         tag(9, std::string("\x17\1\0\0\0", 5) + nal("\x65three"));
}

}  // namespace

TEST_CASE("units come out of FLV however it is cut, with parameters where a key frame begins") {
  const std::string start("\0\0\0\1", 4), sets = start + "\x67st" + start + "\x68p";
  for (const std::size_t step : {1, 3, 7, 1000}) {
    const std::string stream = small_stream();
    FlvUnits units;
    std::vector<VideoUnit> got;
    for (std::size_t at = 0; at < stream.size(); at += step) {
      units.append(stream.substr(at, step));
      while (auto unit = units.next()) got.push_back(*unit);
    }
    REQUIRE(got.size() == 3);
    CHECK(got[0].bytes == start + "\x09\x10" + sets + start + "\x65one");
    CHECK(got[1].bytes == start + "\x09\x30" + start + "\x41two");
    CHECK(got[2].bytes == sets + start + "\x65three");
    CHECK(got[0].key);
    CHECK_FALSE(got[1].key);
  }
  // It is known to be complete without what follows.
  FlvUnits units;
  const std::string whole = small_stream();
  const std::size_t end = whole.find("two") + 3 + 4;
  units.append(whole.substr(0, end));
  CHECK(units.next());
  CHECK(units.next());
  CHECK_FALSE(units.next());
}

TEST_CASE("whatever is no such stream is refused, or gives units; it never reads beyond its end") {
  CHECK_THROWS_AS(
      [] {
        FlvUnits units;
        units.append("RIFF, which is something else");
        return units.next();
      }(),
      Error);
  std::mt19937 random(5);
  const std::string good = small_stream();
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = good;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    FlvUnits units;
    units.append(bytes);
    try {
      while (units.next()) {
      }
    } catch (const Error& error) {
      REQUIRE(error.kind() == ErrorKind::encoder);
      ++refused;
    }
  }
  CHECK(refused > 1000);
}

TEST_CASE("each picture gives its unit before the next is there, and ffmpeg decodes them to the pictures") {
  const int width = 322, height = 200;
  LiveVideo video({.width = width, .height = height, .crf = 18, .patience = 60});
  std::string stream;
  for (int i = 0; i < 30; ++i) {
    const VideoUnit unit = video.encode(picture(width, height, i));
    CHECK(unit.key == (i == 0));
    const auto nals = kinds(unit.bytes);
    REQUIRE(nals.size() >= 2);
    CHECK(nals[0] == 9);  // the delimiter, once
    CHECK(std::count(nals.begin(), nals.end(), 9) == 1);
    CHECK(std::count(nals.begin(), nals.end(), 7) == (i == 0));
    CHECK(std::count(nals.begin(), nals.end(), 5) + std::count(nals.begin(), nals.end(), 1) > 0);
    stream += unit.bytes;
  }
  const TempFolder folder;
  write_bytes(folder / "a.h264", stream);
  const ChildOutcome decoded =
      run_child({"ffmpeg", "-loglevel", "error", "-i", folder / "a.h264", "-f", "rawvideo", folder / "a.yuv"},
                60, [](std::string_view) {});
  REQUIRE(decoded.status == 0);
  CHECK(decoded.errors.empty());
  const std::string raw = read_bytes(folder / "a.yuv");
  const std::size_t size = static_cast<std::size_t>(width) * height * 3 / 2;
  REQUIRE(raw.size() == 30 * size);
  for (int i = 0; i < 30; ++i) {
    const Planes wanted = picture(width, height, i);
    double sum = 0;
    for (std::size_t k = 0; k < size; ++k)
      sum += std::abs(int{wanted[k]} -
                      int{static_cast<unsigned char>(raw[static_cast<std::size_t>(i) * size + k])});
    CHECK(sum / static_cast<double>(size) < 1.5);
  }
}

TEST_CASE("an ffmpeg that fails or stands still is told from one that encodes") {
  const Planes frame = picture(64, 64, 0);
  {
    const FakeFfmpeg fake("echo 'no such codec' >&2\nexit 3\n");
    LiveVideo video({.width = 64, .height = 64});
    const Caught failed = caught([&] { video.encode(frame); });
    CHECK(failed.kind == encoder_error);
    CHECK(failed.says("no such codec"));
    CHECK_THROWS_AS(live_video_encoder(), Error);
  }
  const FakeFfmpeg fake("exec sleep 60\n");
  LiveVideo video({.width = 64, .height = 64, .start_patience = 0.3});
  const Caught hung = caught([&] { video.encode(frame); });
  CHECK(hung.kind == encoder_error);
  CHECK(hung.says("0.3 s"));
}

TEST_CASE("an ffmpeg that stands still after its first picture is told in the time of a picture") {
  const TempFolder folder;
  write_bytes(folder / "begin.flv", small_stream());
  const FakeFfmpeg fake("cat '" + (folder / "begin.flv").string() + "'\nexec sleep 60\n");
  const Planes frame = picture(64, 64, 0);
  LiveVideo video({.width = 64, .height = 64, .patience = 0.3});
  for (int k = 0; k < 3; ++k) video.encode(frame);
  const Caught hung = caught([&] { video.encode(frame); });
  CHECK(hung.kind == encoder_error);
  CHECK(hung.says("0.3 s"));
}

}  // namespace pabd::test_live_video
