// Brute force, with no thought for speed and no code of the library but its types.
#include "reference.h"

#include <algorithm>
#include <cmath>

#include "sim/body/convex_hull.h"

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
  return Vec3(normal(generator_), normal(generator_), normal(generator_)).normalized();
}

Mat3 Random::rotation() {
  std::normal_distribution<double> normal;
  const Quat q(normal(generator_), normal(generator_), normal(generator_), normal(generator_));
  return q.normalized().toRotationMatrix();
}

Shape hull_of_box(const Vec3& half) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  }
  return Hull{make_hull(corners).hull};
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

double signed_distance(const Setup& setup, Index a, Index b) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const auto gap = [&](const Vec3& n) {
    return -support(setup.model.shape[j], setup.c[j], setup.R[j], -n) -
           support(setup.model.shape[i], setup.c[i], setup.R[i], n);
  };
  constexpr int kDirections = 3000, kStarts = 8;
  static const std::vector<Vec3> directions = [] {  // a golden spiral over the unit sphere
    std::vector<Vec3> list;
    for (int k = 0; k < kDirections; ++k) {
      const double y = 1 - (2 * k + 1.0) / kDirections, angle = k * kPi * (3 - std::sqrt(5.0));
      const double r = std::sqrt(1 - y * y);
      list.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
    }
    return list;
  }();
  std::vector<std::pair<double, int>> ranked;
  for (int k = 0; k < kDirections; ++k) ranked.emplace_back(-gap(directions[static_cast<std::size_t>(k)]), k);
  std::sort(ranked.begin(), ranked.end());

  Random random(99);
  double best = -1e300;
  std::vector<Vec3> starts;
  for (const auto& [value, k] : ranked) {
    const Vec3& n = directions[static_cast<std::size_t>(k)];
    const bool near_another =
        std::any_of(starts.begin(), starts.end(), [&](const Vec3& other) { return other.dot(n) > 0.99; });
    if (near_another) continue;
    starts.push_back(n);
    if (static_cast<int>(starts.size()) == kStarts) break;
  }
  for (Vec3 n : starts) {
    double value = gap(n), radius = 0.05;
    int failures = 0;
    while (radius > 1e-6) {
      const Vec3 trial = (n + radius * random.direction()).normalized();
      const double v = gap(trial);
      if (v > value) {
        value = v;
        n = trial;
        radius *= 1.3;
        failures = 0;
      } else if (++failures == 60) {
        radius *= 0.6;
        failures = 0;
      }
    }
    best = std::max(best, value);
  }
  return best;
}

}  // namespace reference
