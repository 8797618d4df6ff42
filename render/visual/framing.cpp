// SPDX-License-Identifier: MIT
// The least distance from which balls fit into a rectangle of the picture.
//
//   x, y, z    right, up, back: the axes of the picture                    unit
//   p, r       centre of a ball in these axes, its radius                  m
//   e          the eye in these axes                                       m
//   t          half the width (or height) of the rectangle at depth 1      1
//
// A ball is on the inner side of the right edge's plane if  p_x + t p_z + r √(1+t²) ≤ e_x + t e_z,  and of the left
// one's if  p_x − t p_z − r √(1+t²) ≥ e_x − t e_z.  With R the largest left side of the first and L the least of the
// second both hold for some e_x if and only if  e_z ≥ (R − L) / 2t;  e_x is then between R − t e_z and L + t e_z, and
// what is at the middle of the outline falls from one end to the other.
#include "render/visual/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/visual/bounds.h"
#include "render/visual/build_visual.h"
#include "render/visual/camera_control.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr int kRimPoints = 32;
constexpr double kEyeAzimuth = -26 * kPi / 180, kEyeElevation = 17 * kPi / 180;
constexpr float kFov = 32;  // degrees
constexpr double kNearFloor =
    1.5;                          // a floor within this many radii of what is above it belongs to the picture
constexpr double kUpright = 0.5;  // cosine of the steepest floor
constexpr int kTurns = 48;        // azimuths of an orbit that are looked at
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void add_rim(const Pose& pose, const Vec3& middle, double radius, std::vector<Spot>& out) {
  const double outside = radius / std::cos(kPi / kRimPoints);
  for (int k = 0; k < kRimPoints; ++k) {
    const double angle = 2 * kPi * k / kRimPoints;
    out.push_back({pose.c + pose.R * (middle + outside * Vec3(std::cos(angle), 0, std::sin(angle)))});
  }
}

void add_part(const SurfacePart& part, const Pose& pose, std::vector<Spot>& out) {
  const auto world = [&](const Vec3& p) -> Vec3 { return pose.c + pose.R * (part.at + p); };
  switch (part.form) {
    case SurfaceForm::box:
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
          for (const double z : {-1.0, 1.0}) out.push_back({world(part.size.cwiseProduct(Vec3(x, y, z)))});
      return;
    case SurfaceForm::ball:
    case SurfaceForm::half_ball:  // the other half is inside of what it caps
      out.push_back({world(Vec3::Zero()), part.size.x()});
      return;
    case SurfaceForm::tube:  // between two half balls
      return;
    case SurfaceForm::cylinder:
      for (const double end : {-part.size.y(), part.size.y()})
        add_rim(pose, part.at + Vec3(0, end, 0), part.size.x(), out);
      return;
    case SurfaceForm::cone:
      add_rim(pose, part.at, part.size.x(), out);
      out.push_back({world(Vec3(0, part.size.y(), 0))});
      return;
    case SurfaceForm::polyhedron:
      for (const Vec3& vertex : part.hull->data->vertices) out.push_back({world(vertex)});
      return;
  }
}

// What the spots span along one axis of the picture: as tangents, or in m for an orthographic camera.
struct Extent {
  double lo = kInfinity, hi = -kInfinity;
  void add(double x, double depth, double r) {
    const double middle = std::atan2(x, depth), half = std::asin(std::min(1.0, r / std::hypot(x, depth)));
    lo = std::min(lo, std::tan(middle - half));
    hi = std::max(hi, std::tan(middle + half));
  }
};

// Both sides of an axis, in the terms of the top of the file.
struct Edges {
  double R = -kInfinity, L = kInfinity;
  void add(double p, double pz, double r, double t) {
    const double reach = r * std::sqrt(1 + t * t);
    R = std::max(R, p + t * pz + reach);
    L = std::min(L, p - t * pz - reach);
  }
  double depth(double t) const { return (R - L) / (2 * t); }
};

// In the axes of the picture, centred about the middle of their box.
struct Seen {
  std::vector<Spot> spots;
  Vec3 lo = Vec3::Constant(kInfinity), hi = Vec3::Constant(-kInfinity);
};

Seen seen_from(std::span<const Spot> spots, const CameraAxes& axes) {
  Seen out;
  out.spots.reserve(spots.size());
  for (const Spot& spot : spots) {
    const Vec3 p(spot.centre.dot(axes.right), spot.centre.dot(axes.up), spot.centre.dot(axes.back));
    out.spots.push_back({p, spot.radius});
    out.lo = out.lo.cwiseMin((p.array() - spot.radius).matrix());
    out.hi = out.hi.cwiseMax((p.array() + spot.radius).matrix());
  }
  return out;
}

// Half the free part at depth 1, and where its middle is.
struct Window {
  double tx, ty;
  Eigen::Vector2f shift;
};

