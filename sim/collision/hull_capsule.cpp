// SPDX-License-Identifier: MIT
// Capsule against hull or box, in the frame of the hull, which owns the normal.
//
// The capsule is its axis, the segment x(t) = p + t e, t ∈ [0, 1], swollen by its radius. Three cases, in this order:
//   face    the segment lies over a face (or so nearly that the face is as good as any other normal): the part over
//           the face, two contacts
//   apart   the segment is outside: its nearest point to the hull, one contact (more along an edge: side_by_side)
//   edge    the segment pierces the hull and the shortest way out is across an edge
//
//   u   direction of the segment                                                unit
//   s   separation of the segment from the hull along a direction, negative inside    m
#include "sim/collision/hull_view.h"
#include "sim/collision/narrow_phase.h"
#include "sim/collision/side_by_side.h"

namespace pabd::narrow {
namespace {

// Bases of the features; faces and edges are numbered from them.
constexpr std::uint32_t kFace = 0, kNearest = 4096, kPierced = 8192, kEdgeLine = 16384;

struct Query {
  const HullView& view;
  const Vec3& c;  // pose and number of the hull
  const Mat3& R;
  Index number;
  const Placed<Capsule>& capsule;
  Vec3 p, e, u;  // in the frame of the hull
  double radius, reach;
  Contacts& out;

