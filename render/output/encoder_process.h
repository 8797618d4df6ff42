// The ffmpeg program, fed through a pipe.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "render/output/descriptor.h"

namespace pabd {

// Runs in its own process group, so that Ctrl-C in a terminal reaches this program only and it can end the
// video.
class EncoderProcess {
 public:
  // Starts "ffmpeg" from PATH with these arguments (no shell), which make it read pipe:0 and report
  // "-progress pipe:1". `name` is the output, for messages. Throws Error(encoder) if it cannot be started.
  EncoderProcess(std::string name, const std::vector<std::string>& arguments);
  ~EncoderProcess();  // kills it when still running
  EncoderProcess(const EncoderProcess&) = delete;
  EncoderProcess& operator=(const EncoderProcess&) = delete;

  // Throws Error(encoder) quoting ffmpeg's own last words when it ended early.
  void write(const void* data, std::size_t size);

  // Ends its input and waits for it. Returns the number of frames it says it encoded.
  // Throws Error(encoder) if it did not end with status 0.
  long finish();

 private:
  void listen();
  void take_progress(const char* text, std::size_t size);
  void take_messages(const char* text, std::size_t size);
  bool wait_until_ended(bool forever);
  [[noreturn]] void fail(const std::string& what);

  std::string name_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool status_known_ = false;
  Descriptor input_, progress_, messages_;
  std::thread listener_;
  // Written by the listener; read after it was joined.
  std::string progress_line_;
  std::string tail_;  // the last 4 KiB of ffmpeg's stderr
  long frames_ = 0;
};

// The first line of "ffmpeg -version"; empty when there is no ffmpeg in PATH.
std::string ffmpeg_version();

}  // namespace pabd
