// SPDX-License-Identifier: MIT
// See device_pictures.h.
#include "tests/device/device_pictures.h"

#include "render/device/device_layout.h"
#include "render/visual/body_parts.h"

namespace pabd::testing {

Image picture(Renderer& renderer, const VisualScene& scene, const RenderQuality& quality,
              DeviceInstances* device) {
  Image image;
  renderer.draw(scene, nullptr, quality, device);
  renderer.queue_read();
  renderer.fetch(image);
  return image;
}

Twin::Twin(const Model& model, const State& state, const VisualOptions& options, const Camera& camera,
           const StepReport& report) {
  all.camera = camera;
  build_visual(model, state, report, options, all);
  add_grounds(model, bare);
  bare.camera = camera;
  bare.centre = all.centre;
  bare.radius = all.radius;
}

void PoseBuffer::set(const State& state) {
  std::vector<device::Pose> poses;
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    const Vec3& c = state.c[i];
    const Quat q(state.R[i]);
    poses.push_back({{c.x(), c.y(), c.z(), 0}, {q.x(), q.y(), q.z(), q.w()}});
  }
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.id());
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(poses.size() * sizeof(poses[0])),
                 poses.data(), GL_STATIC_DRAW);
}

bool same_but_edges(GlContext& context, const CompareResult& result) {
  const bool is_software =
      compute_limits(ComputeFunctions(context)).renderer.find("llvmpipe") != std::string::npos;
  return result.equal || (!is_software && result.differing < 2e-4);
}

}  // namespace pabd::testing