  Vec3 at(double t) const { return p + t * e; }
  const Vec3& from(const HullEdge& edge) const { return view.vertices[edge.from]; }
  const Vec3& to(const HullEdge& edge) const { return view.vertices[edge.to]; }
  // y and n in the frame of the hull.
  void add(const Vec3& y, const Vec3& n, double d, std::uint32_t feature) const {
    if (d < reach) add_contact(out, number, capsule.number, c + R * y, R * n, d, feature);
  }
};

// Cuts [low, high] to where m·(x + t e) ≤ bound.
bool cut(const Vec3& m, double bound, const Vec3& x, const Vec3& e, double& low, double& high) {
  const double start = m.dot(x) - bound, slope = m.dot(e);
  if (!(std::abs(slope) > 1e-14 * e.norm())) return start <= 0;
  const double t = -start / slope;
  if (slope > 0) {
    high = std::min(high, t);
  } else {
    low = std::max(low, t);
  }
  return low <= high;
}

// The part of the line x + t e, t ∈ [0, 1], over a face.
bool clip_to_face(const HullView& view, const HullFace& face, const Vec3& x, const Vec3& e, double& low,
                  double& high) {
  low = 0;
  high = 1;
  for (std::size_t k = 0; k < face.count; ++k) {
    const Vec3& a = view.vertices[view.loop[face.first + k]];
    const Vec3& b = view.vertices[view.loop[face.first + (k + 1) % face.count]];
    const Vec3 m = (b - a).cross(face.normal).normalized();
    if (!cut(m, m.dot(a), x, e, low, high)) return false;
  }
  return true;
}

bool pierces(const Query& q) {
  double low = 0, high = 1;
  for (const HullFace& face : q.view.faces) {
    if (!cut(face.normal, face.offset, q.p, q.e, low, high)) return false;
  }
  return true;
}

// Both ends of the part of the capsule that lies over a face. Returns the smallest d of the two, in reach or
// not; kNone when nothing lies over the face. The lower end is the bottom of its cap, if that is over the
// face. Everything else touches along the side of the cylinder, one radius off the axis: that line is clipped, or,
// when the segment pierces the hull, the segment itself, which is sure to leave something.
double add_face(const Query& q, int number, bool through) {
  const HullFace& face = q.view.faces[static_cast<std::size_t>(number)];
  const Vec3& n = face.normal;
  const double slope = n.dot(q.u);
  double lowest = kNone;
  const auto add = [&](const Vec3& y, std::uint32_t end) {
    const double d = n.dot(y) - face.offset;
    lowest = std::min(lowest, d);
    q.add(y, n, d, kFace + 2 * static_cast<std::uint32_t>(number) + end);
  };
  double low, high;
  int done = -1;
  if (slope != 0) {
    const int low_end = slope > 0 ? 0 : 1;
    const Vec3 x = q.at(low_end);
    if (clip_to_face(q.view, face, x, Vec3::Zero(), low, high)) {
      add(x - q.radius * n, static_cast<std::uint32_t>(low_end));
      done = low_end;
    }
  }
  const Vec3 side = n - slope * q.u;
  if (!(side.norm() > 1e-6)) return lowest;
  const Vec3 x = q.p - q.radius * side.normalized();
  const bool touches = clip_to_face(q.view, face, x, q.e, low, high);
  if (!touches && !(through && done < 0 && clip_to_face(q.view, face, q.p, q.e, low, high))) return lowest;
  if (done != 0) add(x + low * q.e, 0);
  if (done != 1 && (high > low || done == 0)) add(x + high * q.e, 1);
  return lowest;
}

struct Nearest {
  double distance = kNone, t = 0;
  Vec3 foot = Vec3::Zero();
};

// Nearest points of the segment and an edge, both of some length.
void try_edge(const Query& q, int number, Nearest& best) {
  const HullEdge& edge = q.view.edges[static_cast<std::size_t>(number)];
  const Vec3 &a = q.from(edge), g = q.to(edge) - a, w = q.p - a;
  const double ee = q.e.squaredNorm(), gg = g.squaredNorm(), eg = q.e.dot(g), ew = q.e.dot(w), gw = g.dot(w);
  const double det = ee * gg - eg * eg;
  double t = det > 1e-14 * ee * gg ? std::clamp((eg * gw - ew * gg) / det, 0.0, 1.0) : 0.0;
  double s = std::clamp((gw + t * eg) / gg, 0.0, 1.0);
  t = std::clamp((s * eg - ew) / ee, 0.0, 1.0);
  const Vec3 foot = a + s * g;
  const double distance = (q.at(t) - foot).norm();
  if (distance < best.distance) best = {distance, t, foot};
}

// The segment is outside.
Nearest nearest_to(const Query& q) {
  Nearest best;
  for (std::size_t k = 0; k < q.view.edges.size(); ++k) try_edge(q, static_cast<int>(k), best);
  for (const double t : {0.0, 1.0}) {
    Vec3 foot = q.at(t);
    const double distance = nearest_point(q.view, q.at(t), best.distance, foot);
    if (distance < best.distance) best = {distance, t, foot};
  }
  return best;
}

// Where the segment runs side by side with the edge. False where it does not, or not where it is nearest.
bool add_along_edge(const Query& q, int number, double distance) {
  const HullEdge& edge = q.view.edges[static_cast<std::size_t>(number)];
  const Vec3 &a = q.from(edge), &b = q.to(edge);
  const double length = (b - a).norm();
  const Vec3 u = (b - a) / length;
  const Vec3 &A = q.view.faces[edge.left].normal, &B = q.view.faces[edge.right].normal;
  const EdgeLine line{0.5 * (a + b), u, 0.5 * length, {A.cross(u), u.cross(B)}};
  const EdgeLine segment{q.at(0.5), q.u, 0.5 * q.capsule.shape.length};
  SidePlace place[3];
  const double nearest = distance - q.radius, slack = preference(nearest, q.view.inner_radius);
  const int count = side_by_side(line, segment, 0.5 * slack, 0, place);
  double d[3], lowest = kNone;
  for (int k = 0; k < count; ++k) {
    d[k] = distance_to_capsule(place[k], segment, q.radius);
    lowest = std::min(lowest, d[k]);
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int k = 0; k < count; ++k) {
    const SidePlace& p = place[k];
    constexpr std::uint32_t kFeature[] = {2, 0, 1};
    q.add(p.y - (p.distance - d[k]) * p.n, p.n, d[k],
          kEdgeLine + 4 * static_cast<std::uint32_t>(number) + kFeature[p.where]);
  }
  return true;
}

// The nearest point may be a corner, and the edge to follow any that meets there.
bool add_along_edges(const Query& q, const Nearest& nearest) {
  const double same = 1e-9 * q.view.inner_radius;
  for (std::size_t k = 0; k < q.view.edges.size(); ++k) {
    const Vec3 &a = q.from(q.view.edges[k]), g = q.to(q.view.edges[k]) - a;
    if (!runs_along(g.normalized(), q.u)) continue;
    const double s = std::clamp(g.dot(nearest.foot - a) / g.squaredNorm(), 0.0, 1.0);
    if ((a + s * g - nearest.foot).norm() > same) continue;
    if (add_along_edge(q, static_cast<int>(k), nearest.distance)) return true;
  }
  return false;
}

void add_nearest(const Query& q, const Nearest& nearest) {
  if (add_along_edges(q, nearest)) return;
  const Vec3 n = (q.at(nearest.t) - nearest.foot) / nearest.distance;
  const std::uint32_t end = nearest.t <= 0 ? 0u : nearest.t >= 1 ? 1u : 2u;
  q.add(q.at(nearest.t) - q.radius * n, n, nearest.distance - q.radius, kNearest + end);
}

struct EdgeAxis {
  double separation = -std::numeric_limits<double>::infinity();
  int edge = -1;
  Vec3 n;  // unit, outward
};

// Best separating direction among (edge of the hull) × (segment): only those that lie on the edge's arc of
// the Gauss map, between the normals of its faces, have the edge as their outermost part.
EdgeAxis best_edge(const Query& q) {
  EdgeAxis best;
  for (std::size_t k = 0; k < q.view.edges.size(); ++k) {
    const HullEdge& edge = q.view.edges[k];
    const Vec3& a = q.from(edge);
    const Vec3 g = q.to(edge) - a;
    Vec3 n = g.cross(q.u);
    const double size = n.norm();
    if (!(size > 1e-4 * g.norm())) continue;  // parallel: a face direction says the same
    n /= n.dot(a) < 0 ? -size : size;
    const Vec3 &A = q.view.faces[edge.left].normal, &B = q.view.faces[edge.right].normal;
    if (A.cross(n).dot(g) < 0 || n.cross(B).dot(g) < 0) continue;
    const double separation = n.dot(q.p - a);
    if (separation > best.separation) best = {separation, static_cast<int>(k), n};
  }
  return best;
}

void add_pierced_edge(const Query& q, const EdgeAxis& axis) {
  const HullEdge& edge = q.view.edges[static_cast<std::size_t>(axis.edge)];
  const Vec3& a = q.from(edge);
  const Vec3 g = (q.to(edge) - a).normalized();
  // Nearest point of the segment to the line of the edge: only the components across the edge count.
  const Vec3 across = q.e - q.e.dot(g) * g, offset = (a - q.p) - (a - q.p).dot(g) * g;
  const double t = std::clamp(offset.dot(across) / across.squaredNorm(), 0.0, 1.0);
  const Vec3 y = q.at(t) - q.radius * axis.n;
  q.add(y, axis.n, axis.n.dot(y - a), kPierced + static_cast<std::uint32_t>(axis.edge));
}

void add_capsule_contacts(const HullView& view, const Vec3& c, const Mat3& R, Index number,
                          const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const Vec3 centre = R.transpose() * (capsule.c - c), u = R.transpose() * capsule.R.col(1);
  const Vec3 half = 0.5 * capsule.shape.length * u;
  const double radius = capsule.shape.radius;
  const Query q{view, c, R, number, capsule, centre - half, 2 * half, u, radius, reach, out};

  int face = 0;
  double by_face = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < q.view.faces.size(); ++f) {
    const Vec3& n = q.view.faces[f].normal;
    const double s = n.dot(centre) - std::abs(n.dot(half)) - q.view.faces[f].offset;
    if (s > by_face) {
      by_face = s;
      face = static_cast<int>(f);
    }
  }
  if (!(by_face - radius < reach)) return;

