// SPDX-License-Identifier: MIT
// The ffmpeg program, fed through a pipe.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "sim/base/child_process.h"

namespace pabd {

struct EncoderSetup {
  std::string name;                    // of the output, for messages
  std::filesystem::path file;          // that ffmpeg writes
  double patience = 60;                // seconds without any progress before it is ended
  std::vector<std::string> arguments;  // of ffmpeg; make it read pipe:0 and report "-progress pipe:1"
};

// ffmpeg makes progress when it takes bytes, reports frames, or changes the file. It is only waited for in
// write() and finish(): how long the frames take to make does not count.
class EncoderProcess {
 public:
  // Starts "ffmpeg" from PATH (no shell). Throws Error(encoder) if it cannot be started.
  explicit EncoderProcess(EncoderSetup setup);
  ~EncoderProcess();  // ends it when still running
  EncoderProcess(const EncoderProcess&) = delete;
  EncoderProcess& operator=(const EncoderProcess&) = delete;

  // Throws Error(encoder) quoting ffmpeg's own last words when it ended early or stands still.
  void write(const void* data, std::size_t size);

  // Ends its input and waits for it. Returns the number of frames it says it encoded.
  // Throws Error(encoder) if it did not end with status 0, stands still, or complained: ffmpeg ends with 0
  // even when the disk was full.
  long finish();
  // The same; throws Error(encoder) too when it says another number of frames than `sent`, or none were.
  void finish_after(long sent);

 private:
  class Patience;
  void listen();
  void end_and_hear();
  [[noreturn]] void fail(const std::string& what);
  [[noreturn]] void give_up();

  EncoderSetup setup_;
  ChildProcess child_;
  Descriptor over_read_, over_write_;  // a pipe: a byte in it tells the listener that ffmpeg has ended
  std::thread listener_;
  std::atomic<long> frames_{0};
  Tail tail_;  // of ffmpeg's standard error; written by the listener, read after it was joined
};

struct VideoFacts {
  int width = 0, height = 0;
  long frames = 0;
};

// Reads the whole file as a player would, through the ffmpeg program, without unpacking pictures: asked before a video
// gets its name. Throws Error(encoder) that begins with `name` if it holds anything but `expected`, or ffmpeg complains
// about it or says nothing for `patience` seconds.
void check_video(const std::string& name, const std::filesystem::path& file, const VideoFacts& expected,
                 double patience);

// The first line of "ffmpeg -version"; empty when there is no ffmpeg in PATH.
std::string ffmpeg_version();

}  // namespace pabd
