// SPDX-License-Identifier: MIT
// A camera that goes along with what it shows, without turning.
//
// The eyes from which a ball is inside of a rectangle of the picture are a convex set (framing.cpp has its planes), and
// for parallel rays so are eyes together with distances. A B-spline is at every time between its control points. So
// where each of these sees all that is to be seen while it counts, the camera sees it at every time. All that is
// meant as seen from a point that goes along, smoothly, with the middle of what moves: what is fast needs no wide view.
#pragma once

#include <span>
#include <vector>

#include "render/visual/framing.h"

namespace pabd {

// What is to be seen at a time.
struct TimedSpots {
  double time;  // s
  Vec3 middle;  // of what moves; m
  std::vector<Spot> spots;
};

// A uniform cubic B-spline in time, with continuous acceleration.
class EasedCamera {
 public:
  EasedCamera() = default;
  // Stands still.
  explicit EasedCamera(const Camera& camera) : controls_{camera} {}
  // Looks as `like` does. Each moment's spots are in `part` at its time, and no camera is nearer to its target than
  // `closest`; m. `moments`: in order of time, not empty.
  EasedCamera(std::span<const TimedSpots> moments, const Camera& like, double aspect, const PicturePart& part,
              double closest);

  bool is_still() const { return controls_.size() == 1; }
  // Before the first moment and after the last one it stands still.
  Camera at(double time) const;

 private:
  Vec3 middle_at(double time) const;

  double start_ = 0, spacing_ = 1;  // s
  std::vector<Vec3> middles_;       // control points of the one that goes along; empty: it stands still
  std::vector<Camera> controls_{Camera{}};  // the first of them one spacing before the start
};

}  // namespace pabd
