// SPDX-License-Identifier: MIT
// See motion.h.
#include "app/export/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/frames/scene_framing.h"
#include "app/session/step_at_time.h"
#include "render/visual/bounds.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kFloorMargin = 2;  // of the radius of what is to be seen
constexpr double kMostFloor = 20;   // of the same at the first key: something may have left for good

}  // namespace

Quat continued(const Mat3& R, const Quat& before) {
  Quat q(R);
  q.normalize();
  const double sign = before.norm() == 0 ? q.w() : q.dot(before);
  if (sign < 0) q.coeffs() = -q.coeffs();
  return q;
}

void check_same_bodies(const Model& first, const FrameView& view) {
  if (view.model.get() == &first || view.model->name == first.name) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("bodies come or go at t = {:.6g} s: an export has the same ones throughout; end it "
                          "before with --time, or save the scene as edited and run that",
                          view.state->time));
}

Motion::Motion(std::shared_ptr<const Model> model, double fps, std::vector<TrailPoint> trails)
    : model_(std::move(model)), fps_(fps), points_(std::move(trails)), trails_(points_.size()) {
  std::size_t still = 0;
  for (const auto fixed : model_->fixed) row_.push_back(fixed ? still++ : movable_++);
  last_.assign(movable_, Quat(0, 0, 0, 0));
}

void Motion::add(std::int64_t frame, const FrameView& view) {
  check_same_bodies(*model_, view);
  const State& state = *view.state;
  const bool first = times_.empty();
  if (first) start_ = state.time;
  const double own = state.time - start_, nominal = static_cast<double>(frame) / fps_;
  const auto time = static_cast<float>(is_common_time(nominal, own, view.params.h) ? nominal : own);
  if (!first && time <= times_.back()) return;

  for (std::size_t i = 0; i < row_.size(); ++i) {
    const bool fixed = model_->fixed[i] != 0;
    if (fixed && !first) continue;
    const auto body = static_cast<Index>(i);
    Pose pose{state.c[i].cast<float>(), {0, 0, 0, 1}};
    if (!has_finite_pose(state, body) || !pose.position.allFinite()) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("body \"{}\" is nowhere at t = {:.6g} s; try a smaller time_step",
                              model_->name[i], state.time));
    }
    const Quat q = continued(state.R[i], fixed ? Quat(0, 0, 0, 0) : last_[row_[i]]);
    if (!fixed) last_[row_[i]] = q;
    pose.orientation = q.coeffs().cast<float>();
    (fixed ? still_ : poses_).push_back(pose);
  }
  times_.push_back(time);
  TrailRecorder here(points_, kTrailTime);
  here.add(*model_, state);
  const std::vector<Trail> places = here.trails();
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vec3f place = places[k].path.front().cast<float>();
    if (place.allFinite()) trails_[k].push_back(place);
  }
  const auto seen = bounding_sphere(*model_, state);
  const Vec3 centre = seen ? seen->centre : Vec3(Vec3::Zero());
  const double radius = kFloorMargin * (seen ? seen->radius : 5);
  const Vec3 around = Vec3::Constant(radius);
  lo_ = first ? Vec3(centre - around) : Vec3(lo_.cwiseMin(centre - around));
  hi_ = first ? Vec3(centre + around) : Vec3(hi_.cwiseMax(centre + around));
  if (first) first_reach_ = radius;
}

const Motion::Pose& Motion::pose(std::size_t i, std::size_t k) const {
  return model_->fixed[i] ? still_[row_[i]] : poses_[k * movable_ + row_[i]];
}

Vec3f Motion::position(std::size_t i, std::size_t k) const { return pose(i, k).position; }
Vec4f Motion::orientation(std::size_t i, std::size_t k) const { return pose(i, k).orientation; }

bool Motion::moves(std::size_t i) const {
  if (model_->fixed[i]) return false;
  for (std::size_t k = 1; k < keys(); ++k)
    if (position(i, k) != position(i, 0)) return true;
  return false;
}

bool Motion::turns(std::size_t i) const {
  if (model_->fixed[i]) return false;
  for (std::size_t k = 1; k < keys(); ++k)
    if (orientation(i, k) != orientation(i, 0)) return true;
  return false;
}

Vec3 Motion::middle() const { return keys() == 0 ? Vec3(Vec3::Zero()) : Vec3(0.5 * (lo_ + hi_)); }

double Motion::reach() const {
  if (keys() == 0) return 0;
  return std::min(0.5 * (hi_ - lo_).maxCoeff(), kMostFloor * first_reach_);
}

AnimationExporter::AnimationExporter(const Scene& scene, const FrameView& start, const ExportSetup& setup)
    : name_(scene.name),
      hash_(scene.hash),
      model_(start.model),
      bodies_(mesh_bodies(*start.model, looks_of(scene, *start.model), setup.segments)),
      motion_(start.model, setup.fps, setup.trails) {}

}  // namespace pabd
