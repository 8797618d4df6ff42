// SPDX-License-Identifier: MIT
// Bodies that are drawn from where the solver on the GPU leaves their poses: compute shaders make what
// render/gl/draw_list.h makes on the processor, and nothing of it is read back but what the casters span, late.
#pragma once

#include <memory>

#include "render/context/context.h"
#include "render/device/device_marks.h"
#include "render/gl/device_instances.h"

namespace pabd {

struct BodyParts;   // render/visual/body_parts.h
struct ValueRange;  // render/visual/value_map.h

struct DeviceBodiesOptions {
  // The maps of light fit the bodies as they were up to three frames before, so that nobody waits for the GPU. False:
  // they are those of this very frame, and the picture is that of the processor.
  bool late_bounds = true;
};

// Opaque bodies of a model. Where scene and camera are the same, the picture is the one that build_visual() leads to,
// but for the last bits of places. Order: none; bodies out of sight are not drawn.
class DeviceBodies : public DeviceInstances {
 public:
  // `poses`: GL name of a buffer with a pose a body (DeviceSolver::pose_buffer()), which outlives its use here, and is
  // written in the same context or before (pose_copies.h); the context is current in all calls. Throws Error(no_context) where the context lacks compute
  // shaders, a buffer is larger than it allows, or there are more hulls than it can tell apart.
  DeviceBodies(GlContext& context, const BodyParts& bodies, unsigned poses,
               const DeviceBodiesOptions& options = {});
  ~DeviceBodies() override;

  std::span<const InstanceClass> classes() const override;
  const std::vector<std::shared_ptr<const MeshData>>& meshes() const override;
  CasterBounds bounds(const VisualScene& scene) override;
  void make(const InstanceFrame& frame, std::span<const MeshRange> meshes) override;
  const DeviceBatches& batches(DeviceList list) const override;
  void reveal(DeviceList list, const DepthPicture& depth) override;
  const DeviceBatches& revealed(DeviceList list) const override;

  // From now on another buffer of poses.
  void draw_from(unsigned poses);

  // From now on: colours by a float a body (DeviceSolver::value_buffer()), as VisualOptions::values has them; -infinity
  // keeps the body's own colour. `values`: GL name of a buffer that outlives its use here; 0: all have their own again.
  void color_by(unsigned values, const ValueRange& range);
  // The largest of such values that is a number, 0 where none is above; waits for the GPU.
  float largest(unsigned values);

  // From now on, until `contacts` has none: glyphs of the contacts that the step before tells, as VisualOptions::contacts
  // has them. Those that bodies hide show through in the order of contacts, not of depth. To be called in each frame, as
  // buffers of a step may be replaced; none in a frame whose step is made again with larger ones. `model`: of the bodies.
  void mark_contacts(const Model& model, const DeviceContacts& contacts, const ContactMarks& marks);

  std::size_t bytes() const;  // of all buffers, without the poses

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
