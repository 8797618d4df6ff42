// SPDX-License-Identifier: MIT
// See device_picture.h.
#include "app/gui/device_picture.h"

#include "app/frames/scene_framing.h"
#include "render/device/device_bodies.h"
#include "render/device/device_sphere.h"
#include "render/device/pose_copies.h"
#include "render/visual/body_parts.h"
#include "sim/base/error.h"

namespace pabd {

struct DevicePicture::Impl {
  explicit Impl(GlContext& c) : context(c) {}

  void begin(const RunView& run, GLuint poses);
  bool all_opaque(const RunView& run);

  GlContext& context;
  std::optional<ComputeFunctions> gl;
  std::string failure;
  std::shared_ptr<const Model> model;  // of these
  std::optional<DeviceBodies> bodies;
  std::optional<DeviceSphere> sphere;
  std::shared_ptr<const Model> looked_at;
  bool opaque = false;  // its bodies are
};

bool DevicePicture::Impl::all_opaque(const RunView& run) {
  if (looked_at != run.model) {
    looked_at = run.model;
    opaque = pabd::all_opaque(looks_of(*run.scene, *run.model));
  }
  return opaque;
}

// Bodies that do not move are where the scene has them at its start.
void DevicePicture::Impl::begin(const RunView& run, GLuint poses) {
  if (model == run.model) {
    bodies->draw_from(poses);
    sphere->look_at(poses);
    return;
  }
  model.reset();
  sphere.reset();
  bodies.reset();
  VisualOptions options;
  options.looks = looks_of(*run.scene, *run.model);
  const BodyParts parts = body_parts(*run.model, options);
  bodies.emplace(context, parts, poses);
  sphere.emplace(context, *run.model, run.scene->initial, parts, poses);
  model = run.model;
}

DevicePicture::DevicePicture(GlContext& context) : impl_(std::make_unique<Impl>(context)) {}
DevicePicture::~DevicePicture() = default;

bool DevicePicture::can_draw(const RunView& run) const {
  // Of an edited model the scene does not know where fixed bodies are.
  return impl_->failure.empty() && run.model.get() == &run.scene->model && impl_->all_opaque(run);
}

bool DevicePicture::draw(const RunView& run, VisualScene& visual, int width, int height,
                         const RenderQuality& quality, Renderer& renderer) {
  const auto* poses = dynamic_cast<const GlPoses*>(run.poses.get());
  try {
    if (poses == nullptr) throw Error(ErrorKind::no_context, "another device");
    if (!impl_->gl) impl_->gl.emplace(impl_->context);
    impl_->begin(run, poses->begin(*impl_->gl));
    show_on_device(*run.model, (*impl_->sphere)(), visual);
    renderer.draw_view(0, visual, width, height, quality, &*impl_->bodies);
    poses->end(*impl_->gl);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_context) throw;
    impl_->failure = error.what();
  }
  return impl_->failure.empty();
}

const std::string& DevicePicture::failure() const { return impl_->failure; }

}  // namespace pabd
