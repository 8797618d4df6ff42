// SPDX-License-Identifier: MIT
// Brute force, with no thought for speed and no code of the library but its types.
#include "tests/collision/reference.h"

#include <algorithm>
#include <cmath>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/shape_kind.h"
#include "tests/support/draws.h"

namespace reference {

Index Setup::add(const Shape& shape, const Vec3& centre, const Mat3& rotation, double reach_of, bool fixed) {
  const bool plane = std::holds_alternative<Plane>(shape);
  model.name.push_back("body " + std::to_string(model.size()));
  model.shape.push_back(shape);
  model.mass.push_back(fixed || plane ? 0 : 1);
  model.J.push_back(Mat3::Identity());
  model.fixed.push_back(fixed || plane);
  c.push_back(centre);
  R.push_back(rotation);
  reach.push_back(reach_of);
  return model.size() - 1;
}

std::vector<ContactPoint> Setup::contacts(int threads, const std::vector<IndexPair>& skip) const {
  CollisionWorkspace workspace;
  std::vector<ContactPoint> out;
  detect(model, c, R, reach, skip, threads, workspace, out);
  return out;
}

Vec3 Random::direction() {
  std::normal_distribution<double> normal;
  return testing::draw_vector([&] { return normal(generator_); }).normalized();
}

Vec3 Random::within(double lo, double hi) {
  return testing::draw_vector([&] { return uniform(lo, hi); });
}

Vec3 Random::offset(double nearest, double far) {
  const double length = uniform(nearest, far);
  return length * direction();
}

Mat3 Random::rotation() {
  std::normal_distribution<double> normal;
  const double w = normal(generator_), x = normal(generator_), y = normal(generator_), z = normal(generator_);
  return Quat(w, x, y, z).normalized().toRotationMatrix();
}

Mat3 Random::turn(double most) {
  const double angle = uniform(0, most);
  return Eigen::AngleAxisd(angle, direction()).toRotationMatrix();
}

Shape hull_of_box(const Vec3& half) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  }
  return Hull{make_hull(corners).hull};
}

Shape prism(int sides, double radius, double half_height) {
  std::vector<Vec3> points;
  for (int k = 0; k < sides; ++k) {
    const double a = 2 * kPi * k / sides;
    for (const double y : {-half_height, half_height})
      points.emplace_back(radius * std::cos(a), y, radius * std::sin(a));
  }
  return Hull{make_hull(points).hull};
}

Shape rock(int corners, double size, unsigned seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int k = 0; k < corners; ++k) points.push_back(size * random.direction());
  return Hull{make_hull(points).hull};
}

double support(const Shape& shape, const Vec3& c, const Mat3& R, const Vec3& n) {
  const Vec3 u = R.transpose() * n;
  if (const auto* box = std::get_if<Box>(&shape)) {
    double best = -1e300;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner = box->half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
      best = std::max(best, u.dot(corner));
    }
    return n.dot(c) + best;
  }
  if (const auto* hull = std::get_if<Hull>(&shape)) {
    double best = -1e300;
    for (const Vec3& v : hull->data->vertices) best = std::max(best, u.dot(v));
    return n.dot(c) + best;
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return n.dot(c) + sphere->radius;
  if (const auto* solid = std::get_if<Solid>(&shape)) return support(solid->data->facets, c, R, n);
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    double best = -1e300;
    for (const CompoundPart& part : compound->data->parts)
      best = std::max(best, support(part.hull(), c + R * part.offset, R, n));
    return best;
  }
  const auto& capsule = std::get<Capsule>(shape);
  return n.dot(c) + std::max(u.y(), -u.y()) * capsule.length / 2 + capsule.radius;
}

