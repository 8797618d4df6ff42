// SPDX-License-Identifier: MIT
// Draws small pictures of everything that there is, of which nothing is seen, while nobody does anything: a driver compiles
// a program when something is first drawn with it, software GL for up to a second each, in which the window stood still.
#pragma once

#include <cstddef>

#include "render/gl/renderer.h"

namespace pabd {

class WarmUp {
 public:
  bool done() const { return next_ == kPictures; }
  // One picture.
  void draw(Renderer& renderer);

 private:
  static constexpr std::size_t kPictures = 10;  // five kinds of things, as they move and at rest
  std::size_t next_ = 0;
};

}  // namespace pabd
