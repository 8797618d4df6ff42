// SPDX-License-Identifier: MIT
// Curves made of lines.
#pragma once

#include "render/visual/visual_scene.h"
#include "sim/math/types.h"

namespace pabd {

struct Pen {
  Vec4f color;
  double width;        // pixels at 720 px frame height
  bool on_top = true;  // not hidden by bodies
};

// Where things are in the frame.
class PixelMeter {
 public:
  explicit PixelMeter(const Camera& camera);
  // Metres that a pixel spans at p, in a frame 720 px high. Behind the eye: as near to it.
  double at(const Vec3& p) const;
  double distance(const Vec3& p) const { return (eye_ - p).norm(); }
  // Unit vector from p to the eye.
  Vec3 to_eye(const Vec3& p) const;
  const Vec3& eye() const { return eye_; }  // where rays come from
  const Vec3& forward() const { return forward_; }
  bool parallel() const { return orthographic_; }
  double slope() const { return slope_; }  // m a pixel, at a distance of 1 m unless rays are parallel

 private:
  Vec3 eye_, forward_;
  bool orthographic_;
  double slope_;  // tangent of a pixel's angle; of an orthographic camera its size in m
};

// Where rays come from; for parallel ones a point very far away.
Vec3 eye_of(const Camera& camera);

void add_line(VisualScene& out, const Vec3& a, const Vec3& b, const Pen& pen);

// The points c + radius (cos t u + sin t w) for t between `from` and `to` (rad); u and w unit, across each
// other. At most one turn is drawn.
void add_arc(VisualScene& out, const Vec3& c, const Vec3& u, const Vec3& w, double radius, double from,
             double to, const Pen& pen);

// A coil of `turns` turns from a to b, with straight ends. `flat`: a zig-zag across the unit vector `side`.
// Nothing when the points meet.
void add_coil(VisualScene& out, const Vec3& a, const Vec3& b, double radius, int turns, bool flat,
              const Vec3& side, const Pen& pen);

}  // namespace pabd
