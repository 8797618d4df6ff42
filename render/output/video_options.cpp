// SPDX-License-Identifier: MIT
// See video_options.h.
#include "render/output/video_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/output/ffmpeg_arguments.h"
#include "sim/base/child_process.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

constexpr VideoDefaults kMp4{18, 51, "veryfast"}, kWebm{24, 63, "fast"};
constexpr int kMostPlays = 65535;
constexpr double kTrialPatience = 30;  // s

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, message); }

// RGB to the colours that players expect of HD video, with exact rounding, and the tags that say so.
constexpr const char* kToBt709 =
    "-vf scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,"
    "format=yuv420p";
constexpr const char* kBt709Tags =
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

std::size_t preset_index(const std::string& name) {
  const auto& names = preset_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

Arguments codec_of(bool mp4, const VideoOptions& options) {
  const VideoDefaults& usual = mp4 ? kMp4 : kWebm;
  const int quality = options.crf.value_or(usual.crf);
  const std::string preset = options.preset.empty() ? usual.preset : options.preset;
  if (!mp4) {
    // libvpx counts from 8, the fastest, to 0.
    return words("{} -c:v libvpx-vp9 -crf {} -b:v 0 -deadline good -cpu-used {} -row-mt 1 -tile-columns 2",
                 kToBt709, quality, preset_names().size() - 1 - preset_index(preset));
  }
  if (options.encoder == VideoEncoder::nvenc) {
    constexpr const char* kPresets[] = {"p1", "p1", "p2", "p3", "p3", "p4", "p5", "p6", "p7"};
    return words("{} -c:v h264_nvenc -preset {} -rc vbr -cq {} -b:v 0", kToBt709,
                 kPresets[preset_index(preset)], quality);
  }
  return words("{} -c:v libx264 -preset {} -crf {}", kToBt709, preset, quality);
}

// What follows is about what follows from it: "[h264_nvenc @ 0x5632…] Cannot load libcuda.so.1".
std::string first_reason(const std::string& errors) {
  std::string line = without_addresses(errors.substr(0, errors.find('\n')));
  if (line.ends_with('.')) line.pop_back();
  const auto end = line.starts_with('[') ? line.find("] ") : std::string::npos;
  return one_line(end == std::string::npos ? line : line.substr(end + 2));
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
  refuse(fmt::format("--encoder {}: expected software or nvenc", word));
}

void check_video_options(const std::string& extension, const VideoOptions& options) {
  const bool mp4 = extension == ".mp4", video = mp4 || extension == ".webm";
  if (options.crf) {
    if (!video) refuse(fmt::format("--crf {}: only for .mp4 and .webm; expected one of them", *options.crf));
    const int most = video_defaults(extension).most_crf;
    if (*options.crf < 0 || *options.crf > most)
      refuse(
          fmt::format("--crf {}: expected 0 … {} for {}, smaller is better", *options.crf, most, extension));
  }
  if (!options.preset.empty()) {
    if (!video)
      refuse(fmt::format("--preset {}: only for .mp4 and .webm; expected one of them", options.preset));
    if (preset_index(options.preset) == preset_names().size())
      refuse(fmt::format("--preset {}: expected one of {}", options.preset, fmt::join(preset_names(), ", ")));
  }
  if (options.plays) {
    if (extension != ".gif")
      refuse(fmt::format("--loop {}: only a .gif says how often it is played; expected one", *options.plays));
    if (*options.plays < 0 || *options.plays > kMostPlays)
      refuse(fmt::format("--loop {}: expected 0 … {} times, 0: for ever", *options.plays, kMostPlays));
  }
  if (options.encoder != VideoEncoder::software && !mp4)
    refuse("--encoder nvenc: only for .mp4; expected that, or --encoder software");
}

void check_video_encoder(const VideoOptions& options) {
  if (options.encoder == VideoEncoder::software) return;
  const std::string said = encoder_complaint(".mp4", options);
  if (said.empty()) return;
  throw Error(
      ErrorKind::encoder,
      fmt::format("--encoder nvenc: ffmpeg cannot use h264_nvenc here: {}; it needs an NVIDIA GPU with "
                  "NVENC and its driver; leave --encoder out to encode with libx264",
                  said));
}

std::vector<std::string> video_arguments(const std::string& extension, double fps,
                                         const VideoOptions& options) {
  const bool mp4 = extension == ".mp4";
  Arguments list = codec_of(mp4, options);
  // A player can jump to a picture every two seconds.
  append(list, words("-g {} {}", std::max(1L, std::lround(2 * fps)), kBt709Tags));
  append(list, words("{}", mp4 ? "-movflags +faststart+use_metadata_tags -f mp4" : "-f webm"));
  return list;
}

std::string encoder_complaint(const std::string& extension, const VideoOptions& options) {
  Arguments command = words("ffmpeg {} -f lavfi -i color=size=256x256:rate=10:duration=0.1", kQuietFfmpeg);
  append(command, codec_of(extension == ".mp4", options));
  append(command, words("-f framecrc pipe:1"));  // a line a packet
  bool encoded = false;
  const ChildOutcome outcome = run_child(
      command, kTrialPatience, [&](std::string_view line) { encoded = encoded || line.starts_with("0,"); },
      kTrialPatience);
  if (!outcome.found) return "ffmpeg was not found in PATH";
  if (outcome.status == 0) return encoded ? "" : "it encoded nothing";
  if (outcome.too_slow) return fmt::format("it did not answer within {:g} s", kTrialPatience);
  return outcome.errors.empty() ? "it gave no reason" : first_reason(outcome.errors);
}

}  // namespace pabd