Window window_of(const Camera& like, double aspect, const PicturePart& part) {
  const double slope = std::tan(0.5 * static_cast<double>(like.fov) * kPi / 180);
  return {kFill * slope * aspect * part.w,
          kFill * slope * part.h,
          {static_cast<float>(2 * (part.x + 0.5 * part.w) - 1),
           static_cast<float>(1 - 2 * (part.y + 0.5 * part.h))}};
}

// e along `axis`, with what is seen from depth e_z in the middle.
double middle(const std::vector<Spot>& spots, int axis, double ez, double lo, double hi) {
  for (int halving = 0; halving < 48 && hi - lo > 1e-12 * ez; ++halving) {
    const double e = 0.5 * (lo + hi);
    Extent extent;
    for (const Spot& spot : spots) extent.add(spot.centre[axis] - e, ez - spot.centre.z(), spot.radius);
    (extent.lo + extent.hi > 0 ? lo : hi) = e;
  }
  return 0.5 * (lo + hi);
}

struct Fit {
  Vec3 target;      // in the axes of the picture
  double distance;  // m
};

// `on_axis`: e_x is given, and the spots are alike on both sides of it.
Fit fit(const Seen& seen, const Window& window, bool orthographic, const double* on_axis) {
  const double middle_depth = 0.5 * (seen.lo.z() + seen.hi.z());
  const double least = 1e-6 + 1e-6 * seen.hi.cwiseAbs().maxCoeff();
  if (orthographic) {
    const Vec3 half = 0.5 * (seen.hi - seen.lo);
    const Vec3 at = 0.5 * (seen.hi + seen.lo);
    return {{on_axis ? *on_axis : at.x(), at.y(), middle_depth},
            std::max({half.x() / window.tx, half.y() / window.ty, least})};
  }
  Edges h, v;
  for (const Spot& spot : seen.spots) {
    h.add(spot.centre.x(), spot.centre.z(), spot.radius, window.tx);
    v.add(spot.centre.y(), spot.centre.z(), spot.radius, window.ty);
  }
  const double ez = std::max({h.depth(window.tx), v.depth(window.ty), seen.hi.z() + least});
  const double ex =
      on_axis ? *on_axis : middle(seen.spots, 0, ez, h.R - window.tx * ez, h.L + window.tx * ez);
  const double ey = middle(seen.spots, 1, ez, v.R - window.ty * ez, v.L + window.ty * ez);
  return {{ex, ey, middle_depth}, ez - middle_depth};
}

Camera placed(const Camera& like, const CameraAxes& axes, const Vec3& target, double distance,
              const Eigen::Vector2f& shift) {
  Camera camera = like;
  camera.target = target.cast<float>();
  camera.eye = (target + distance * axes.back).cast<float>();
  camera.shift = shift;
  return camera;
}

bool is_usable(const Camera& like, double aspect, const PicturePart& part) {
  return aspect > 0 && part.w > 0 && part.h > 0 && (like.eye - like.target).allFinite();
}

// Centre of the least circle around the spots as seen from above: steps towards the farthest, ever shorter
// (Bădoiu and Clarkson 2003).
Vec3 upright_axis(std::span<const Spot> spots) {
  Vec3 at = spots.front().centre;
  for (int step = 1; step <= 400; ++step) {
    double farthest = -1;
    Vec3 towards = Vec3::Zero();
    for (const Spot& spot : spots) {
      const Vec3 d(spot.centre.x() - at.x(), 0, spot.centre.z() - at.z());
      const double reach = d.norm() + spot.radius;
      if (reach <= farthest) continue;
      farthest = reach;
      towards = d.norm() > 0 ? Vec3(d * (reach / d.norm())) : Vec3::Zero();
    }
    at += towards / (step + 1);
  }
  return {at.x(), 0, at.z()};
}

// Those that are outermost in some direction of the half plane (distance from the axis, height): the others are
// inside of what they sweep.
std::vector<Spot> outermost(std::span<const Spot> spots, const Vec3& axis) {
  constexpr int kDirections = 96;
  std::vector<Spot> out;
  for (int k = 0; k <= kDirections; ++k) {
    const double angle = kPi * (static_cast<double>(k) / kDirections - 0.5);
    double most = -kInfinity;
    Spot best{};
    for (const Spot& spot : spots) {
      const double rho = std::hypot(spot.centre.x() - axis.x(), spot.centre.z() - axis.z());
      const double reach = rho * std::cos(angle) + spot.centre.y() * std::sin(angle) + spot.radius;
      if (reach > most) {
        most = reach;
        best = {{rho, spot.centre.y(), 0}, spot.radius};
      }
    }
    out.push_back(best);
  }
  return out;
}

