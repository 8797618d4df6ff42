// SPDX-License-Identifier: MIT
// Frames as PNG files: a numbered file each, or one file with the last frame.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <future>
#include <vector>

#include "render/output/sinks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

PngText text_of(const SinkOptions& options, int frame) {
  return options.png_text ? options.png_text(frame) : PngText{};
}

// Frame k is there only when all before it are: each file is whole and on the disk before the next is begun.
// Several frames are encoded side by side; files appear in the order of their numbers, so that what a run leaves when it
// is stopped has no gaps.
class PngSequenceSink : public FrameSink {
 public:
  PngSequenceSink(std::string frame_template, const SinkOptions& options)
      : template_(std::move(frame_template)), options_(options), next_(options.first_frame) {
    check_creatable(frame_path(template_, next_));
  }

  // Frames that are whole stay, also of a run that is stopped.
  ~PngSequenceSink() override {
    try {
      finish();
    } catch (const std::exception&) {  // the caller left because of it, or has no use for it
    }
  }

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    const std::filesystem::path path = frame_path(template_, next_);
    check_overwrite(path.string(), path, {true, &options_.inputs});
    if (waiting_.size() == side_by_side_) publish_oldest();
    waiting_.push_back({path, std::async(std::launch::async, [frame, text = text_of(options_, next_)] {
                          return encode_png(frame, text);
                        })});
    ++next_;
  }

  void finish() override {
    while (!waiting_.empty()) publish_oldest();
  }

 private:
  struct Encoding {
    std::filesystem::path path;
    std::future<std::vector<std::uint8_t>> bytes;
  };

  void publish_oldest() {
    try {
      const std::vector<std::uint8_t> bytes = waiting_.front().bytes.get();
      write_file(waiting_.front().path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      waiting_.pop_front();
    } catch (...) {
      waiting_.clear();  // no frame behind one that is missing
      throw;
    }
  }

  std::string template_;
  SinkOptions options_;
  int next_;
  std::size_t side_by_side_ = static_cast<std::size_t>(std::min(available_cpus(), 32));
  std::deque<Encoding> waiting_;
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
