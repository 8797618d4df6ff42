// SPDX-License-Identifier: MIT
// Frames as raw RGB bytes on a descriptor, for a program behind a pipe.
#include <fmt/format.h>

#include <cerrno>

#include "render/output/sinks.h"
#include "sim/base/descriptor.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

class RawSink : public FrameSink {
 public:
  RawSink(int descriptor, std::string name, const SinkOptions& options)
      : descriptor_(descriptor), name_(std::move(name)), options_(options) {}

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    const BlockSigpipe no_signal;
    const int reason = write_all(descriptor_, frame.rgb.data(), frame.rgb.size());
    if (reason == EPIPE) {
      throw Error(ErrorKind::file,
                  fmt::format("{}: the program that reads the frames ended after {} of them; expected it "
                              "to read to the end",
                              name_, frames_));
    }
    if (reason != 0) {
      throw Error(ErrorKind::file, fmt::format("{}: frame {} could not be written: {}", name_, frames_,
                                               system_reason(reason)));
    }
    ++frames_;
  }

  void finish() override {}

 private:
  int descriptor_;
  std::string name_;
  SinkOptions options_;
  int frames_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> make_raw_sink(int descriptor, const std::string& name,
                                         const SinkOptions& options) {
  return std::make_unique<RawSink>(descriptor, name, options);
}

}  // namespace pabd