void add_floor_spots(const Model& model, std::vector<Spot>& spots) {
  if (spots.empty()) return;
  const CameraAxes axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const Seen box = seen_from(spots, axes);
  const double radius = 0.5 * (box.hi - box.lo).norm();
  const std::size_t count = spots.size();
  for (Index i = 0; i < model.size(); ++i) {
    if (!is_plane(model.shape[i])) continue;
    const Plane& plane = as<Plane>(model.shape[i]);
    if (plane.normal.y() < kUpright) continue;
    double gap = kInfinity;
    for (std::size_t k = 0; k < count; ++k)
      gap = std::min(gap, plane.normal.dot(spots[k].centre) - plane.offset - spots[k].radius);
    if (!(gap > 0) || gap > kNearFloor * radius) continue;
    for (std::size_t k = 0; k < count; ++k)
      spots.push_back(
          {spots[k].centre - (plane.normal.dot(spots[k].centre) - plane.offset) * plane.normal, 0});
  }
}

}  // namespace

void add_spots(const Shape& shape, const Pose& pose, std::vector<Spot>& out) {
  if (!pose.c.allFinite() || !pose.R.allFinite()) return;
  std::vector<SurfacePart> parts;
  kind_of(shape).surface(shape, parts);
  for (const SurfacePart& part : parts) add_part(part, pose, out);
}

std::vector<Spot> body_spots(const Model& model, const State& state) {
  std::vector<Spot> out;
  const std::vector<std::uint8_t> in = bodies_in_picture(model, state);
  for (Index i = 0; i < model.size(); ++i) {
    if (in[static_cast<std::size_t>(i)]) add_spots(model.shape[i], {state.c[i], state.R[i]}, out);
  }
  return out;
}

std::vector<Spot> spots_of(const Model& model, const State& state) {
  std::vector<Spot> out = body_spots(model, state);
  add_floor_spots(model, out);
  return out;
}

Camera fit_camera(std::span<const Spot> spots, const Camera& like, double aspect, const PicturePart& part) {
  if (spots.empty() || !is_usable(like, aspect, part)) return like;
  const CameraAxes axes = axes_of(precise(like));
  const Window window = window_of(like, aspect, part);
  const Fit best = fit(seen_from(spots, axes), window, like.orthographic, nullptr);
  const Vec3 target = best.target.x() * axes.right + best.target.y() * axes.up + best.target.z() * axes.back;
  return placed(like, axes, target, best.distance, window.shift);
}

Camera fit_orbit(std::span<const Spot> spots, const Camera& like, double aspect, const PicturePart& part) {
  if (spots.empty() || !is_usable(like, aspect, part)) return like;
  const CameraAxes axes = axes_of(precise(like));
  const Window window = window_of(like, aspect, part);
  const Vec3 axis = upright_axis(spots);
  std::vector<Spot> swept;
  for (const Spot& spot : outermost(spots, axis)) {
    const double rho = spot.centre.x() / std::cos(kPi / kTurns);
    for (int k = 0; k < kTurns; ++k) {
      const double angle = 2 * kPi * k / kTurns;
      swept.push_back(
          {axis + Vec3(rho * std::cos(angle), spot.centre.y(), rho * std::sin(angle)), spot.radius});
    }
  }
  const double across = axis.dot(axes.right);
  const Fit best = fit(seen_from(swept, axes), window, like.orthographic, &across);
  const Vec3 eye =
      across * axes.right + best.target.y() * axes.up + (best.target.z() + best.distance) * axes.back;
  // Where the line of sight meets the axis; from straight above it never leaves it.
  const Vec3 level(axes.back.x(), 0, axes.back.z());
  const double slant = level.norm();
  const double distance = slant > 1e-3 ? Vec3(eye - axis).dot(level) / (slant * slant) : best.distance;
  if (like.orthographic) {
    // The distance sets its size, and its eye may be anywhere along the line of sight.
    const Vec3 target =
        slant > 1e-3 ? Vec3(eye - distance * axes.back) : Vec3(eye - best.distance * axes.back);
    return placed(like, axes, target, best.distance, window.shift);
  }
  return placed(like, axes, eye - distance * axes.back, distance, window.shift);
}

Camera pleasing_side() {
  Camera camera;
  camera.target = Vec3f::Zero();
  camera.eye = Vec3(std::sin(kEyeAzimuth) * std::cos(kEyeElevation), std::sin(kEyeElevation),
                    std::cos(kEyeAzimuth) * std::cos(kEyeElevation))
                   .cast<float>();
  camera.fov = kFov;
  return camera;
}

Camera frame_camera(const Model& model, const State& state, double aspect) {
  const std::vector<Spot> spots = spots_of(model, state);
  return spots.empty() ? Camera{} : fit_camera(spots, pleasing_side(), aspect);
}

}  // namespace pabd
