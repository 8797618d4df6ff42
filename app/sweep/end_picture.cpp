// SPDX-License-Identifier: MIT
// See end_picture.h.
#include "app/sweep/end_picture.h"

#include "app/frames/scene_framing.h"
#include "app/frames/thumbnail.h"
#include "render/output/png.h"
#include "sim/base/error.h"

namespace pabd {

bool EndPainter::ready() {
  if (renderer_ || !why_.empty()) return why_.empty();
  try {
    std::vector<ContextAttempt> attempts;
    context_ = create_headless_context(Backend::automatic, attempts);
    renderer_ = std::make_unique<Renderer>(*context_, 2 * kWidth, 2 * kHeight);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    why_ = error.what();
  }
  return why_.empty();
}

std::vector<std::uint8_t> EndPainter::draw(const TaskResult& result, const std::string& hash) {
  if (!ready()) return {};
  const Camera camera = scene_camera(*result.scene, result.end, static_cast<double>(kWidth) / kHeight);
  const Image image = draw_small(*renderer_, *result.scene, result.end, camera, kWidth, kHeight);
  return encode_png(image,
                    {{"Software", "pabd " PABD_VERSION}, {"Sweep task", hash}, {"Status", result.status}});
}

}  // namespace pabd
