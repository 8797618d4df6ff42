// SPDX-License-Identifier: MIT
// See going_along.h.
#include "app/gui/going_along.h"

#include <algorithm>
#include <cmath>

#include "app/frames/outlook.h"
#include "app/gui/scene_view.h"
#include "render/visual/framing.h"

namespace pabd {
namespace {

constexpr double kOmega = 6, kNu = 3;  // ω, ν; 1/s
constexpr double kLead = 0.35,
                 kSoon = 0.05;  // s of its way: that is seen of what moves, and that is all but there
constexpr int kHalvings = 16;
constexpr double kPiece = 0.01;         // s of easing at once
constexpr double kJump = 0.5;           // s: more between two frames is no motion that is seen
constexpr double kInside = 0.97;        // of the picture, in which everything stays
constexpr double kSmall = 18.0 / 720;   // of its height: a body that is smaller is too small where
constexpr double kNearer = 1.5;         // the camera could be this much nearer
constexpr double kClose = 0.06;         // of half the height: no body need be larger
constexpr Index kMostFollowed = 20000;  // of more a frame would take too long

double slope_of(const CameraPose& pose, const Viewport& port) {
  return std::tan(0.5 * pose.fov * kPi / 180) * std::min(1.0, port.width / port.height);
}

// Half the width of what is seen around the spot, in the direction in which the picture is narrow.
double half_seen(const CameraPose& pose, const Viewport& port, const Vec3& at) {
  const double depth = pose.orthographic ? pose.distance() : axes_of(pose).back.dot(pose.eye - at);
  return depth * slope_of(pose, port);
}

bool all_inside(const CameraPose& pose, const Viewport& port, const std::vector<Spot>& spots) {
  for (const Spot& spot : spots) {
    const double half = half_seen(pose, port, spot.centre);
    if (!(half > spot.radius)) return false;
    const PixelPoint at = to_pixel(pose, port, spot.centre);
    const double radius = spot.radius / half * 0.5 * std::min(port.width, port.height);
    const double across = kInside * 0.5 * port.width - radius, up = kInside * 0.5 * port.height - radius;
    if (std::abs(at.x - 0.5 * port.width) > across || std::abs(at.y - 0.5 * port.height) > up) return false;
  }
  return true;
}

double distance_of(const Camera& camera) { return precise(camera).distance(); }

// The camera with its eye that far from the target along the line of sight.
CameraPose at_distance(CameraPose pose, double distance) {
  const Vec3 back = axes_of(pose).back;
  pose.target = pose.eye - distance * back;
  return pose;
}

}  // namespace

void GoingAlong::begin(const Snapshot& sim) {
  model_ = sim.a.model;
  around_ = bounding_sphere(*model_, *sim.a.state);
  active_ = false;
}

// The hulls of bodies that matter, and where they go; middle and velocity.
std::vector<Spot> GoingAlong::what_moves(const RunView& run) {
  const Model& model = *run.model;
  const State& state = *run.state;
  std::vector<Spot> spots;
  now_.clear();
  soon_.clear();
  if (!around_ || model.size() > kMostFollowed) return spots;
  std::vector<double> way(state.c.size(), 0), radii;
  for (std::size_t i = 0; i < way.size(); ++i)
    way[i] = std::max(0.0, (state.c[i] - around_->centre).norm() - around_->radius);
  const auto matters =
      who_matters(model, *around_, way, state, bodies_in_picture(model, state), run.params.gravity);
  middle_ = velocity_ = Vec3::Zero();
  for (std::size_t i = 0; i < matters.size(); ++i) {
    if (!matters[i]) continue;
    radii.push_back(bounding_radius(model.shape[i]));
    middle_ += state.c[i];
    velocity_ += state.v[i];
    add_spots(model.shape[i], {state.c[i], state.R[i]}, now_);
    add_spots(model.shape[i], {state.c[i] + kSoon * state.v[i], state.R[i]}, soon_);
    add_spots(model.shape[i], {state.c[i] + kLead * state.v[i], state.R[i]}, spots);
  }
  spots.insert(spots.end(), now_.begin(), now_.end());
  if (radii.empty()) return spots;
  middle_ /= static_cast<double>(radii.size());
  velocity_ /= static_cast<double>(radii.size());
  std::nth_element(radii.begin(), radii.begin() + std::ssize(radii) / 2, radii.end());
  body_ = radii[radii.size() / 2];
  return spots;
}

void GoingAlong::start(const UiState& ui) {
  active_ = true;
  follower_ = middle_;
  follower_speed_ = velocity_;
  offset_ = ui.camera.eye - middle_;
  offset_speed_ = -velocity_;
  log_distance_ = std::log(ui.camera.distance());
  log_speed_ = 0;
}

void GoingAlong::ease(double seconds, const Camera& goal) {
  const Vec3 wanted = precise(goal).eye - middle_;
  const double wanted_distance = std::log(distance_of(goal));
  const Vec3 before = middle_ - seconds * velocity_;
  const int pieces = std::max(1, static_cast<int>(std::ceil(seconds / kPiece)));
  const double h = seconds / pieces;
  for (int k = 1; k <= pieces; ++k) {
    const Vec3 middle = before + k * h * velocity_;
    follower_speed_ +=
        h * (kOmega * kOmega * (middle - follower_) + 2 * kOmega * (velocity_ - follower_speed_));
    follower_ += h * follower_speed_;
    offset_speed_ += h * (kNu * kNu * (wanted - offset_) - 2 * kNu * offset_speed_);
    offset_ += h * offset_speed_;
    log_speed_ += h * (kNu * kNu * (wanted_distance - log_distance_) - 2 * kNu * log_speed_);
    log_distance_ += h * log_speed_;
  }
}

CameraPose GoingAlong::eased(const CameraPose& like, double distance) const {
  CameraPose out = like;
  out.eye = follower_ + offset_;
  out.target = out.eye - (like.eye - like.target);
  return at_distance(out, distance);
}

void GoingAlong::move(const Snapshot& sim, const Viewport& port, UiState& ui) {
  if (sim.a.poses) return;
  if (model_ != sim.a.model) begin(sim);
  const double passed = sim.a.state->time - time_;
  const bool jumped = sim.jumps != jumps_ || passed < 0 || passed > kJump;
  time_ = sim.a.state->time;
  jumps_ = sim.jumps;
  const bool by_hand = !ui.framed || rounded(ui.camera) != ui.framed->camera;
  if (!ui.along || by_hand || ui.follow || ui.fly) active_ = false;
  if (!ui.along || by_hand || ui.follow || ui.fly || passed == 0) return;

  auto spots = std::make_shared<std::vector<Spot>>(what_moves(sim.a));
  if (spots->empty()) return;
  const double aspect = port.width / port.height;
  CameraPose goal = precise(fit_camera(*spots, rounded(ui.camera), aspect));
  const double closest = std::min(ui.camera.distance(), body_ / (kClose * slope_of(ui.camera, port)));
  if (goal.distance() < closest) goal.eye = goal.target + closest * axes_of(goal).back;
  if (!active_) {
    const double seen = body_ / half_seen(ui.camera, port, middle_);
    const bool small = seen < kSmall && kNearer * goal.distance() < ui.camera.distance();
    if (!ui.framed->near && !small && all_inside(ui.camera, port, soon_)) return;
    start(ui);
  }
  CameraPose camera = goal;
  if (!jumped) {
    ease(passed, rounded(goal));
    camera = eased(ui.camera, std::exp(log_distance_));
    // As little towards the goal as it takes.
    const auto between = [&, free = camera](double part) {
      CameraPose out = free;
      out.eye += part * (goal.eye - free.eye);
      out.target += part * (goal.target - free.target);
      return out;
    };
    double least = 0, most = all_inside(camera, port, now_) ? 0 : 1;
    for (int k = 0; k < kHalvings && most > 0; ++k) {
      const double part = 0.5 * (least + most);
      (all_inside(between(part), port, now_) ? most : least) = part;
    }
    camera = between(most);
  }
  offset_ = camera.eye - follower_;
  if (jumped) {
    follower_ = middle_;
    follower_speed_ = velocity_;
    offset_ = camera.eye - middle_;
    offset_speed_ = Vec3::Zero();
    log_distance_ = std::log(camera.distance());
    log_speed_ = 0;
  }
  ui.camera = camera;
  ui.framed = Framed{std::move(spots), rounded(camera), aspect};
}

}  // namespace pabd
