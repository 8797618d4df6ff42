// SPDX-License-Identifier: MIT
// Videos on a disk that is full, and through an ffmpeg that stands still: an error, and nothing is left.
#include <sys/mount.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>
#include <functional>

#include "render/output/encoder_process.h"
#include "render/output/frame_sink.h"
#include "tests/support/errors.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/picture.h"
#include "tests/support/places.h"
#include "tests/support/running.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_video_faults {

namespace fs = std::filesystem;

namespace {

SinkOptions sized(int width, int height) {
  SinkOptions options;
  options.width = width;
  options.height = height;
  options.fps = 25;
  return options;
}

void make_video(const fs::path& path, const SinkOptions& options, int count) {
  const auto sink = make_sink(path, options);
  for (int i = 0; i < count; ++i) sink->write(test_frame(options.width, options.height, i));
  sink->finish();
}

// A small disk in a folder, for the life of this.
struct Disk {
  Disk(const fs::path& folder, const std::string& size)
      : path(folder), is_there(::mount("tmpfs", folder.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0) {}
  ~Disk() {
    if (is_there) ::umount2(path.c_str(), MNT_DETACH);
  }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;

  const fs::path path;
  const bool is_there;
};

// Every kind of video, from the smallest room to nearly enough.
void fill(const fs::path& folder, const std::function<Caught(const fs::path&, long long room)>& attempt) {
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    INFO(name);
    make_video(folder / name, sized(160, 120), 20);
    const auto whole = static_cast<long long>(fs::file_size(folder / name));
    fs::remove(folder / name);
    REQUIRE(whole > 6000);
    for (const double part : {0.1, 0.6, 0.97}) {
      INFO(part << " of " << whole << " bytes");
      const Caught error = attempt(folder / name, static_cast<long long>(part * static_cast<double>(whole)));
      INFO(error.text);
      CHECK(error.kind == encoder_error);
      CHECK(error.text.find('\n') == std::string::npos);
    }
  }
}

}  // namespace

TEST_CASE("a disk that is full at any point of a video: an error, and no file") {
  const TempFolder folder;
  fill(folder.path(), [&](const fs::path& path, long long room) {
    // Into ffmpeg only: this test has its disk as it is.
    const Environment preload("LD_PRELOAD", places::full_disk()),
        bytes("PABD_DISK_BYTES", std::to_string(room));
    const Caught error = caught([&] { make_video(path, sized(160, 120), 20); });
    CHECK(folder.names().empty());
    return error;
  });
}

TEST_CASE("the same on a real small disk, where one may be mounted") {
  const TempFolder folder;
  const fs::path disk = folder / "disk";
  fs::create_directory(disk);
  // Where it may not be mounted the case above stands alone, and this one says so.
  if (const Disk probe(disk, "4k"); !probe.is_there) {
    WARN("no disk may be mounted here: " << std::strerror(errno));
    CHECK((errno == EPERM || errno == EACCES));
    return;
  }
  const TempFolder elsewhere;
  fill(elsewhere.path(), [&](const fs::path& path, long long room) {
    const Disk small(disk, std::to_string(room));
    REQUIRE(small.is_there);
    // Whole pages: what is too much may still fit.
    write_bytes(disk / "ballast", std::string(4096, 'b'));
    const Caught error = caught([&] { make_video(disk / path.filename(), sized(160, 120), 20); });
    fs::remove(disk / "ballast");
    CHECK(fs::is_empty(disk));
    return error;
  });
}

TEST_CASE("whatever ffmpeg complains of fails the video, also when it ends well") {
  const TempFolder folder;
  // Everything is right, but for a word.
  const std::string real = std::getenv("PATH");
  const FakeFfmpeg fake(
      "PATH='" + real +
      "' ffmpeg \"$@\"\nstatus=$?\n"
      "case \"$*\" in *framecrc*) ;; *) echo 'Error writing trailer: No space left on device' >&2 ;; esac\n"
      "exit $status\n");
  const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 5); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("Error writing trailer"));
  CHECK(error.says("free some space"));
  CHECK(folder.names().empty());
}

