// SPDX-License-Identifier: MIT
// Capsule against box, in the frame of the box. The box owns the normal.
//
// The capsule is its axis, the segment x(t) = p + t e, t ∈ [0, 1], swollen by its radius r. Three cases, in
// this order:
//   face    the segment lies over a face (or so nearly that the face is as good as any other normal): the
//           part over the face, two contacts
//   apart   the segment is outside: its nearest point to the box, one contact (more along an edge:
//           side_by_side)
//   edge    the segment pierces the box and the shortest way out is across an edge
//
//   h   half edges of the box                                                    m
//   s   separation of the segment from the box along an axis, negative inside    m
#include <limits>

#include "sim/collision/narrow_phase.h"
#include "sim/collision/side_by_side.h"

namespace pabd::narrow {
namespace {

// Feature: 0, 1 for the lower and upper end of the capsule over a face or along an edge, 2 between, shifted
// by the face or edge.
constexpr std::uint32_t kFaceBase = 16, kEdgeLineBase = 64, kNearestBase = 128, kPierceBase = 256;

struct Segment {
  Vec3 p, e;
  Vec3 at(double t) const { return p + t * e; }
};

struct Query {
  const Placed<Box>& box;
  const Placed<Capsule>& capsule;
  Segment segment;  // in the frame of the box
  Vec3 u;           // its direction, unit
  double reach;
  Contacts& out;