  const double size = q.view.inner_radius;
  if (!pierces(q)) {
    const Nearest nearest = nearest_to(q);
    if (nearest.distance > kOnSurface * size) {
      const double d = nearest.distance - radius;
      if (!(d < reach)) return;
      const double slack = preference(d, size);
      const double lowest = nearest.distance - by_face <= slack ? add_face(q, face, false) : kNone;
      if (lowest > d + slack) add_nearest(q, nearest);
      return;
    }
  }
  const EdgeAxis edge = best_edge(q);
  const double bound = by_face + preference(by_face, size);
  if (!(edge.separation > bound)) {
    const double lowest = add_face(q, face, true);
    if (lowest <= bound - radius || !(edge.separation > by_face)) return;
  }
  add_pierced_edge(q, edge);
}

}  // namespace

void hull_capsule(const Placed<Hull>& hull, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  add_capsule_contacts(view_of(*hull.shape.data), hull.c, hull.R, hull.number, capsule, reach, out);
}

void box_capsule(const Placed<Box>& box, const Placed<Capsule>& capsule, double reach, Contacts& out) {
  const BoxHull storage(box.shape.half);
  add_capsule_contacts(storage.view(), box.c, box.R, box.number, capsule, reach, out);
}

}  // namespace pabd::narrow
