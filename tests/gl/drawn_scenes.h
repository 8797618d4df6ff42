// SPDX-License-Identifier: MIT
// Scenes put together by hand, for tests and for looking at.
#pragma once

#include "render/visual/build_visual.h"
#include "tests/support/tiny_model.h"

namespace pabd {

// A pyramid of bricks, `base` in the lowest row, on a floor; with the contacts that it would rest on.
struct BrickPyramid {
  TinyModel tiny;
  StepReport report;

  explicit BrickPyramid(int base, double d_hat = 0.01) {
    tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
    const Vec3 half(0.5, 0.25, 0.25);
    const double gap = 0.95 * d_hat;
    std::vector<Index> below(static_cast<std::size_t>(base) + 1, 0);
    for (int row = 0; row < base; ++row) {
      std::vector<Index> above;
      const double y = half.y() + gap + row * (2 * half.y() + gap);
      for (int i = 0; i < base - row; ++i) {
        const Vec3 c((i - 0.5 * (base - row - 1)) * 1.06, y, 0);
        const Index brick = tiny.add(Box{half}, c);
        above.push_back(brick);
        add_contacts(row == 0 ? 0 : below[static_cast<std::size_t>(i)], brick, c, half, gap, base - row,
                     d_hat);
      }
      below = above;
    }
  }

 private:
  void add_contacts(Index a, Index b, const Vec3& c, const Vec3& half, double gap, int load, double d_hat) {
    int corner = 0;
    for (const double sx : {-1.0, 1.0}) {
      for (const double sz : {-1.0, 1.0}) {
        const Vec3 y_b = c + Vec3(sx * half.x(), -half.y(), sz * half.z());
        // Spread over the colour map: from pressed to barely touching.
        const double d = d_hat * (0.05 + 0.9 * ((load * 7 + corner * 3 + static_cast<int>(b)) % 10) / 10.0);
        report.contact_reports.push_back({a, b, y_b - Vec3(0, gap, 0), y_b, Vec3(0, 1, 0), d,
                                          600.0 * (1 + corner), Vec3::Zero(), true, 0});
        ++corner;
      }
    }
  }
};

// Boxes, spheres and capsules in all positions, on a floor and each clear of the next.
inline TinyModel mixed_bodies(int side) {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  int k = 0;
  for (int layer = 0; layer < side; ++layer) {
    for (int i = 0; i < side - layer; ++i) {
      for (int j = 0; j < side - layer; ++j, ++k) {
        const Vec3 c(i - 0.5 * (side - layer - 1), 0.45 + 0.8 * layer, j - 0.5 * (side - layer - 1));
        const Mat3 R = Eigen::AngleAxisd(0.7 * k, Vec3(1, 0.3 * k, 0.5).normalized()).toRotationMatrix();
        if (k % 3 == 0) tiny.add(Box{{0.3, 0.25, 0.22}}, c, R);
        if (k % 3 == 1) tiny.add(Sphere{0.42}, c, R);
        if (k % 3 == 2) tiny.add(Capsule{0.2, 0.45}, c, R);
      }
    }
  }
  return tiny;
}

}  // namespace pabd
