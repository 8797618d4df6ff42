// SPDX-License-Identifier: MIT
// See video_options.h.
#include "render/output/video_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/output/encoder_trial.h"
#include "render/output/ffmpeg_arguments.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr VideoDefaults kMp4{18, 51, "veryfast"}, kWebm{24, 63, "fast"};
constexpr int kMostPlays = 65535;
constexpr const char* kVaapiDevice = "/dev/dri/renderD128";

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, message); }

// RGB to the colours that players expect of HD video, with exact rounding, and the tags that say so.
const char* const to_bt709 =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,format=";
const Arguments bt709_tags = {"-color_primaries", "bt709", "-color_trc",   "bt709",
                              "-colorspace",      "bt709", "-color_range", "tv"};

// A player can jump to a picture every two seconds.
std::string key_interval(double fps) {
  return fmt::format("{}", std::max(1, static_cast<int>(std::lround(2 * fps))));
}

std::size_t preset_index(const std::string& name) {
  const auto& names = preset_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

Arguments h264(const VideoOptions& options) {
  const std::string quality = std::to_string(options.crf.value_or(kMp4.crf));
  const std::string preset = options.preset.empty() ? kMp4.preset : options.preset;
  switch (options.encoder) {
    case VideoEncoder::nvenc: {
      constexpr const char* kPresets[] = {"p1", "p1", "p2", "p3", "p3", "p4", "p5", "p6", "p7"};
      return {"-vf",     std::string(to_bt709) + "yuv420p",
              "-c:v",    "h264_nvenc",
              "-preset", kPresets[preset_index(preset)],
              "-rc",     "vbr",
              "-cq",     quality,
              "-b:v",    "0"};
    }
    case VideoEncoder::vaapi:
      return {"-vf",  std::string(to_bt709) + "nv12,hwupload", "-c:v", "h264_vaapi", "-rc_mode", "CQP", "-qp",
              quality};
    case VideoEncoder::software:
      break;
  }
  return {"-vf", std::string(to_bt709) + "yuv420p", "-c:v", "libx264", "-preset", preset, "-crf", quality};
}

Arguments vp9(const VideoOptions& options) {
  // libvpx counts from 8, the fastest, to 0.
  const std::string preset = options.preset.empty() ? kWebm.preset : options.preset;
  const std::size_t speed = preset_names().size() - 1 - preset_index(preset);
  return {"-vf",           std::string(to_bt709) + "yuv420p",
          "-c:v",          "libvpx-vp9",
          "-crf",          std::to_string(options.crf.value_or(kWebm.crf)),
          "-b:v",          "0",
          "-deadline",     "good",
          "-cpu-used",     std::to_string(speed),
          "-row-mt",       "1",
          "-tile-columns", "2"};
}

}  // namespace

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = {"ultrafast", "superfast", "veryfast", "faster",  "fast",
                                                 "medium",    "slow",      "slower",   "veryslow"};
  return names;
}

VideoDefaults video_defaults(const std::string& extension) { return extension == ".mp4" ? kMp4 : kWebm; }

VideoEncoder parse_video_encoder(const std::string& word) {
  if (word == "software") return VideoEncoder::software;
  if (word == "nvenc") return VideoEncoder::nvenc;
  if (word == "vaapi") return VideoEncoder::vaapi;
  refuse(fmt::format("--encoder {}: expected software, nvenc or vaapi", word));
}

void check_video_options(const std::string& extension, const VideoOptions& options) {
  const bool mp4 = extension == ".mp4", webm = extension == ".webm", gif = extension == ".gif";
  if (options.crf) {
    if (!mp4 && !webm)
      refuse(fmt::format("--crf {}: only for .mp4 and .webm; expected one of them", *options.crf));
    const int most = video_defaults(extension).most_crf;
    if (*options.crf < 0 || *options.crf > most)
      refuse(
          fmt::format("--crf {}: expected 0 … {} for {}, smaller is better", *options.crf, most, extension));
  }
  if (!options.preset.empty()) {
    if (!mp4 && !webm)
      refuse(fmt::format("--preset {}: only for .mp4 and .webm; expected one of them", options.preset));
    if (preset_index(options.preset) == preset_names().size()) {
      std::string words;
      for (const std::string& name : preset_names()) words += (words.empty() ? "" : ", ") + name;
      refuse(fmt::format("--preset {}: expected one of {}", options.preset, words));
    }
    if (options.encoder == VideoEncoder::vaapi)
      refuse(fmt::format("--preset {}: VAAPI has none; leave it out", options.preset));
  }
  if (options.plays) {
    if (!gif)
      refuse(fmt::format("--loop {}: only a .gif says how often it is played; expected one", *options.plays));
    if (*options.plays < 0 || *options.plays > kMostPlays)
      refuse(fmt::format("--loop {}: expected 0 … {} times, 0: for ever", *options.plays, kMostPlays));
  }
  if (options.encoder != VideoEncoder::software && !mp4) {
    refuse(fmt::format("--encoder {}: only for .mp4; expected that, or --encoder software",
                       options.encoder == VideoEncoder::nvenc ? "nvenc" : "vaapi"));
  }
}

void check_video_encoder(const VideoOptions& options) {
  if (options.encoder == VideoEncoder::software) return;
  const bool nvenc = options.encoder == VideoEncoder::nvenc;
  const std::string said = encoder_complaint(device_arguments(options), h264(options));
  if (said.empty()) return;
  throw Error(
      ErrorKind::encoder,
      fmt::format("--encoder {}: ffmpeg cannot use {} here: {}; it needs {}; leave --encoder out to encode "
                  "with libx264",
                  nvenc ? "nvenc" : "vaapi", nvenc ? "h264_nvenc" : "h264_vaapi", said,
                  nvenc ? "an NVIDIA GPU with NVENC and its driver"
                        : fmt::format("a GPU with VAAPI behind {}", kVaapiDevice)));
}

std::vector<std::string> device_arguments(const VideoOptions& options) {
  if (options.encoder != VideoEncoder::vaapi) return {};
  return {"-vaapi_device", kVaapiDevice};
}

std::vector<std::string> video_arguments(const std::string& extension, double fps,
                                         const VideoOptions& options) {
  const bool mp4 = extension == ".mp4";
  Arguments list = mp4 ? h264(options) : vp9(options);
  append(list, {"-g", key_interval(fps)});
  append(list, bt709_tags);
  if (mp4) {
    append(list, {"-movflags", "+faststart+use_metadata_tags", "-f", "mp4"});
  } else {
    append(list, {"-f", "webm"});
  }
  return list;
}

}  // namespace pabd
