// SPDX-License-Identifier: MIT
// See live_video.h.
#include "render/output/live_video.h"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "render/output/encoder_trial.h"
#include "render/output/ffmpeg_arguments.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);  // between two looks whether ffmpeg is still there

// Without B frames and looking ahead; a delimiter before every picture, a key frame only at the beginning.
Arguments codec_arguments(int crf, VideoEncoder encoder) {
  constexpr const char* kNever = "1000000000";
  const std::string quality = std::to_string(crf);
  if (encoder == VideoEncoder::nvenc)
    return {"-c:v", "h264_nvenc", "-preset",      "p1", "-tune", "ull", "-rc",      "vbr",
            "-cq",  quality,      "-b:v",         "0",  "-bf",   "0",   "-delay",   "0",
            "-g",   kNever,       "-zerolatency", "1",  "-aud",  "1",   "-pix_fmt", "yuv420p"};
  return {"-c:v",     "libx264", "-preset", "ultrafast", "-tune", "zerolatency", "-crf",     quality,
          "-threads", "2",       "-g",      kNever,      "-aud",  "1",           "-pix_fmt", "yuv420p"};
}

// Planes from pipe:0; to pipe:1 each picture as soon as it was taken.
Arguments arguments(const LiveVideoSetup& setup) {
  Arguments list = {"-nostdin",
                    "-hide_banner",
                    "-nostats",
                    "-loglevel",
                    "error",
                    "-probesize",
                    "32",
                    "-f",
                    "rawvideo",
                    "-pixel_format",
                    "yuv420p",
                    "-color_range",
                    "pc",
                    "-video_size",
                    fmt::format("{}x{}", setup.width, setup.height),
                    "-framerate",
                    "30",
                    "-i",
                    "pipe:0",
                    "-an",
                    "-fps_mode",
                    "passthrough"};
  const Arguments codec = codec_arguments(setup.crf, setup.encoder);
  list.insert(list.end(), codec.begin(), codec.end());
  list.insert(list.end(), {"-color_range", "pc", "-colorspace", "smpte170m", "-color_primaries", "bt709",
                           "-color_trc", "iec61966-2-1", "-flags:v", "+bitexact", "-flush_packets", "1",
                           "-flvflags", "no_duration_filesize+no_sequence_end", "-f", "flv", "pipe:1"});
  return list;
}

}  // namespace

VideoEncoder live_video_encoder() {
  constexpr int kAnyCrf = 23;
  if (encoder_complaint({}, codec_arguments(kAnyCrf, VideoEncoder::nvenc)).empty())
    return VideoEncoder::nvenc;
  const std::string said = encoder_complaint({}, codec_arguments(kAnyCrf, VideoEncoder::software));
  if (said.empty()) return VideoEncoder::software;
  throw Error(ErrorKind::encoder,
              fmt::format("--codec h264: ffmpeg cannot encode H.264 here: {}; install it: apt-get "
                          "install ffmpeg, or leave --codec out",
                          said));
}

LiveVideo::LiveVideo(const LiveVideoSetup& setup) : setup_(setup) {
  EncoderSetup encoder;
  encoder.name = "H.264";
  encoder.patience = setup.start_patience;
  encoder.arguments = arguments(setup);
  encoder.output = [this](std::string_view bytes) {
    {
      const std::scoped_lock lock(mutex_);
      heard_ += bytes;
    }
    arrived_.notify_one();
  };
  encoder.way_out = "use --codec jpeg";
  ffmpeg_ = std::make_unique<EncoderProcess>(std::move(encoder));
}

LiveVideo::~LiveVideo() = default;

VideoUnit LiveVideo::encode(std::span<const std::uint8_t> yuv) {
  const auto begin = std::chrono::steady_clock::now();
  ffmpeg_->write(yuv.data(), yuv.size());
  for (;;) {
    std::string heard;
    {
      std::unique_lock lock(mutex_);
      arrived_.wait_for(lock, kLook, [&] { return !heard_.empty(); });
      heard = std::exchange(heard_, {});
    }
    units_.append(heard);
    if (auto unit = units_.next()) {
      ffmpeg_->set_patience(setup_.patience);  // from now on it runs
      return std::move(*unit);
    }
    if (!heard.empty()) continue;
    if (ffmpeg_->has_ended()) {
      ffmpeg_->finish();  // throws its last words, if it had any
      throw Error(ErrorKind::encoder, "H.264: ffmpeg ended in the middle of a stream");
    }
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
    if (waited.count() > ffmpeg_->patience())
      throw Error(ErrorKind::encoder,
                  fmt::format("H.264: ffmpeg gave no picture for {:g} s", ffmpeg_->patience()));
  }
}

}  // namespace pabd
