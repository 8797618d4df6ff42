// SPDX-License-Identifier: MIT
// See moving_video.h.
#include "app/serve/moving_video.h"

#include <turbojpeg.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "render/output/extended_image.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int even(int side) { return side + side % 2; }

}  // namespace

std::vector<std::uint8_t> to_yuv420(const Image& image) {
  const int width = even(image.width), height = even(image.height);
  Image padded;
  const Image& whole = width == image.width && height == image.height ? image : padded;
  if (&whole == &padded) padded = extended(image, width, height);
  std::vector<std::uint8_t> out(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3 / 2);
  const std::unique_ptr<void, int (*)(tjhandle)> handle(tjInitCompress(), tjDestroy);
  if (!handle || tjEncodeYUV3(handle.get(), whole.rgb.data(), width, 3 * width, height, TJPF_RGB, out.data(),
                              1, TJSAMP_420, 0) != 0)
    throw Error(ErrorKind::encoder, std::string("libjpeg-turbo: ") + tjGetErrorStr2(handle.get()));
  return out;
}

int MovingVideo::crf_of(int quality) { return static_cast<int>(std::lround(51 - 0.36 * quality)); }

void MovingVideo::restart() {
  video_.reset();
  wanted_ = false;
  row_ = 0;
}

bool MovingVideo::in_row(const Shape& shape, double now) {
  if (shape != shape_) restart();
  if (now - std::exchange(last_, now) > kBreak) row_ = 0;
  shape_ = shape;
  return ++row_ >= kRow;
}

// The first picture makes ffmpeg open its codec, which is most of what starting takes.
void MovingVideo::begin(const Image& image) {
  LiveVideoSetup setup;
  setup.width = even(image.width);
  setup.height = even(image.height);
  setup.crf = crf_of(shape_.quality);
  setup.encoder = *encoder_;
  wanted_ = true;
  starting_ = std::async(std::launch::async, [setup, yuv = to_yuv420(image)] {
    Started out;
    out.video = std::make_unique<LiveVideo>(setup);
    out.first = out.video->encode(yuv);
    return out;
  });
}

std::vector<VideoUnit> MovingVideo::go_on(const Image& image) {
  std::vector<VideoUnit> out;
  if (starting_.valid()) {
    if (starting_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return out;
    Started started = starting_.get();
    if (!wanted_) return out;
    video_ = std::move(started.video);
    out.push_back(std::move(started.first));
  }
  out.push_back(video_->encode(to_yuv420(image)));
  return out;
}

std::vector<VideoUnit> MovingVideo::encode(const Image& image, int quality, double now) {
  if (!encoder_) return {};
  const bool in_row = this->in_row({image.width, image.height, quality}, now);
  try {
    if (video_ || starting_.valid()) return go_on(image);
    if (in_row) begin(image);
  } catch (const Error& error) {
    if (!wanted_) return {};  // nobody waits for it any more
    restart();
    encoder_.reset();
    failure_ = error.what();
  }
  return {};
}

}  // namespace pabd