  // y and n in the frame of the box.
  void add(const Vec3& y, const Vec3& n, double d, std::uint32_t feature) const {
    if (d < reach) add_contact(out, box.number, capsule.number, box.c + box.R * y, box.R * n, d, feature);
  }
};

std::uint32_t edge_number(int axis, const Vec3& toward) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  return static_cast<std::uint32_t>(axis * 4 + (toward[j] < 0 ? 1 : 0) + (toward[k] < 0 ? 2 : 0));
}

// Place t of the point of the segment nearest to the box: the zero of the derivative of the squared distance,
// which is continuous, piecewise linear and rising, with kinks where the segment crosses a side plane.
double nearest_to_box(const Segment& x, const Vec3& h) {
  double kink[8];  // sorted
  int count = 0;
  const auto insert = [&](double t) {
    int k = count++;
    for (; k > 0 && kink[k - 1] > t; --k) kink[k] = kink[k - 1];
    kink[k] = t;
  };
  insert(0);
  insert(1);
  for (int k = 0; k < 3; ++k) {
    if (x.e[k] == 0) continue;
    for (const double side : {-h[k], h[k]}) {
      const double t = (side - x.p[k]) / x.e[k];
      if (t > 0 && t < 1) insert(t);
    }
  }
  const auto slope = [&](double t) {
    const Vec3 y = x.at(t);
    return x.e.dot(y - y.cwiseMax(-h).cwiseMin(h));
  };
  double t_0 = 0, slope_0 = slope(0);
  if (slope_0 >= 0) return 0;
  for (int k = 1; k < count; ++k) {
    const double t_1 = kink[k], slope_1 = slope(t_1);
    if (slope_1 >= 0) return t_0 + (t_1 - t_0) * (-slope_0 / (slope_1 - slope_0));
    t_0 = t_1;
    slope_0 = slope_1;
  }
  return 1;
}

// The part [low, high] of the segment with |x_k| ≤ h_k for both axes k other than `axis` (or for `axis`
// alone).
bool clip(const Segment& x, const Vec3& h, int axis, bool axis_alone, double& low, double& high) {
  low = 0;
  high = 1;
  for (int k = 0; k < 3; ++k) {
    if ((k == axis) != axis_alone) continue;
    if (std::abs(x.e[k]) < 1e-14 * h[k]) {
      if (std::abs(x.p[k]) > h[k]) return false;
      continue;
    }
    const double t_0 = (-h[k] - x.p[k]) / x.e[k], t_1 = (h[k] - x.p[k]) / x.e[k];
    low = std::max(low, std::min(t_0, t_1));
    high = std::min(high, std::max(t_0, t_1));
  }
  return low <= high;
}

bool over_face(const Vec3& x, const Vec3& h, int axis) {
  for (int k = 0; k < 3; ++k) {
    if (k != axis && std::abs(x[k]) > h[k]) return false;
  }
  return true;
}

// Both ends of the part of the capsule that lies over a face. Returns the smallest d of the two, in reach or
// not; kNone when nothing lies over the face. The lower end is the bottom of its cap, if that is over the
// face. Everything else touches along the side of the cylinder, r off the axis: that line is clipped, or,
// when the segment pierces the box, the segment itself, which is sure to leave something.
double add_face(const Query& q, int axis, double sign, bool pierces) {
  const Vec3& h = q.box.shape.half;
  const Vec3 n = sign * Vec3::Unit(axis);
  const double radius = q.capsule.shape.radius, slope = n.dot(q.u);
  const std::uint32_t feature = kFaceBase + 4u * static_cast<std::uint32_t>(axis) + (sign < 0 ? 2u : 0u);
  double lowest = kNone;
  const auto add = [&](const Vec3& y, std::uint32_t end) {
    const double d = n.dot(y) - h[axis];
    lowest = std::min(lowest, d);
    q.add(y, n, d, feature + end);
  };

  int done = -1;
  if (slope != 0) {
    const int low_end = slope > 0 ? 0 : 1;
    const Vec3 p = q.segment.at(low_end);
    if (over_face(p, h, axis)) {
      add(p - radius * n, static_cast<std::uint32_t>(low_end));
      done = low_end;
    }
  }
  const Vec3 side = n - slope * q.u;
  if (!(side.norm() > 1e-6)) return lowest;
  const Vec3 down = -radius * side.normalized();
  const Segment line{q.segment.p + down, q.segment.e};
  double low, high;
  const bool touches = clip(line, h, axis, false, low, high);
  if (!touches && !(pierces && done < 0 && clip(q.segment, h, axis, false, low, high))) return lowest;
  if (done != 0) add(line.at(low), 0);
  if (done != 1 && (high > low || done == 0)) add(line.at(high), 1);
  return lowest;
}

// Where the segment, `gap` away at its nearest, runs side by side with an edge. False where it does not, or
// not where it is nearest.
bool add_along_edge(const Query& q, const Vec3& gap) {
  const Vec3& h = q.box.shape.half;
  const double radius = q.capsule.shape.radius;
  int axis = 0;
  q.u.cwiseAbs().maxCoeff(&axis);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  if (gap[j] == 0 || gap[k] == 0) return false;
  EdgeLine edge{Vec3::Zero(), Vec3::Unit(axis), h[axis]};
  for (const int m : {j, k}) {
    edge.middle[m] = sign_of(gap[m]) * h[m];
    edge.into[m == j ? 0 : 1] = -sign_of(gap[m]) * Vec3::Unit(m);
  }
  const EdgeLine segment{q.segment.at(0.5), q.u, 0.5 * q.capsule.shape.length};
  SidePlace place[3];
  const double nearest = gap.norm() - radius, slack = preference(nearest, h.minCoeff());
  const int count = side_by_side(edge, segment, 0.5 * slack, 0, place);
  const std::uint32_t feature = kEdgeLineBase + 4 * edge_number(axis, gap);
  double d[3], lowest = kNone;
  for (int n = 0; n < count; ++n) {
    d[n] = distance_to_capsule(place[n], segment, radius);
    lowest = std::min(lowest, d[n]);
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int n = 0; n < count; ++n) {
    const SidePlace& p = place[n];
    constexpr std::uint32_t kFeature[] = {2, 0, 1};
    q.add(p.y - (p.distance - d[n]) * p.n, p.n, d[n], feature + kFeature[p.where]);
  }
  return true;
}

// Segment outside the box, nearest at t.
void add_nearest(const Query& q, double t) {
  const Vec3& h = q.box.shape.half;
  const double radius = q.capsule.shape.radius;
  const Vec3 x = q.segment.at(t), gap = x - x.cwiseMax(-h).cwiseMin(h);
  const double distance = gap.norm();
  if (!(distance > 0) || add_along_edge(q, gap)) return;
  const Vec3 n = gap / distance;
  q.add(x - radius * n, n, distance - radius, kNearestBase + (t <= 0 ? 0u : t >= 1 ? 1u : 2u));
}

struct EdgeAxis {
  double separation = -std::numeric_limits<double>::infinity();
  int axis = -1;  // direction of the box edge
  Vec3 n;         // unit, from the box towards the segment
};

// Best separating direction among (edge of the box) × (segment).
EdgeAxis best_edge(const Segment& x, const Vec3& h) {
  EdgeAxis best;
  const Vec3 middle = x.at(0.5);
  const double length = x.e.norm();
  for (int k = 0; k < 3; ++k) {
    Vec3 n = Vec3::Unit(k).cross(x.e);
    const double size = n.norm();
    if (!(size > 1e-4 * length)) continue;  // parallel: a face direction says the same
    n /= sign_of(n.dot(middle)) * size;
    const double separation = n.dot(middle) - n.cwiseAbs().dot(h);
    if (separation > best.separation) best = {separation, k, n};
  }
  return best;
}

void add_pierced_edge(const Query& q, const EdgeAxis& edge) {
  const Vec3& h = q.box.shape.half;
  Vec3 corner(sign_of(edge.n.x()), sign_of(edge.n.y()), sign_of(edge.n.z()));
  corner = corner.cwiseProduct(h);
  corner[edge.axis] = 0;
  // Nearest point of the segment to the line of the edge: only the components across the edge count.
  Vec3 across = q.segment.e, offset = corner - q.segment.p;
  across[edge.axis] = offset[edge.axis] = 0;
  const double t = std::clamp(offset.dot(across) / across.squaredNorm(), 0.0, 1.0);
  const Vec3 y = q.segment.at(t) - q.capsule.shape.radius * edge.n;
  q.add(y, edge.n, edge.n.dot(y - corner), kPierceBase + edge_number(edge.axis, edge.n));
}

}  // namespace

