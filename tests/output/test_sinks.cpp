// SPDX-License-Identifier: MIT
// Frames to numbered files, to one file, to a descriptor, and in the background.
#include <catch2/catch.hpp>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "render/output/async_sink.h"
#include "render/output/sinks.h"
#include "sim/base/descriptor.h"
#include "sim/base/input_file.h"
#include "tests/support/errors.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/picture.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_sinks {

namespace fs = std::filesystem;

namespace {

SinkOptions small() {
  SinkOptions options;
  options.width = 20;
  options.height = 12;
  return options;
}

Image frame(int seed) { return test_frame(20, 12, seed); }

// Keeps what it gets; can be told to fail or to wait.
struct Record {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Image> frames;
  bool finished = false;
  bool closed = false;  // write waits while this is set
  int fails_at = -1;
  int attempts = 0;
  std::thread::id thread;
};

class RecordingSink : public FrameSink {
 public:
  explicit RecordingSink(Record& record) : record_(record) {}
  void write(const Image& image) override {
    std::unique_lock lock(record_.mutex);
    record_.changed.wait(lock, [this] { return !record_.closed; });
    record_.thread = std::this_thread::get_id();
    ++record_.attempts;
    if (static_cast<int>(record_.frames.size()) == record_.fails_at)
      throw Error(ErrorKind::file, "disk full");
    record_.frames.push_back(image);
    record_.changed.notify_all();
  }
  void finish() override { record_.finished = true; }

 private:
  Record& record_;
};

}  // namespace

TEST_CASE("names of frames") {
  CHECK(frame_path("a/f{frame}.png", 7) == "a/f7.png");
  CHECK(frame_path("a/f{frame:04}.png", 7) == "a/f0007.png");
  CHECK(frame_path("{frame:04}", 123456) == "123456");
  CHECK(frame_path("a b%s_{frame:01}x.png", 0) == "a b%s_0x.png");
  CHECK(is_frame_template("{frame}.png"));
  CHECK_FALSE(is_frame_template("frame.png"));
  CHECK_FALSE(is_frame_template("%04d.png"));
  for (const char* wrong :
       {"a.png", "{frame}{frame}.png", "{frame:4}.png", "{frame:00}.png", "{frame:012}.png", "{frame:-4}.png",
        "{frame.png", "frame}.png", "}{frame.png", "{frames}.png", "{}.png", "{{frame}}.png", "{frame}/a.png",
        "{frame}/{frame}.png", ""}) {
    INFO(wrong);
    const Caught error = caught([&] { frame_path(wrong, 0); });
    CHECK(error.kind == bad_input);
    CHECK(error.says("{frame:04}"));
  }
  CHECK(caught([] { frame_path("{frame}.png", -1); }).kind == bad_input);
}

TEST_CASE("frames that exist are found, other files are not taken for frames") {
  const TempFolder folder;
  const std::string form = folder / "f_{frame:03}.png";
  CHECK(first_missing_frame(form) == 0);
  CHECK(first_existing_frame(form, 0) == -1);
  for (const char* name : {"f_000.png", "f_001.png", "f_002.png", "f_007.png", "f_1000.png", "f_3.png",
                           "f_0003.png", "f_-03.png", "f_ 03.png", "f_003.png.tmp", "f_.png", "g_003.png",
                           ".f_003.png.abc.tmp", "f_99999999999999999999.png"}) {
    write_bytes(folder / name, "");
  }
  CHECK(first_missing_frame(form) == 3);
  CHECK(first_existing_frame(form, 0) == 0);
  CHECK(first_existing_frame(form, 3) == 7);
  CHECK(first_existing_frame(form, 8) == 1000);
  CHECK(first_existing_frame(form, 1001) == -1);
}

