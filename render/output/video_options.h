// SPDX-License-Identifier: MIT
// How a video is encoded: what 'pabd render' lets one choose, and what ffmpeg is told.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pabd {

enum class VideoEncoder { software, nvenc };

struct VideoOptions {
  std::optional<int> crf;    // smaller is better and larger: .mp4 0 … 51 (18), .webm 0 … 63 (24)
  std::string preset;        // one of preset_names(); empty: "veryfast" for .mp4, "fast" for .webm
  std::optional<int> plays;  // of a .gif, 0: for ever; 0 … 65535 (0)
  VideoEncoder encoder = VideoEncoder::software;

  bool operator==(const VideoOptions&) const = default;
};

// What ".mp4" (else: ".webm") has where nothing is said, and the largest crf.
struct VideoDefaults {
  int crf, most_crf;
  const char* preset;
};
VideoDefaults video_defaults(const std::string& extension);

// From the fastest, with the largest files, to the slowest.
const std::vector<std::string>& preset_names();
// "software", "nvenc". Throws Error(bad_input) for another word.
VideoEncoder parse_video_encoder(const std::string& word);

// Throws Error(bad_input) that begins with the option for what does not fit the kind of output: `extension` is
// ".mp4", ".webm", ".gif", or anything else for one that is no video.
void check_video_options(const std::string& extension, const VideoOptions& options);

// Whether ffmpeg can encode so on this machine, by trying it with one frame. Throws Error(encoder) with ffmpeg's
// words and the remedy. Nothing is tried for VideoEncoder::software.
void check_video_encoder(const VideoOptions& options);

// What ffmpeg is told between its input and its output, for ".mp4" and ".webm"; `fps` in 1/s.
std::vector<std::string> video_arguments(const std::string& extension, double fps,
                                         const VideoOptions& options);

// What is against encoding an ".mp4" (else: a ".webm") so on this machine, in one line; empty: a frame could be encoded so.
std::string encoder_complaint(const std::string& extension, const VideoOptions& options);

}  // namespace pabd
