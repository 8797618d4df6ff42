// SPDX-License-Identifier: MIT
// Glyphs of joints. What is held where comes from expand(): the picture shows the bonds that the solver has.
//
//   y_i, y_j   the two points of a bond                    m
//   n, e, b    axis of the joint's frame and what is across it: F.col(0), (1), (2)
//   φ, λ       angle and offset of j against i             rad, m
//   r          radius of the dot of y_i                    m
//   px         what a pixel spans at the anchor            m
#include "render/visual/joint_glyphs.h"

#include <algorithm>
#include <cmath>

#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"
#include "sim/joint/expand.h"

namespace pabd {
namespace {

// Pixels at 720 px frame height.
constexpr double kLeastDot = glyph::kLeastPoint, kLargestDot = 5.0;
constexpr double kVisibleGap = 0.5;   // a shorter line between two points says nothing
constexpr double kLeastSpread = 2.5;  // × rim: points nearer to each other than this are drawn as one pair
constexpr double kLeastArms = 40;     // of a joint that leaves nothing free
constexpr double kWrongGap = 3;
constexpr double kLeastDial = 9, kLeastFreeDial = 27, kLargestDial = 54;

constexpr std::size_t kManyJoints = 2000;  // more are drawn as plain dots

constexpr double kDisc = 1.72, kRim = 2.25;  // radii of y_j's disc and of its rim, × r

Vec4f faded(const Vec4f& color, double opacity) {
  Vec4f out = color;
  out.w() = static_cast<float>(opacity);
  return out;
}

struct JointPainter {
  const Joint& joint;
  const PlacedFrame& fi;
  const PlacedFrame& fj;
  double time, r, px;
  double pull;  // m that points are moved towards the eye, out of their own bodies
  const PixelMeter& meter;
  Vec4f color;
  bool plain;  // one dot where the points of a bond meet
  VisualScene& out;

  // A disc that faces the eye and appears at p with the given radius, nearer to the eye by `layer` radii of a
  // dot.
  void disc(const Vec3& p, double layer, double radius, const Vec4f& ink) const {
    const Vec3 v = meter.to_eye(p);
    const double distance = meter.distance(p), nearer = std::min(pull + layer * r, 0.5 * distance);
    const double size = radius * (1 - nearer / distance);
    out.instances[static_cast<int>(Primitive::disc)].push_back(
        {place_along(p + nearer * v, v, size, size), ink, false, false, true});
  }

  // y_i in front, so that it stays in sight where the two meet.
  void points(const Vec3& y_i, const Vec3& y_j) const {
    const bool apart = (y_j - y_i).norm() > kVisibleGap * px;
    if (plain && !apart) return disc(y_j, 0, kDisc * r, color);
    disc(y_j, 0, kRim * r, color);
    disc(y_j, 0.3, kDisc * r, bond_point_j_color());
    disc(y_i, 2, r, bond_point_i_color());
    if (apart && !traits_of(joint.type).points) add_line(out, y_i, y_j, {bond_line_color(), 1.6});
  }

  void bonds(const BondList& list, bool spread) const {
    if (spread || list.count == 1) {
      for (int k = 0; k < list.count; ++k) {
        const PointBond& bond = list.bond[static_cast<std::size_t>(k)];
        points(bond.y_a, bond.y_b);
      }
      return;
    }
    Vec3 y_i = Vec3::Zero(), y_j = Vec3::Zero();
    for (int k = 0; k < list.count; ++k) {
      y_i += list.bond[static_cast<std::size_t>(k)].y_a / list.count;
      y_j += list.bond[static_cast<std::size_t>(k)].y_b / list.count;
    }
    points(y_i, y_j);
  }

  void axis(const Vec3& n) const {
    add_line(out, fi.y - 1.5 * joint.arm * n, fi.y + 1.5 * joint.arm * n, {color, 2.2});
  }

  // An angle about the anchor of i, with a zero mark, a pointer and, if there are any, limits.
  void dial(const JointMeasure& measure, const JointRange* limits) const {
    const double radius = std::min(0.8 * joint.arm, kLargestDial * px);
    if (radius < (limits ? kLeastDial : kLeastFreeDial) * px) return;  // many free hinges would be a thicket
    const AnglePlane plane = measure.plane(fi, fj);
    const double phi = measure.value(fi, fj);
    const auto at = [&](double angle, double share) -> Vec3 {
      return fi.y + share * radius * (std::cos(angle) * plane.zero + std::sin(angle) * plane.ahead);
    };
    add_line(out, at(0, 0.82), at(0, 1.18), {color, 1.6});
    if (limits) {
      add_arc(out, fi.y, plane.zero, plane.ahead, radius, limits->lo, limits->hi, {faded(color, 0.45), 4});
      for (const double bound : {limits->lo, limits->hi}) {
        add_line(out, at(bound, 0.82), at(bound, 1.18), {color, 2.4});
      }
    } else {
      add_arc(out, fi.y, plane.zero, plane.ahead, radius, 0, phi, {faded(color, 0.7), 2});
    }
    add_line(out, fi.y, at(phi, 1.18), {color, 2.4});
  }

