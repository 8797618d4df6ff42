// SPDX-License-Identifier: MIT
// Helpers of the picture tests.
#include "tests/gl/render_fixture.h"
#include "sim/base/srgb.h"

#include <cmath>
#include <cstdlib>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace pabd {
namespace {

std::unique_ptr<GlContext> first_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

}  // namespace

double to_linear(int srgb_byte) { return linear_from_srgb(srgb_byte / 255.0); }

double to_srgb_byte(double linear) { return 255 * srgb_from_linear(linear); }

Image render(Renderer& renderer, const VisualScene& scene, const ImDrawData* overlay, Quality quality) {
  Image image;
  renderer.draw(scene, overlay, {quality});
  renderer.queue_read();
  renderer.fetch(image);
  return image;
}

RenderFixture::RenderFixture(int width, int height)
    : context(first_context()), renderer(*context, width, height) {}

void keep_image(const std::string& name, const Image& image) {
  const char* folder = std::getenv("PABD_KEEP_IMAGES");
  if (folder == nullptr) return;
  const std::string path = std::string(folder) + "/" + name + ".png";
  stbi_write_png(path.c_str(), image.width, image.height, 3, image.rgb.data(), image.width * 3);
}

Camera front_camera(float distance) {
  Camera camera;
  camera.eye = {0, 0, distance};
  camera.target = {0, 0, 0};
  camera.fov = 45;
  return camera;
}

Instance flat_instance(const Vec3f& at, const Vec3f& half_size, const Vec4f& color) {
  Instance instance{Mat4f::Identity(), color, false, false, false};
  instance.transform.block<3, 1>(0, 3) = at;
  instance.transform.diagonal().head<3>() = half_size;
  return instance;
}

}  // namespace pabd