void box_capsule(const Placed<Box>& box, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const Vec3& h = box.shape.half;
  const Vec3 centre = box.R.transpose() * (capsule.c - box.c), u = box.R.transpose() * capsule.R.col(1);
  const Vec3 half = 0.5 * capsule.shape.length * u;
  const Query q{box, capsule, {centre - half, 2 * half}, u, reach, out};

  int face = 0;
  const double face_separation = (centre.cwiseAbs() - half.cwiseAbs() - h).maxCoeff(&face);
  if (!(face_separation - capsule.shape.radius < reach)) return;
  const double face_sign = sign_of(centre[face]);

  const double t = nearest_to_box(q.segment, h);
  const Vec3 x = q.segment.at(t);
  const double distance = (x - x.cwiseMax(-h).cwiseMin(h)).norm();
  if (distance > 1e-9 * h.minCoeff()) {
    if (!(distance - capsule.shape.radius < reach)) return;
    const double d = distance - capsule.shape.radius, slack = preference(d, h.minCoeff());
    const bool nearly_over = distance - face_separation <= preference(distance, h.minCoeff());
    const double by_face = nearly_over ? add_face(q, face, face_sign, false) : kNone;
    if (by_face > d + slack) add_nearest(q, t);
    return;
  }
  const EdgeAxis edge = best_edge(q.segment, h);
  const double bound = face_separation + preference(face_separation, h.minCoeff());
  if (!(edge.separation > bound)) {
    const double by_face = add_face(q, face, face_sign, true);
    if (by_face <= bound - capsule.shape.radius || !(edge.separation > face_separation)) return;
  }
  add_pierced_edge(q, edge);
}

}  // namespace pabd::narrow
