// SPDX-License-Identifier: MIT
// How bodies move, as keys of an animation.
//
// A step of the method passes through affine bodies [c A] and ends with each projected on a rigid one (sim/README.md),
// so that every key is exactly a translation c and a rotation R: A has no stretch or shear left that a key would lose.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/export/body_mesh.h"
#include "app/export/exporter.h"
#include "app/session/frame_view.h"
#include "app/session/trails.h"
#include "render/visual/visual_scene.h"

namespace pabd {

// Unit, R to quaternion; of the two that are the same rotation the one that is nearer to `before`, so that between
// keys a body turns the short way. `before` zero: the one with w ≥ 0.
Quat continued(const Mat3& R, const Quat& before);

// Throws Error(bad_input) when the frame has other bodies than `first`.
void check_same_bodies(const Model& first, const FrameView& view);

class Motion {
 public:
  Motion(std::shared_ptr<const Model> model, double fps, std::vector<TrailPoint> trails);

  // A key at frame / fps, or where no state ends there at the time of the state; times count from the first key. A state
  // that the last key has already adds none. Throws Error(bad_input) for other bodies, or places beyond float.
  void add(std::int64_t frame, const FrameView& view);

  std::size_t keys() const { return times_.size(); }
  const std::vector<float>& times() const { return times_; }  // s
  // Of body i at key k. What is fixed has the pose of the first key.
  Vec3f position(std::size_t i, std::size_t k) const;     // m, world
  Vec4f orientation(std::size_t i, std::size_t k) const;  // x, y, z, w
  // Whether any key differs from the first.
  bool moves(std::size_t i) const;
  bool turns(std::size_t i) const;

  // A square of the floor that is beneath all that was to be seen at any key: middle and half its edge, m.
  Vec3 middle() const;
  double reach() const;

  const std::vector<TrailPoint>& trail_points() const { return points_; }
  // Of each of these where it was at every key; m, world. Empty where that is no number (the centre of nothing).
  const std::vector<std::vector<Vec3f>>& trails() const { return trails_; }

 private:
  struct Pose {
    Vec3f position;
    Vec4f orientation;
  };
  const Pose& pose(std::size_t i, std::size_t k) const;

  std::shared_ptr<const Model> model_;
  double fps_;
  double start_ = 0;
  std::vector<TrailPoint> points_;
  std::vector<std::vector<Vec3f>> trails_;
  std::vector<std::size_t> row_;  // of body i in a key, of the fixed ones in still_
  std::size_t movable_ = 0;
  std::vector<Pose> still_, poses_;  // poses_: key by key
  std::vector<float> times_;
  std::vector<Quat> last_;
  Vec3 lo_, hi_;
  double first_reach_ = 0;
};

// What exporters of an animation keep of a run.
class AnimationExporter : public Exporter {
 public:
  AnimationExporter(const Scene& scene, const FrameView& start, const ExportSetup& setup);
  void add(std::int64_t frame, const FrameView& view) override { motion_.add(frame, view); }

 protected:
  std::string name_, hash_;  // of the scene
  std::shared_ptr<const Model> model_;
  MeshedBodies bodies_;
  Motion motion_;
};

}  // namespace pabd
