// SPDX-License-Identifier: MIT
// A heap of every shape.
#pragma once

#include "tests/collision/reference.h"

namespace reference {

// A heap of every shape over two planes, some bodies fixed.
inline Setup heap(int bodies, unsigned seed) {
  Random random(seed);
  Setup setup;
  for (int i = 0; i < bodies; ++i) {
    if (i == bodies / 2) setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
    if (i == bodies / 3) setup.add(Plane{Vec3(0.6, 0.8, 0), -1}, Vec3::Zero());
    const double size = random.uniform(0.2, 0.6);
    const Shape shape = i % 3 == 0   ? Shape(Box{{size, 0.4, 0.5}})
                        : i % 3 == 1 ? Shape(Sphere{size})
                                     : Shape(Capsule{0.3, size});
    const Vec3 where = random.within(-1.5, 1.5).cwiseProduct(Vec3(2, 1, 2)) + Vec3(0, 1.5, 0);
    const Mat3 R = random.rotation();
    setup.add(shape, where, R, random.uniform(0, 0.05), i % 11 == 0);
  }
  return setup;
}

}  // namespace reference