TEST_CASE("outputs that cannot be are refused before the first frame") {
  const TempFolder folder;
  const auto make = [&](const std::string& name, const SinkOptions& options = small()) {
    return caught([&] { make_sink(name.empty() ? name : (folder / name).string(), options); });
  };
  for (const char* name : {"a.avi", "a", "a.PNG", "a.jpg", "", "{frame:04}.mp4", "{frame}", "a.png/"}) {
    INFO(name);
    CHECK(make(name).kind == bad_input);
  }
  CHECK(make("f%04d.png").says("write {frame} or {frame:04}"));
  CHECK(make("{frame:4}.png").kind == bad_input);
  CHECK(make("{fram}.png").kind == bad_input);
  write_bytes(folder / "file", "");
  for (const char* name : {"file/{frame:04}.png", "file/a.png", "file/a.mp4"}) {
    INFO(name);
    CHECK(make(name).kind == file_error);
    CHECK(make(name).says("is a file, not a folder"));
  }
  SinkOptions options = small();
  options.width = 0;
  CHECK(make("a.png", options).kind == bad_input);
  options.width = 16385;
  CHECK(make("a.png", options).kind == bad_input);
  for (double fps : {0.0, -60.0, std::nan(""), HUGE_VAL, 1e9}) {
    options = small();
    options.fps = fps;
    CHECK(make("a.mp4", options).kind == bad_input);
  }
  options = small();
  options.first_frame = -1;
  CHECK(make("{frame}.png", options).kind == bad_input);
  options.first_frame = 3;
  CHECK(make("a.mp4", options).says("resumed"));
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("what exists is kept unless force") {
  const TempFolder folder;
  for (const char* name : {"a.png", "a.mp4", "f0002.png"}) write_bytes(folder / name, "mine");
  for (const char* name : {"a.png", "a.mp4"}) {
    const Caught error = caught([&] { make_sink(folder / name, small()); });
    CHECK(error.kind == exists);
    CHECK(error.says("--force"));
  }
  const Caught frames = caught([&] { make_sink(folder / "f{frame:04}.png", small()); });
  CHECK(frames.kind == exists);
  CHECK(frames.says("f0002.png"));
  CHECK(frames.says("--resume"));
  CHECK(frames.says("--force"));

  SinkOptions options = small();
  options.force = true;
  const auto one = make_sink(folder / "a.png", options);
  CHECK(read_bytes(folder / "a.png") == "mine");  // until there is something better
  one->write(frame(1));
  one->finish();
  CHECK(read_png(folder / "a.png").rgb == frame(1).rgb);
  const auto many = make_sink(folder / "f{frame:04}.png", options);
  for (int i = 0; i < 3; ++i) many->write(frame(i));
  many->finish();
  CHECK(read_png(folder / "f0002.png").rgb == frame(2).rgb);
}

TEST_CASE("a sequence has a whole file a frame, in their order, with its text; it can be resumed") {
  const TempFolder folder;
  SinkOptions options = small();
  options.png_text = [](int number) { return PngText{{"frame", std::to_string(number)}}; };
  const std::string form = folder / "f{frame:02}.png";
  {
    const auto sink = make_sink(form, options);
    CHECK(folder.names().empty());
    for (int i = 0; i < 3; ++i) sink->write(frame(i));
    // not finished: as after Ctrl-C
  }
  for (int i = 0; i < 3; ++i) CHECK(read_png(frame_path(form, i)).rgb == frame(i).rgb);
  options.first_frame = first_missing_frame(form);
  CHECK(options.first_frame == 3);
  const auto sink = make_sink(form, options);
  sink->write(frame(3));
  sink->finish();
  CHECK(folder.names() == std::vector<std::string>{"f00.png", "f01.png", "f02.png", "f03.png"});
  for (int i = 0; i < 4; ++i)
    CHECK(read_png_text(frame_path(form, i)) == PngText{{"frame", std::to_string(i)}});
}

TEST_CASE("many frames encoded side by side are those that one after the other gives, byte by byte") {
  const TempFolder folder;
  SinkOptions options = small();
  options.png_text = [](int number) { return PngText{{"frame", std::to_string(number)}}; };
  const std::string form = folder / "f{frame}.png";
  const auto sink = make_sink(form, options);
  for (int i = 0; i < 100; ++i) sink->write(frame(i));
  sink->finish();
  for (int i = 0; i < 100; ++i) {
    const std::vector<std::uint8_t> alone = encode_png(frame(i), {{"frame", std::to_string(i)}});
    CHECK(read_file(frame_path(form, i), 1 << 20, "a PNG file") == std::string(alone.begin(), alone.end()));
  }
}

TEST_CASE("one file gets the last frame, at the end") {
  const TempFolder folder;
  SinkOptions options = small();
  options.png_text = [](int number) { return PngText{{"frame", std::to_string(number)}}; };
  const auto sink = make_sink(folder / "a.png", options);
  CHECK(caught([&] { sink->finish(); }).says("no frame"));
  for (int i = 0; i < 3; ++i) sink->write(frame(i));
  CHECK(folder.names().empty());
  sink->finish();
  CHECK(read_png(folder / "a.png").rgb == frame(2).rgb);
  CHECK(read_png_text(folder / "a.png") == PngText{{"frame", "2"}});
}

TEST_CASE("frames of another size are a defect") {
  const TempFolder folder;
  for (const char* name : {"a.png", "{frame}.png", "a.gif"}) {
    const auto sink = make_sink(folder / name, small());
    CHECK(caught([&] { sink->write(test_frame(21, 12, 0)); }).kind == defect);
    Image broken = frame(0);
    broken.rgb.resize(5);
    CHECK(caught([&] { sink->write(broken); }).kind == defect);
  }
}

TEST_CASE("a disk that fills keeps the frames before and no part of the one that failed") {
  const TempFolder folder;
  const std::string form = folder / "{frame}.png";
  {
    const auto first = make_sink(form, small());
    first->write(frame(0));
    first->finish();
  }
  SinkOptions options = small();
  options.first_frame = 1;
  const auto sink = make_sink(form, options);
  {
    const FileSizeLimit full(100);
    const auto write_all = [&] {
      for (int i = 1; i < 80; ++i) sink->write(frame(i));  // more than are encoded side by side
      sink->finish();
    };
    CHECK(caught(write_all).kind == file_error);
  }
  CHECK(folder.names() == std::vector<std::string>{"0.png"});
  CHECK(read_png(folder / "0.png").rgb == frame(0).rgb);
}

TEST_CASE("raw frames on a descriptor") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  Descriptor in(ends[0]), out(ends[1]);
  const auto sink = make_raw_sink(out.get(), "stdout", small());
  sink->write(frame(0));  // 720 bytes fit into a pipe
  sink->write(frame(1));
  sink->finish();
  std::vector<std::uint8_t> got(1440);
  REQUIRE(::read(in.get(), got.data(), got.size()) == 1440);
  std::vector<std::uint8_t> wanted = frame(0).rgb;
  const Image second = frame(1);
  wanted.insert(wanted.end(), second.rgb.begin(), second.rgb.end());
  CHECK(got == wanted);

  in.close();  // the reader goes away: an error, and no SIGPIPE that would end this program
  const Caught error = caught([&] { sink->write(frame(2)); });
  CHECK(error.kind == file_error);
  CHECK(error.says("after 2 of them"));

  const Descriptor full(::open("/dev/full", O_WRONLY));
  CHECK(caught([&] {
          make_raw_sink(full.get(), "stdout", small())->write(frame(0));
        }).says("no space left on device"));
}

