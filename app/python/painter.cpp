// SPDX-License-Identifier: MIT
// See painter.h.
#include "app/python/painter.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "app/session/session.h"
#include "sim/base/error.h"

namespace pabd::python {
namespace {

RenderQuality quality_of(const std::string& word) {
  if (word == "draft") return RenderQuality::live();
  if (word == "good") return {};
  if (word == "best") return {Quality::best, 0.1f};
  throw Error(ErrorKind::bad_input, fmt::format("quality {}: expected draft, good or best", word));
}

}  // namespace

void check_size(int width, int height) {
  constexpr int kLeastSide = 16, kMostSide = 16384;
  for (const int side : {width, height})
    if (side < kLeastSide || side > kMostSide)
      throw Error(ErrorKind::bad_input, fmt::format("size {}x{}: expected {} to {} pixels a side", width,
                                                    height, kLeastSide, kMostSide));
}

Painter::Painter(const std::shared_ptr<const Scene>& scene, const PictureOptions& options)
    : options_(options), overlay_(parse_overlay(options.overlay)) {
  check_size(options.width, options.height);
  overlay_.theme = &find_theme(options.theme);
  const CameraOption camera = parse_camera(options.camera);
  const RenderQuality quality = quality_of(options.quality);
  std::vector<ContextAttempt> attempts;
  context_ = create_headless_context(Backend::automatic, attempts);
  const CurrentContext current(*context_);
  // Cameras that go along with a body, or round the scene, begin where the scene does, whenever a picture is taken.
  const Frame start = make_frame(0, {Session(scene).view()});
  auto painter = std::make_unique<RunsPainter>(*context_, std::vector{scene}, start, Arrangement{},
                                               options.width, options.height, overlay_, camera);
  painter->set_quality(quality);
  painter_ = std::move(painter);
}

Painter::~Painter() {
  try {
    if (painter_) context_->make_current();
  } catch (const Error&) {  // nobody waits for what it holds
  }
  painter_.reset();
}

Image Painter::draw(FrameView view) {
  const CurrentContext current(*context_);
  painter_->draw(make_frame(0, {std::move(view)}));
  Image image;
  painter_->fetch(image);
  return image;
}

}  // namespace pabd::python
