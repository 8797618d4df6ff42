// SPDX-License-Identifier: MIT
// A renderer on the first context of this machine, and ways to look at what it drew.
#pragma once

#include <string>

#include "render/gl/renderer.h"
#include "render/visual/visual_scene.h"

namespace pabd {

struct Rgb {
  int r, g, b;
};

inline Rgb pixel(const Image& image, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

double to_linear(int srgb_byte);     // 0 … 255 to 0 … 1
double to_srgb_byte(double linear);  // 0 … 1 to 0 … 255, not rounded

// One frame, read back at once.
Image render(Renderer& renderer, const VisualScene& scene, const ImDrawData* overlay = nullptr,
             Quality quality = Quality::good);

// A context and a renderer on it.
struct RenderFixture {
  RenderFixture(int width, int height);
  std::unique_ptr<GlContext> context;
  Renderer renderer;
};

// Writes NAME.png to the folder in PABD_KEEP_IMAGES, if that is set.
void keep_image(const std::string& name, const Image& image);

// A camera on the z axis that looks at the origin from `distance`.
Camera front_camera(float distance);

Instance flat_instance(const Vec3f& at, const Vec3f& half_size, const Vec4f& color);

}  // namespace pabd