TEST_CASE("in the background: all frames, in order, on one other thread") {
  Record record;
  AsyncSink sink(std::make_unique<RecordingSink>(record));
  for (int i = 0; i < 20; ++i) sink.write(frame(i));
  sink.finish();
  CHECK(record.finished);
  REQUIRE(record.frames.size() == 20);
  for (int i = 0; i < 20; ++i) CHECK(record.frames[static_cast<std::size_t>(i)].rgb == frame(i).rgb);
  CHECK(record.thread != std::this_thread::get_id());
  CHECK(sink.busy_ms() >= 0);
  CHECK(caught([&] { sink.write(frame(0)); }).kind == defect);
  CHECK(caught([&] { sink.finish(); }).kind == defect);
}

TEST_CASE("in the background: the ring holds three frames, then write waits") {
  Record record;
  record.closed = true;
  AsyncSink sink(std::make_unique<RecordingSink>(record), 3);
  for (int i = 0; i < 3; ++i) sink.write(frame(i));  // returns though nothing can be written
  std::atomic<bool> fourth{false};
  std::thread producer([&] {
    sink.write(frame(3));
    fourth = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK_FALSE(fourth);
  {
    const std::lock_guard lock(record.mutex);
    record.closed = false;
  }
  record.changed.notify_all();
  producer.join();
  CHECK(fourth);
  sink.finish();
  CHECK(record.frames.size() == 4);
  CHECK(sink.busy_ms() > 0);
}

TEST_CASE("in the background: an error comes back, and no frame after it is written") {
  for (bool at_finish : {false, true}) {
    Record record;
    record.fails_at = 2;
    AsyncSink sink(std::make_unique<RecordingSink>(record), 8);
    Caught error;
    if (at_finish) {
      record.closed = true;  // so that frames wait behind the one that fails
      for (int i = 0; i < 6; ++i) sink.write(frame(i));
      {
        const std::lock_guard lock(record.mutex);
        record.closed = false;
      }
      record.changed.notify_all();
      error = caught([&] { sink.finish(); });
    } else {
      error = caught([&] {
        for (int i = 0; i < 100; ++i) sink.write(frame(i));
      });
      CHECK(caught([&] { sink.write(frame(0)); }).kind == file_error);
    }
    CHECK(error.kind == file_error);
    CHECK(error.text == "disk full");
    CHECK(record.frames.size() == 2);
    CHECK_FALSE(record.finished);
    CHECK(record.attempts == 3);
  }
}

TEST_CASE("in the background: without finish nothing is published") {
  Record record;
  {
    AsyncSink sink(std::make_unique<RecordingSink>(record));
    sink.write(frame(0));
  }
  CHECK_FALSE(record.finished);
  CHECK(record.frames.size() <= 1);
}

TEST_CASE("in the background: frame k is there only when all before it are") {
  const TempFolder folder;
  const std::string form = folder / "{frame:03}.png";
  std::atomic<bool> done{false};
  std::atomic<int> gaps{0};
  std::thread watcher([&] {
    while (!done) {
      // The later one is looked for first: what is there then must have all before it.
      for (int k = 29; k > 0; --k) {
        if (fs::exists(frame_path(form, k)) && !fs::exists(frame_path(form, k - 1))) ++gaps;
      }
    }
  });
  AsyncSink sink(make_sink(form, small()));
  for (int i = 0; i < 30; ++i) sink.write(frame(i));
  sink.finish();
  done = true;
  watcher.join();
  CHECK(gaps == 0);
  CHECK(folder.names().size() == 30);
}

}  // namespace pabd::test_sinks