double surface_distance(const Shape& shape, const Vec3& c, const Mat3& R, const Vec3& x) {
  const Vec3 p = R.transpose() * (x - c);
  if (const auto* box = std::get_if<Box>(&shape)) {
    const Vec3 past = p.cwiseAbs() - box->half;
    return past.cwiseMax(0).norm() + std::min(0.0, past.maxCoeff());
  }
  if (const auto* hull = std::get_if<Hull>(&shape)) {
    // Inside: the nearest face. Outside this is only a lower bound, but zero exactly on the surface.
    double highest = -1e300;
    for (const HullFace& face : hull->data->faces)
      highest = std::max(highest, face.normal.dot(p) - face.offset);
    return highest;
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return p.norm() - sphere->radius;
  const auto& capsule = std::get<Capsule>(shape);
  const Vec3 end(0, std::copysign(capsule.length / 2, p.y()), 0);
  if (std::abs(p.y()) > capsule.length / 2) return (p - end).norm() - capsule.radius;
  return std::hypot(p.x(), p.z()) - capsule.radius;
}

namespace {

// The shape is the convex hull of these points, swollen by a radius.
struct Core {
  std::vector<Vec3> points;
  double radius = 0;
};

Core core(const Shape& shape, const Vec3& c, const Mat3& R) {
  Core out;
  const auto add = [&](const Vec3& x) { out.points.push_back(c + R * x); };
  if (const auto* box = std::get_if<Box>(&shape)) {
    for (int k = 0; k < 8; ++k)
      add(box->half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  } else if (const auto* hull = std::get_if<Hull>(&shape)) {
    for (const Vec3& v : hull->data->vertices) add(v);
  } else if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    add(Vec3::Zero());
    out.radius = sphere->radius;
  } else {
    const auto& capsule = std::get<Capsule>(shape);
    for (const double y : {-0.5, 0.5}) add(Vec3(0, y * capsule.length, 0));
    out.radius = capsule.radius;
  }
  return out;
}

// Every line between two of the points: the edges are among them.
std::vector<Vec3> chords(const std::vector<Vec3>& points) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) out.push_back(points[i] - points[j]);
  return out;
}

// The largest gap seen along the directions asked for, either way round.
struct BestGap {
  const std::vector<Vec3>&a, &b;
  double value = -1e300;

  void look_along(const Vec3& direction) {
    const double length = direction.norm();
    if (!(length > 1e-12)) return;
    double a_lo = 1e300, a_hi = -1e300, b_lo = 1e300, b_hi = -1e300;
    for (const Vec3& x : a) {
      const double s = direction.dot(x);
      a_lo = std::min(a_lo, s);
      a_hi = std::max(a_hi, s);
    }
    for (const Vec3& x : b) {
      const double s = direction.dot(x);
      b_lo = std::min(b_lo, s);
      b_hi = std::max(b_hi, s);
    }
    value = std::max(value, std::max(b_lo - a_hi, a_lo - b_hi) / length);
  }
};

// Directions from the points of one body straight to the lines of the other.
void look_from_points_to_lines(const std::vector<Vec3>& points, const std::vector<Vec3>& ends,
                               BestGap& best) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 line = (ends[i] - ends[j]).normalized();
      for (const Vec3& x : points) best.look_along((x - ends[j]) - line.dot(x - ends[j]) * line);
    }
}

}  // namespace

double signed_distance(const Setup& setup, Index a, Index b, double enough) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const Core core_a = core(setup.model.shape[i], setup.c[i], setup.R[i]);
  const Core core_b = core(setup.model.shape[j], setup.c[j], setup.R[j]);
  const auto lines_a = chords(core_a.points), lines_b = chords(core_b.points);
  const double radii = core_a.radius + core_b.radius;
  BestGap best{core_a.points, core_b.points};
  for (const Vec3& x : core_a.points)  // apart: point and point
    for (const Vec3& y : core_b.points) best.look_along(y - x);
  if (best.value - radii > enough) return best.value - radii;
  look_from_points_to_lines(core_a.points, core_b.points, best);  // point and edge
  look_from_points_to_lines(core_b.points, core_a.points, best);
  for (const auto* lines : {&lines_a, &lines_b})  // a face
    for (std::size_t k = 0; k < lines->size(); ++k)
      for (std::size_t m = 0; m < k; ++m) best.look_along((*lines)[k].cross((*lines)[m]));
  for (const Vec3& u : lines_a)  // two edges
    for (const Vec3& v : lines_b) best.look_along(u.cross(v));
  return best.value - radii;
}

}  // namespace reference
