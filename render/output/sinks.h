// SPDX-License-Identifier: MIT
// The kinds of FrameSink, each in its own file. make_sink() checks names and options first.
#pragma once

#include <memory>
#include <string>

#include "render/output/frame_sink.h"

namespace pabd {

std::unique_ptr<FrameSink> make_png_sequence_sink(const std::string& frame_template,
                                                  const SinkOptions& options);
std::unique_ptr<FrameSink> make_last_png_sink(const std::string& path, const SinkOptions& options);
std::unique_ptr<FrameSink> make_gif_sink(const std::string& path, const SinkOptions& options);
// .mp4 and .webm. Throws Error(encoder) where ffmpeg cannot encode as asked.
std::unique_ptr<FrameSink> make_video_sink(const std::string& path, const SinkOptions& options);
// `name` is for messages. The descriptor stays open.
std::unique_ptr<FrameSink> make_raw_sink(int descriptor, const std::string& name, const SinkOptions& options);

// Throws Error(defect) if the frame is not as large as the sink was made for.
void check_frame_size(const Image& frame, const SinkOptions& options);

}  // namespace pabd