  // The offset moves j along +n, and so is drawn from the anchor of i.
  void rail(const JointMeasure& measure, const JointRange* limits) const {
    const Vec3 n = fj.F.col(0);
    const double lambda = measure.value(fi, fj);
    const double lo = limits ? limits->lo : std::min(-1.5 * joint.arm, lambda);
    const double hi = limits ? limits->hi : std::max(1.5 * joint.arm, lambda);
    add_line(out, fi.y + lo * n, fi.y + hi * n, {faded(color, 0.7), 2});
    const Vec3 side = n.cross(meter.to_eye(fi.y)).stableNormalized();
    const auto mark = [&](double at, double half, double width) {
      add_line(out, fi.y + at * n - half * px * side, fi.y + at * n + half * px * side, {color, width});
    };
    if (limits) {
      mark(lo, 8, 3);
      mark(hi, 8, 3);
    }
    mark(0, 5, 1.6);
    mark(lambda, 6, 3.4);
    add_line(out, fi.y, fi.y + lambda * n, {color, 4.4});
  }

  // What leaves nothing free shows the directions along which it holds.
  void frame() const {
    for (int k = 0; k < 3; ++k) {
      const Vec3 reach = joint.arm * fi.F.col(k);
      add_line(out, fi.y - reach, fi.y + reach, {faded(color, 0.8), 1.6});
    }
  }

  // A rail or its axes, and dials.
  void freedom(const JointTraits& traits) const {
    const auto limits_of = [&](const JointMeasure& measure) -> const JointRange* {
      return measure.limits && joint.*measure.limits ? &*(joint.*measure.limits) : nullptr;
    };
    bool slides = false;
    for (const JointMeasure& measure : traits.measures) {
      if (measure.of != JointMeasure::Of::offset) continue;
      rail(measure, limits_of(measure));
      slides = true;
    }
    if (traits.axes > 0 && !slides) axis(fi.F.col(0));
    if (traits.axes > 1) axis(fj.F.col(1));
    for (const JointMeasure& measure : traits.measures) {
      const JointRange* limits = limits_of(measure);
      if (measure.of == JointMeasure::Of::angle && (limits || !measure.held)) dial(measure, limits);
    }
  }

  void spring() const {
    if (joint.law.potential == BondPotential::hard) {
      add_line(out, fi.y, fj.y, {color, 3});
      return;
    }
    const double radius = std::clamp(0.08 * joint.length, 2.5 * px, 11 * px);
    const bool flat = radius < 4.5 * px;
    const double length = (fj.y - fi.y).norm();
    if (length < 4 * radius) {
      add_line(out, fi.y, fj.y, {color, 2});
      return;
    }
    // The number of turns is that of the rest length, so that the coil opens and closes as it stretches.
    const int turns = std::clamp(static_cast<int>(0.6 * joint.length / radius), 4, 12);
    add_coil(out, fi.y, fj.y, radius, turns, flat, (fj.y - fi.y).cross(meter.to_eye(fi.y)), {color, 1.8});
  }
};

bool is_finite(const PlacedFrame& frame) { return frame.y.allFinite() && frame.F.allFinite(); }

}  // namespace

void add_joint_glyphs(const Joint& joint, const Pose& i, const Pose& j, double time, const GlyphSize& size,
                      VisualScene& out) {
  const PlacedFrame fi = place(joint.on_i, i), fj = place(joint.on_j, j);
  if (!is_finite(fi) || !is_finite(fj) || !std::isfinite(joint.arm)) return;
  const PixelMeter meter(out.camera);
  const double px = meter.at(fi.y);
  const double r = std::clamp(size.dot, kLeastDot * px, kLargestDot * px);
  const JointPainter painter{joint,      fi, fj, time, r, px, size.pull, meter, joint_color(joint.type),
                             size.plain, out};
  BondList list;
  expand(joint, i, j, time, list);
  bool spread = joint.arm > kLeastSpread * kRim * r;
  // Seven bonds each would bury a frame of many parts: one point, unless it is large or something is wrong.
  const JointTraits& traits = traits_of(joint.type);
  const bool holds_all = traits.translations == 0 && traits.rotations == 0;
  if (holds_all && joint.arm < kLeastArms * px) {
    const auto end = list.bond.cbegin() + list.count;
    spread = std::any_of(list.bond.cbegin(), end, [&](const PointBond& bond) {
      return (bond.y_b - bond.y_a).norm() > kWrongGap * px;
    });
  }
  if (holds_all && spread) painter.frame();
  if (spread) painter.freedom(traits);
  if (traits.points) painter.spring();
  painter.bonds(list, spread);
}

void add_joint_glyphs(const Model& model, const State& state, VisualScene& out) {
  for (const Joint& joint : model.joints) add_joint_glyphs(model, state, joint, out);
}

void add_joint_glyphs(const Model& model, const State& state, const Joint& joint, VisualScene& out) {
  GlyphSize size;
  size.plain = model.joints.size() > kManyJoints;
  double width = 1e30, reach = 1e30;  // of the slimmer and of the smaller body
  for (const Index body : {joint.i, joint.j}) {
    if (body == kWorld) continue;
    width = std::min(width, inner_radius(model.shape[body]));
    reach = std::min(reach, bounding_radius(model.shape[body]));
  }
  size.dot = 0.18 * width;
  size.pull = reach < 1e30 ? reach : 0;
  add_joint_glyphs(joint, pose_of(state, joint.i), pose_of(state, joint.j), state.time, size, out);
}

Pose pose_of(const State& state, Index body) {
  if (body == kWorld) return {Vec3::Zero(), Mat3::Identity()};
  return {state.c[body], state.R[body]};
}

unsigned joint_types(const Model& model) {
  unsigned types = 0;
  for (const Joint& joint : model.joints) types |= 1u << static_cast<unsigned>(joint.type);
  return types;
}

}  // namespace pabd
