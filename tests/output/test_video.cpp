// SPDX-License-Identifier: MIT
// Videos through ffmpeg, and what happens when ffmpeg fails.
#include <catch2/catch.hpp>

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "render/output/async_sink.h"
#include "render/output/encoder_process.h"
#include "render/output/frame_sink.h"
#include "tests/support/errors.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/picture.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_video {

namespace fs = std::filesystem;

namespace {

SinkOptions sized(int width, int height, double fps = 60) {
  SinkOptions options;
  options.width = width;
  options.height = height;
  options.fps = fps;
  return options;
}

void write_frames(FrameSink& sink, const SinkOptions& options, int count) {
  for (int i = 0; i < count; ++i) sink.write(test_frame(options.width, options.height, i));
}

void make_video(const fs::path& path, const SinkOptions& options, int count) {
  const auto sink = make_sink(path, options);
  write_frames(*sink, options, count);
  sink->finish();
}

// What a program prints; the path must hold nothing special.
std::string output_of(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> part;
  while (pipe) {
    const std::size_t n = std::fread(part.data(), 1, part.size(), pipe);
    if (n == 0) break;
    text.append(part.data(), n);
  }
  if (pipe) ::pclose(pipe);
  return text;
}

// "width,height,rate,frames" of the first stream, the frames counted one by one.
std::string probe(const fs::path& path) {
  std::string text = output_of(
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 " +
      path.string());
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

// The first frame as RGB.
std::string first_frame(const fs::path& path) {
  return output_of("ffmpeg -v error -i " + path.string() + " -frames:v 1 -f rawvideo -pix_fmt rgb24 -");
}

}  // namespace

TEST_CASE("mp4, webm and gif have every frame, the size and the rate") {
  const TempFolder folder;
  make_video(folder / "a.mp4", sized(64, 48), 20);
  CHECK(probe(folder / "a.mp4") == "64,48,60/1,20");
  make_video(folder / "a.webm", sized(64, 48, 30), 12);
  CHECK(probe(folder / "a.webm") == "64,48,30/1,12");
  make_video(folder / "a.gif", sized(64, 48, 25), 10);
  CHECK(probe(folder / "a.gif") == "64,48,25/1,10");
  CHECK(folder.names() == std::vector<std::string>{"a.gif", "a.mp4", "a.webm"});
}

TEST_CASE("one frame, odd sizes, fractional rates, odd names") {
  const TempFolder folder;
  make_video(folder / "one.mp4", sized(63, 47, 29.97), 1);
  CHECK(probe(folder / "one.mp4").starts_with("64,48,"));
  make_video(folder / "odd.mp4", sized(63, 48, 29.97), 3);
  CHECK(probe(folder / "odd.mp4") == "64,48,2997/100,3");
  make_video(folder / "odd.webm", sized(63, 47), 3);
  CHECK(probe(folder / "odd.webm") == "63,47,60/1,3");
  make_video(folder / "odd.gif", sized(63, 47, 50), 3);
  CHECK(probe(folder / "odd.gif") == "63,47,50/1,3");
  // no shell and no address: such a name is only a name
  make_video(folder / "a:b 'c' $(d) %d.mp4", sized(32, 32), 2);
  CHECK(fs::exists(folder / "a:b 'c' $(d) %d.mp4"));
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  CHECK(caught([] { make_video("tcp:x.mp4", sized(32, 32), 2); }).text.empty());
  CHECK(caught([] { make_video("-y.mp4", sized(32, 32), 2); }).text.empty());
  fs::current_path(before);
  CHECK(fs::exists(folder / "tcp:x.mp4"));
}

TEST_CASE("a gif of 60 frames a second keeps every second frame") {
  const TempFolder folder;
  make_video(folder / "a.gif", sized(32, 32, 60), 7);
  CHECK(probe(folder / "a.gif").ends_with(",4"));
}

TEST_CASE("a GIF has one palette for all frames, and is played as often as was asked") {
  const TempFolder folder;
  const auto made = [&](const char* name, std::optional<int> plays) {
    SinkOptions options = sized(64, 48, 25);
    options.video.plays = plays;
    make_video(folder / name, options, 10);
    return read_bytes(folder / name);
  };
  // Frames of a file with a palette of their own, and how often it is repeated; −1: not said.
  const auto walk = [](const std::string& gif) {
    std::pair<int, int> out = {0, -1};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(gif.at(i)); };
    std::size_t i = 13 + (byte(10) & 0x80 ? 3u << ((byte(10) & 7) + 1) : 0u);
    const auto skip = [&] {
      while (byte(i) != 0) i += byte(i) + 1u;
      ++i;
    };
    while (byte(i) != 0x3B) {
      if (byte(i) == 0x2C) {  // a frame
        const unsigned flags = byte(i + 9);
        if (flags & 0x80) ++out.first;
        i += 10 + (flags & 0x80 ? 3u << ((flags & 7) + 1) : 0u) + 1;
      } else {
        if (byte(i + 1) == 0xFF && gif.substr(i + 3, 11) == "NETSCAPE2.0")
          out.second = byte(i + 16) + 256 * byte(i + 17);
        i += 2;
      }
      skip();
    }
    return out;
  };
  for (const auto& [name, plays, repeats] : {std::tuple{"ever.gif", std::optional<int>(), 0},
                                             {"zero.gif", std::optional<int>(0), 0},
                                             {"once.gif", std::optional<int>(1), -1},
                                             {"thrice.gif", std::optional<int>(3), 2}}) {
    CAPTURE(name);
    const auto [own, repeated] = walk(made(name, plays));
    CHECK(own <= 1);  // of ten: ffmpeg writes it again with the first frame
    CHECK(repeated == repeats);
  }
  CHECK(folder.names().size() == 4);  // what it was made from is gone
}

