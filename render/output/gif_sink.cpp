// SPDX-License-Identifier: MIT
// Frames as a GIF with one palette of its own, made of the colours of all frames.
//
// ffmpeg gets every frame once: it keeps them in a file without loss and counts their colours. Then it reads that
// file with the palette. One palette, and only the rectangle of a frame that changed, make a file several times
// smaller than a palette a frame; nothing needs all frames in memory.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "render/output/encoder_process.h"
#include "render/output/ffmpeg_arguments.h"
#include "render/output/sinks.h"
#include "sim/base/atomic_file.h"
#include "sim/base/child_process.h"
#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

namespace fs = std::filesystem;
constexpr double kFastest =
    50;  // frames a second: a GIF counts in 1/100 s, and viewers slow down one of them
constexpr std::size_t kBlock = 255;  // bytes of a part of a comment

constexpr char kEnd = 0x3B;

// A comment of a GIF, which stands before its last byte.
std::string comment_block(const std::string& text) {
  std::string out = "\x21\xFE";
  for (std::size_t at = 0; at < text.size(); at += kBlock) {
    const std::size_t n = std::min(kBlock, text.size() - at);
    out += static_cast<char>(n);
    out.append(text, at, n);
  }
  return out + '\0';
}

// "-loop" of ffmpeg: how often it is repeated, −1: not at all, 0: for ever.
std::string loop_argument(int plays) { return std::to_string(plays == 0 ? 0 : plays == 1 ? -1 : plays - 1); }

class GifSink : public FrameSink {
 public:
  GifSink(std::string path, const SinkOptions& options) : path_(std::move(path)), options_(options) {
    every_ = std::max(1L, static_cast<long>(std::ceil(options.fps / kFastest - 1e-9)));
    const double fps = options.fps / static_cast<double>(every_);
    file_.emplace(path_);
    // Temporary files of short names beside it.
    frames_.emplace(fs::path(path_).parent_path() / "gif-frames");
    palette_.emplace(fs::path(path_).parent_path() / "gif-palette");
    Arguments list = words("{} -progress pipe:1", kQuietFfmpeg);
    append(list, raw_input("rgb24", options.width, options.height, fps));
    append(list, words("-filter_complex [0:v]split[a][b];[b]palettegen=stats_mode=full[p] -map [a] -c:v ffv1 "
                       "-pix_fmt bgr0 -threads 4 -f matroska -y"));
    append(list, {file_argument(frames_->temporary())});
    append(list, words("-map [p] -c:v png -f image2pipe -y"));
    append(list, {file_argument(palette_->temporary())});
    encoder_.emplace(EncoderSetup{path_, frames_->temporary(), options_.encoder_timeout, std::move(list)});
  }

  void write(const Image& frame) override {
    check_frame_size(frame, options_);
    if (written_++ % every_ != 0) return;
    ++sent_;
    encoder_->write(frame.rgb.data(), frame.rgb.size());
  }

  void finish() override {
    encoder_->finish_after(sent_);
    use_palette();
    std::error_code unknown;
    if (fs::is_regular_file(file_->temporary(), unknown)) {
      check_video(path_, file_->temporary(), {options_.width, options_.height, sent_},
                  options_.encoder_timeout);
      add_comment();
    }
    file_->commit();
  }

 private:
  void use_palette() {
    Arguments command = words("ffmpeg {} -progress pipe:1 -i", kQuietFfmpeg);
    append(command, {file_argument(frames_->temporary())});
    append(command, words("-f png_pipe -i"));
    append(command, {file_argument(palette_->temporary())});
    append(
        command,
        words("-filter_complex [0:v][1:v]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle -loop {} "
              "-threads 4 -map_metadata -1 -fflags +bitexact -flags:v +bitexact -f gif -y",
              loop_argument(options_.video.plays.value_or(0))));
    append(command, {file_argument(file_->temporary())});
    const ChildOutcome outcome = run_child(command, options_.encoder_timeout, [](std::string_view) {});
    if (outcome.found && outcome.status == 0 && outcome.errors.empty()) return;
    throw Error(ErrorKind::encoder,
                fmt::format("{}: ffmpeg could not put its palette to use: {}", path_,
                            outcome.too_slow ? fmt::format("no progress for {:g} s", options_.encoder_timeout)
                            : outcome.errors.empty() ? "it gave no reason"
                                                     : one_line(without_addresses(outcome.errors))));
  }

  // Where the video came from, as text that any viewer of comments shows.
  void add_comment() {
    if (options_.about.empty()) return;
    std::string text;
    for (const auto& [key, value] : options_.about) text += key + ": " + value + "\n";
    const std::string block = comment_block(text);
    const Descriptor file(::open(file_->temporary().c_str(), O_RDWR | O_CLOEXEC));
    // The last byte of a GIF is the sign of its end.
    const off_t end = ::lseek(file.get(), -1, SEEK_END);
    char last = 0;
    const bool good = end > 0 && ::read(file.get(), &last, 1) == 1 && last == kEnd &&
                      ::lseek(file.get(), end, SEEK_SET) == end &&
                      write_all(file.get(), (block + kEnd).data(), block.size() + 1) == 0;
    if (!good)
      throw Error(ErrorKind::encoder, fmt::format("{}: could not be completed: is the disk full?", path_));
  }

  std::string path_;
  SinkOptions options_;
  long every_ = 1;  // one of so many frames is kept
  long written_ = 0;
  long sent_ = 0;
  std::optional<AtomicFile> file_, frames_, palette_;  // outlive the encoder; the last two never get a name
  std::optional<EncoderProcess> encoder_;
};

}  // namespace

std::unique_ptr<FrameSink> make_gif_sink(const std::string& path, const SinkOptions& options) {
  return std::make_unique<GifSink>(path, options);
}

}  // namespace pabd
