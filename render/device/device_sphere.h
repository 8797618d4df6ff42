// SPDX-License-Identifier: MIT
// The sphere around what is to be seen (render/visual/bounds.h), of bodies whose poses lie on the GPU: what depth range,
// shadows and floor are fitted to.
#pragma once

#include <memory>
#include <optional>

#include "render/context/context.h"
#include "render/visual/bounds.h"

namespace pabd {

struct BodyParts;  // render/visual/body_parts.h

class DeviceSphere {
 public:
  // `start`: where fixed bodies stand. `bodies`: of all bodies of the model. `poses`: as DeviceBodies has them. The
  // context is current in all calls. Throws Error(no_context) as DeviceBodies does.
  DeviceSphere(GlContext& context, const Model& model, const State& start, const BodyParts& bodies,
               unsigned poses);
  ~DeviceSphere();

  // From now on another buffer of poses.
  void look_at(unsigned poses);

  // bounding_sphere() of the poses as they are, to the rounding of float. Waits for the GPU, twice or three times.
  std::optional<BoundingSphere> operator()();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
