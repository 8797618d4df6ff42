// SPDX-License-Identifier: MIT
// What a ray meets first, of bodies whose poses lie on the GPU. It finds those whose bounding balls the ray meets; only
// their poses are read back, some hundred bytes each, and the processor's ray cast decides between them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "render/context/context.h"
#include "sim/body/model.h"
#include "sim/collision/ray_cast.h"

namespace pabd {

class DevicePick {
 public:
  // `poses`: as for DeviceBodies, of the bodies of `model`, which both outlive this; the context is current in all
  // calls. Throws Error(no_context).
  DevicePick(GlContext& context, const Model& model, unsigned poses);
  ~DevicePick();

  // ray_cast() with the poses as the commands before leave them, to the bit. Waits for the GPU.
  std::optional<RayHit> operator()(const Ray& ray);

  std::size_t bytes_read() const;  // of the last ray

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