TEST_CASE("a smaller --crf makes a larger file, and a slower --preset other bytes") {
  const TempFolder folder;
  for (const char* kind : {".mp4", ".webm"}) {
    CAPTURE(kind);
    const auto bytes = [&](const char* name, std::optional<int> crf, const char* preset) {
      SinkOptions options = sized(160, 120);
      options.video.crf = crf;
      options.video.preset = preset;
      make_video(folder / (std::string(name) + kind), options, 12);
      return read_bytes(folder / (std::string(name) + kind));
    };
    const std::string usual = bytes("usual", {}, "");
    CHECK(bytes("fine", 2, "").size() > usual.size());
    CHECK(bytes("coarse", 45, "").size() < usual.size());
    CHECK(bytes("same", std::string(kind) == ".mp4" ? 18 : 24,
                std::string(kind) == ".mp4" ? "veryfast" : "fast") == usual);
    CHECK(bytes("slow", {}, "veryslow") != usual);
  }
}

TEST_CASE("an encoder of the GPU is tried first, and refused with ffmpeg's words") {
  const TempFolder folder;
  SinkOptions options = sized(64, 48);
  options.video.encoder = VideoEncoder::nvenc;
  {
    const FakeFfmpeg fake("echo 'Cannot load the driver' >&2\nexit 1\n");
    const Caught error = caught([&, kept = options] { make_sink(folder / "a.mp4", kept); });
    CHECK(error.kind == encoder_error);
    for (const char* words :
         {"--encoder nvenc", "h264_nvenc", "Cannot load the driver", "leave --encoder out"})
      CHECK(error.says(words));
  }
  // One that works is told which encoder to take, once to try it and once for the frames.
  const FakeFfmpeg fake(
      "echo \"$@\" >> \"$HERE/said\"\ncase \"$*\" in *lavfi*) echo 0, 0; exit 0;; esac\ncat > "
      "/dev/null\nexit 3\n");
  CHECK(caught([&, kept = options] { make_video(folder / "a.mp4", kept, 2); }).kind == encoder_error);
  const std::string said = read_bytes(fake / "said");
  const auto first = said.find("h264_nvenc");
  REQUIRE(first != std::string::npos);
  CHECK(said.find("h264_nvenc", first + 1) != std::string::npos);
  CHECK(said.find("libx264") == std::string::npos);
  CHECK(folder.names().empty());
}

TEST_CASE("colours survive: flat areas within 3 levels for video, within 8 for the palette of a gif") {
  const TempFolder folder;
  Image image;
  image.resize(64, 64);
  const std::array<std::array<int, 3>, 4> colors = {
      {{200, 60, 40}, {30, 160, 90}, {60, 90, 220}, {235, 235, 235}}};
  const auto quadrant = [](int x, int y) { return static_cast<std::size_t>(x / 32 + 2 * (y / 32)); };
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        image.rgb[static_cast<std::size_t>(3 * (64 * y + x)) + c] =
            static_cast<std::uint8_t>(colors[quadrant(x, y)][c]);
      }
    }
  }
  for (const auto& [name, tolerance] : {std::pair{"a.mp4", 3}, {"a.webm", 3}, {"a.gif", 8}}) {
    const auto sink = make_sink(folder / name, sized(64, 64, 25));
    for (int i = 0; i < 3; ++i) sink->write(image);
    sink->finish();
    const std::string rgb = first_frame(folder / name);
    REQUIRE(rgb.size() == image.rgb.size());
    for (int corner = 0; corner < 4; ++corner) {
      const int x = 16 + 32 * (corner % 2), y = 16 + 32 * (corner / 2);
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t i = static_cast<std::size_t>(3 * (64 * y + x)) + c;
        INFO(name << " corner " << corner << " channel " << c);
        CHECK(std::abs(int(static_cast<unsigned char>(rgb[i])) - int(image.rgb[i])) <= tolerance);
      }
    }
  }
}

TEST_CASE("the same frames give the same bytes") {
  const TempFolder folder;
  for (const char* kind : {".mp4", ".webm", ".gif"}) {
    make_video(folder / (std::string("a") + kind), sized(64, 48), 12);
    make_video(folder / (std::string("b") + kind), sized(64, 48), 12);
    const std::string a = read_bytes(folder / (std::string("a") + kind));
    INFO(kind);
    CHECK(a.size() > 500);
    CHECK(a == read_bytes(folder / (std::string("b") + kind)));
  }
}

