// SPDX-License-Identifier: MIT
// Frames as PNG files: a numbered file each, or one file with the last frame.
#include <fmt/format.h>

#include "render/output/sinks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

PngText text_of(const SinkOptions& options, int frame) {
  return options.png_text ? options.png_text(frame) : PngText{};
}

// Frame k is there only when all before it are: each file is whole and on the disk before the next is begun.
class PngSequenceSink : public FrameSink {
 public:
  PngSequenceSink(std::string frame_template, const SinkOptions& options)
      : template_(std::move(frame_template)), options_(options), next_(options.first_frame) {
    check_creatable(frame_path(template_, next_));
  }

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    const std::filesystem::path path = frame_path(template_, next_);
    check_overwrite(path.string(), path, {true, &options_.inputs});
    write_png(path, frame, text_of(options_, next_));
    ++next_;
  }

  void finish() override {}

 private:
  std::string template_;
  SinkOptions options_;
  int next_;
};

class LastPngSink : public FrameSink {
 public:
  LastPngSink(std::string path, const SinkOptions& options)
      : path_(std::move(path)), options_(options), next_(options.first_frame) {
    check_creatable(path_);
  }

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    last_ = frame;
    ++next_;
  }

  void finish() override {
    if (last_.rgb.empty())
      throw Error(ErrorKind::file, fmt::format("{}: there was no frame to write", path_));
    write_png(path_, last_, text_of(options_, next_ - 1));
  }

 private:
  std::string path_;
  SinkOptions options_;
  Image last_;
  int next_;
};

}  // namespace

std::unique_ptr<FrameSink> make_png_sequence_sink(const std::string& frame_template,
                                                  const SinkOptions& options) {
  return std::make_unique<PngSequenceSink>(frame_template, options);
}

std::unique_ptr<FrameSink> make_last_png_sink(const std::string& path, const SinkOptions& options) {
  return std::make_unique<LastPngSink>(path, options);
}

}  // namespace pabd
