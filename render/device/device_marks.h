// SPDX-License-Identifier: MIT
// Contacts as glyphs that the GPU makes of what its solver tells, without reading it back: those of
// render/visual/contact_glyphs.h. DeviceBodies draws them with its bodies.
#pragma once

#include <memory>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/gl/device_instances.h"
#include "sim/body/model.h"

namespace pabd {

struct DeviceContacts;  // device_solver.h

// What glyphs are made with.
struct ContactMarks {
  double d_hat = 0;   // for the colours; m
  double scale = 0;   // radius of a disc, m; 0: from the size of the bodies
  double weight = 0;  // of a typical body, that arrows are measured against, N; 0: that of the model's
};

class DeviceMarks {
 public:
  // `view`: GL name of the record of what is seen (shaders/device_draw_view.glsl). Throws Error(no_context).
  DeviceMarks(const ComputeFunctions& gl, const Model& model, unsigned view);
  ~DeviceMarks();

  // What glyphs are made of: discs, cylinders and cones at each level of detail.
  static std::vector<InstanceClass> classes();

  // From now on.
  void set(const DeviceContacts& contacts, const ContactMarks& marks);
  // Makes the instances and the commands. `meshes`: of each class. Waits for the GPU to count them.
  void make(const VisualScene& scene, std::span<const MeshRange> meshes);
  const DeviceBatches& batches() const;
  std::size_t bytes() const;  // of all buffers of its own

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