TEST_CASE("a video that is not finished leaves nothing, and soon") {
  const TempFolder folder;
  write_bytes(folder / "a.mp4", "before");
  SinkOptions options = sized(64, 48);
  options.force = true;
  {
    const auto sink = make_sink(folder / "a.mp4", options);
    write_frames(*sink, options, 5);
  }
  CHECK(folder.names() == std::vector<std::string>{"a.mp4"});
  CHECK(read_bytes(folder / "a.mp4") == "before");
  const auto sink = make_sink(folder / "b.mp4", options);
  CHECK(caught([&] { sink->finish(); }).says("no frame"));
}

TEST_CASE("without ffmpeg the error says what to install, before the first frame") {
  const TempFolder folder;
  const Environment nothing("PATH", (folder / "empty").string());
  const Caught error = caught([&] { make_sink(folder / "a.mp4", sized(64, 48)); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("ffmpeg was not found in PATH"));
  CHECK(error.says("apt-get install ffmpeg"));
  CHECK(folder.names().empty());
  CHECK(ffmpeg_version().empty());
}

TEST_CASE("the version of ffmpeg") { CHECK(ffmpeg_version().starts_with("ffmpeg version ")); }

TEST_CASE("an ffmpeg that fails half-way is quoted, and the video is not kept") {
  const FakeFfmpeg fake(
      "head -c 30000 > /dev/null\necho 'first line' >&2\necho 'disk on fire' >&2\nexit 3\n");
  const TempFolder folder;
  const SinkOptions options = sized(64, 48);
  const Caught error = caught([&] { make_video(folder / "a.mp4", options, 300); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("status 3"));
  CHECK(error.says("first line; disk on fire"));
  CHECK(error.text.find('\n') == std::string::npos);
  CHECK(folder.names().empty());
}

TEST_CASE("an ffmpeg that fails at the very end") {
  const FakeFfmpeg fake("cat > /dev/null\necho frame=3\necho 'no codec today' >&2\nexit 1\n");
  const TempFolder folder;
  const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 3); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("no codec today"));
  CHECK(folder.names().empty());
}

TEST_CASE("an ffmpeg that is killed, and one that closes its input and hangs") {
  const TempFolder folder;
  {
    const FakeFfmpeg fake("head -c 1000 > /dev/null\nkill -9 $$\n");
    const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 300); });
    CHECK(error.kind == encoder_error);
    CHECK(error.says("signal 9"));
  }
  {
    const FakeFfmpeg fake("exec 0<&-\nsleep 100\n");
    const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 300); });
    CHECK(error.kind == encoder_error);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("an ffmpeg that says it is fine but dropped frames") {
  const FakeFfmpeg fake(
      "cat > /dev/null\necho frame=1\necho progress=continue\necho frame=7\necho progress=end\nexit 0\n");
  const TempFolder folder;
  const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 8); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("7 frames of 8"));
  const Caught empty = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 7); });
  CHECK(empty.kind == encoder_error);
  CHECK(empty.says("wrote nothing"));
  CHECK(folder.names().empty());
}

TEST_CASE("an ffmpeg that talks a lot does not block, and only the end is kept") {
  const FakeFfmpeg fake(
      "yes 'a long complaint' | head -c 300000 >&2\ncat > /dev/null\necho 'the reason' >&2\nexit 1\n");
  const TempFolder folder;
  const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 3); });
  CHECK(error.says("the reason"));
  CHECK(error.text.size() < 8000);
}

TEST_CASE("a disk that fills while ffmpeg writes") {
  const TempFolder folder;
  {
    const FileSizeLimit full(3000);  // inherited by ffmpeg
    const Caught error = caught([&] { make_video(folder / "a.mp4", sized(320, 240), 30); });
    CHECK(error.kind == encoder_error);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("Ctrl-C in the terminal does not reach ffmpeg") {
  const FakeFfmpeg fake("ps -o pgid= -p $$ > \"$(dirname \"$0\")/group\"\ncat > /dev/null\nexit 1\n");
  const TempFolder folder;
  caught([&] { make_video(folder / "a.mp4", sized(64, 48), 1); });
  const int group = std::atoi(read_bytes(fake / "group").c_str());
  CHECK(group > 0);
  CHECK(group != ::getpgrp());
}

TEST_CASE("a video in the background, and its error there") {
  const TempFolder folder;
  const SinkOptions options = sized(64, 48);
  AsyncSink sink(make_sink(folder / "a.mp4", options));
  write_frames(sink, options, 15);
  sink.finish();
  CHECK(probe(folder / "a.mp4") == "64,48,60/1,15");

  const FakeFfmpeg fake("exit 9\n");
  AsyncSink failing(make_sink(folder / "b.mp4", options));
  const Caught error = caught([&] {
    write_frames(failing, options, 300);
    failing.finish();
  });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("status 9"));
}

}  // namespace pabd::test_video
