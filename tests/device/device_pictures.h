// SPDX-License-Identifier: MIT
// Pictures from the GPU's buffers beside those of the processor.
#pragma once

#include <vector>

#include "render/device/compute_functions.h"
#include "render/gl/device_instances.h"
#include "render/gl/gl_objects.h"
#include "render/gl/renderer.h"
#include "render/output/compare_images.h"
#include "render/visual/build_visual.h"

namespace pabd::testing {

Image picture(Renderer& renderer, const VisualScene& scene, const RenderQuality& quality,
              DeviceInstances* device);

// What the processor draws of a state, and the same without its bodies.
struct Twin {
  VisualScene all, bare;

  Twin(const Model& model, const State& state, const VisualOptions& options, const Camera& camera,
       const StepReport& report = {});
};

// Poses on the GPU without a solver.
class PoseBuffer {
 public:
  PoseBuffer(const ComputeFunctions& gl, const State& state) : gl_(gl), buffer_(gl) { set(state); }
  void set(const State& state);
  unsigned id() const { return buffer_.id(); }

 private:
  const ComputeFunctions& gl_;
  GlBuffer buffer_;
};

// Poses differ by a rounding of float, which may move an edge across a sample: software GL, which counts as one class
// with itself, samples the same all the same; of a GPU some pixels in ten thousand may be others.
bool same_but_edges(GlContext& context, const CompareResult& result);

}  // namespace pabd::testing
