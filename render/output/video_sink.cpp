// SPDX-License-Identifier: MIT
// Frames as a video: mp4 (H.264) or webm (VP9), encoded by the ffmpeg program.
//
// The same frames give the same bytes on every machine with the same ffmpeg: no dates, no program names, a
// fixed number of threads. The file gets its name only when ffmpeg ended well without a complaint, and every
// frame can be read back from it.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "render/output/encoder_process.h"
#include "render/output/ffmpeg_arguments.h"
#include "render/output/sinks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// Tags of the file; what a system limits in a command line is left out.
Arguments metadata(const PngText& about) {
  constexpr std::size_t kMostOfTag = 100'000;  // bytes; Linux takes 131072 an argument
  Arguments list;
  const auto add = [&](const std::string& key, const std::string& value) {
    if (value.size() <= kMostOfTag) append(list, {"-metadata", key + "=" + value});
  };
  const auto scene = about.find("Scene");
  if (scene != about.end()) add("title", scene->second);
  for (const auto& [key, value] : about) add(key, value);
  return list;
}

class VideoSink : public FrameSink {
 public:
  VideoSink(std::string path, const SinkOptions& options)
      : path_(std::move(path)),
        options_(options),
        width_(side_in_file(path_, options.width)),
        height_(side_in_file(path_, options.height)) {
    const std::string kind = std::filesystem::path(path_).extension().string();
    check_video_encoder(options.video);

    file_.emplace(path_);
    Arguments list = words("{} -progress pipe:1", kQuietFfmpeg);
    append(list, raw_input("rgb24", width_, height_, options.fps));
    append(list, video_arguments(kind, options.fps, options.video));
    append(list, words("-threads 4 -map_metadata -1 -fflags +bitexact -flags:v +bitexact"));
    append(list, metadata(options.about));
    append(list, {"-y", file_argument(file_->temporary())});
    encoder_.emplace(EncoderSetup{path_, file_->temporary(), options_.encoder_timeout, std::move(list)});
  }

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    ++sent_;
    if (width_ == frame.width && height_ == frame.height) {
      encoder_->write(frame.rgb.data(), frame.rgb.size());
    } else {
      const Image padded = extended(frame, width_, height_);
      encoder_->write(padded.rgb.data(), padded.rgb.size());
    }
  }

  void finish() override {
    encoder_->finish_after(sent_);
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(file_->temporary(), unknown);
    if (!unknown && bytes == 0 && std::filesystem::is_regular_file(file_->temporary(), unknown)) {
      throw Error(ErrorKind::encoder, fmt::format("{}: ffmpeg ended well but wrote nothing", path_));
    }
    if (std::filesystem::is_regular_file(file_->temporary(), unknown))
      check_video(path_, file_->temporary(), {width_, height_, sent_}, options_.encoder_timeout);
    file_->commit();
  }

 private:
  std::string path_;
  SinkOptions options_;
  int width_, height_;  // of the video
  long sent_ = 0;
  std::optional<AtomicFile> file_;  // outlives the encoder, which writes into it
  std::optional<EncoderProcess> encoder_;
};

}  // namespace

// H.264 in 4:2:0 needs even ones.
int side_in_file(const std::string& out, int side) {
  return std::filesystem::path(out).extension() == ".mp4" ? side + side % 2 : side;
}

std::unique_ptr<FrameSink> make_video_sink(const std::string& path, const SinkOptions& options) {
  return std::make_unique<VideoSink>(path, options);
}

}  // namespace pabd