TEST_CASE("a video is read back before it gets its name") {
  const TempFolder folder;
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    INFO(name);
    const fs::path file = folder / name;
    make_video(file, sized(96, 64), 12);
    CHECK(caught([&] { check_video("v", file, {96, 64, 12}, 60); }).kind == std::nullopt);
    CHECK(caught([&] { check_video("v", file, {96, 64, 13}, 60); }).says("12 frames of 96x64"));
    CHECK(caught([&] { check_video("v", file, {96, 66, 12}, 60); }).kind == encoder_error);
    const std::string whole = read_bytes(file);
    for (const double part : {0.0, 0.3, 0.8}) {
      write_bytes(file, whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
      INFO(part);
      CHECK(caught([&] { check_video("v", file, {96, 64, 12}, 60); }).kind == encoder_error);
    }
  }
  // ffmpeg that says all is well and leaves something else.
  const std::string real = std::getenv("PATH");
  const FakeFfmpeg fake("case \"$*\" in *framecrc*) PATH='" + real +
                        "' exec ffmpeg \"$@\";; esac\ncat > /dev/null\necho frame=3\n"
                        "for last; do :; done\necho 'no video' > \"${last#file:}\"\n");
  const Caught error = caught([&] { make_video(folder / "b.mp4", sized(64, 48), 3); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("cannot be read back"));
  CHECK_FALSE(fs::exists(folder / "b.mp4"));
}

TEST_CASE("an ffmpeg that makes no progress is ended with all that it started") {
  const std::string here = "echo $$ > \"$HERE/pids\"\nsleep 1000 &\necho $! >> \"$HERE/pids\"\n";
  for (const auto& [what, script] :
       {std::pair{"reads nothing", "sleep 1000\n"},
        {"reads all and never ends", "cat > /dev/null\nsleep 1000\n"},
        {"reads a little", "head -c 50000 > /dev/null\nsleep 1000\n"},
        {"talks, and says the same all the time", "while :; do echo frame=1; echo progress=continue; done\n"},
        {"stops itself", "kill -STOP $$\n"}}) {
    INFO(what);
    const FakeFfmpeg fake(here + script);
    const TempFolder folder;
    SinkOptions options = sized(320, 240);
    options.encoder_timeout = 0.5;
    const Caught error = caught([&] { make_video(folder / "a.mp4", options, 20); });  // 4.6 MB
    INFO(error.text);
    CHECK(error.kind == encoder_error);
    CHECK(error.says("made no progress for 0.5 s"));
    CHECK(error.says("--encoder-timeout"));
    CHECK(folder.names().empty());
    CHECK(all_ended(read_bytes(fake / "pids"), 2));
  }
}

TEST_CASE("a child of ffmpeg that holds its error stream is not waited for") {
  const FakeFfmpeg fake("sleep 1000 &\necho $! > \"$HERE/pids\"\ncat > /dev/null\necho frame=3\n");
  const TempFolder folder;
  const Caught error = caught([&] { make_video(folder / "a.mp4", sized(64, 48), 3); });
  CHECK(error.kind == encoder_error);
  CHECK(error.says("wrote nothing"));
  CHECK(folder.names().empty());
  CHECK(all_ended(read_bytes(fake / "pids"), 1));
}

TEST_CASE("an ffmpeg that says nothing about itself does not hold up the question for its version") {
  const FakeFfmpeg fake("echo 'ffmpeg version 0'\nsleep 1000 &\necho $! > \"$HERE/pids\"\n");
  CHECK(ffmpeg_version() == "ffmpeg version 0");
  CHECK(all_ended(read_bytes(fake / "pids"), 1));
}

}  // namespace pabd::test_video_faults
