// SPDX-License-Identifier: MIT
// Hull against hull or box: separating directions, then a face manifold, an edge pair, or a corner, in the
// same order and with the same preferences as box_box.
//
// The directions that can separate two convex polyhedra are the face normals of both and the products of two
// edges, and of those only the pairs whose arcs cross on the Gauss map: an edge of a is the arc between the
// normals of its two faces, an edge of b the arc between the opposite normals. The largest separation s
// (negative inside) tells how the two meet.
//
//   all in the frame of a;   e, g  edges of a and b     m
//   A, B normals of the faces beside e; C, D opposite normals of the faces beside g     unit
#include "sim/collision/hull_face.h"
#include "sim/collision/pair_text.h"

namespace pabd::narrow {
namespace {

using text::SideBySide;

constexpr double kParallelSine2 = 1e-8;  // parallel edges: a face direction says the same
constexpr double kLowest = -std::numeric_limits<double>::infinity();

struct Side {
  const HullView& view;
  const Vec3& c;
  const Mat3& R;
  Index number;
};

struct Meeting {
  const Side &a, &b;
  const HullView& b_in_a;
  Mat3 C;  // R_aᵀ R_b
  Vec3 t;  // R_aᵀ (c_b − c_a)
  double reach;
  Contacts& out;
};

struct BestFace {
  double separation = kLowest;
  int face = -1;
};

struct BestEdge {
  double separation = kLowest;
  int e = -1, g = -1;
  Vec3 n;  // unit, from a towards b
};

// Stops as soon as a direction separates by `reach`.
BestFace best_face(const HullView& owner, const HullView& other, double reach) {
  BestFace best;
  for (std::size_t f = 0; f < owner.faces.size(); ++f) {
    const Vec3& n = owner.faces[f].normal;
    double lowest = kNone;
    for (const Vec3& v : other.vertices) lowest = std::min(lowest, n.dot(v));
    const double s = lowest - owner.faces[f].offset;
    if (s > best.separation) best = {s, static_cast<int>(f)};
    if (s >= reach) break;
  }
  return best;
}

// Whether an edge of a through p separates by no more than `s`, whatever the edge of b: along a normal n between A and B a
// ends at p, and b reaches at least as low as the ball inside it, around c_b. A little less of the ball, for rounding.
bool separates_less(const Vec3& p, const Vec3& A, const Vec3& B, const Vec3& c_b, double inner_b, double s) {
  const double room = s + 0.99 * inner_b, most = std::max(A.dot(c_b - p), B.dot(c_b - p));
  if (most <= 0) return most <= room;
  return room > 0 &&
         most * most <= room * room * (1 + A.dot(B)) / 2;  // n is longer: by the cosine of half the arc
}

BestEdge best_edge(const HullView& a, const HullView& b, const Vec3& c_b, double above, double reach) {
  BestEdge best;
  best.separation = above;
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    const HullEdge& edge_a = a.edges[i];
    const Vec3 &p = a.vertices[edge_a.from], e = a.vertices[edge_a.to] - p;
    const Vec3 &A = a.faces[edge_a.left].normal, &B = a.faces[edge_a.right].normal;
    if (separates_less(p, A, B, c_b, b.inner_radius, best.separation)) continue;
    for (std::size_t j = 0; j < b.edges.size(); ++j) {
      const HullEdge& edge_b = b.edges[j];
      // e runs along A × B and g along C × D: their signs say on which side of an arc a normal lies.
      const Vec3 &C = b.faces[edge_b.left].normal, &D = b.faces[edge_b.right].normal;  // opposite, see below
      const double C_e = -C.dot(e), D_e = -D.dot(e);
      if (C_e * D_e >= 0) continue;
      const Vec3 &q = b.vertices[edge_b.from], g = b.vertices[edge_b.to] - q;
      const double A_g = A.dot(g), B_g = B.dot(g);
      if (A_g * B_g >= 0 || C_e * B_g <= 0) continue;
      Vec3 n = e.cross(g);
      const double sine2 = n.squaredNorm() / (e.squaredNorm() * g.squaredNorm());
      if (!(sine2 > kParallelSine2)) continue;
      n.normalize();
      if (n.dot(p) < 0) n = -n;  // the centre of a, its origin, lies below every one of its edges
      const double s = n.dot(q - p);
      if (s > best.separation) best = {s, static_cast<int>(i), static_cast<int>(j), n};
      if (s >= reach) return best;
    }
  }
  return best;
}

SideBySide::EdgeLine edge_line(const HullView& hull, const HullEdge& edge) {
  const Vec3 &from = hull.vertices[edge.from], &to = hull.vertices[edge.to];
  const double length = (to - from).norm();
  const Vec3 u = (to - from) / length;
  const Vec3 &A = hull.faces[edge.left].normal, &B = hull.faces[edge.right].normal;
  return {Vec3(0.5 * (from + to)), u, 0.5 * length, Vec3(A.cross(u)), Vec3(u.cross(B))};
}

std::uint32_t edge_name(std::size_t e, std::size_t g, unsigned where) {
  constexpr HullFeature kKind[] = {HullFeature::edge_pair, HullFeature::low_end, HullFeature::high_end};
  return hull_feature(kKind[where], 0, e << 10 | g);
}

// Contacts along two edges that run side by side no farther apart than `nearest`. False when there are none.
bool add_side_contacts(const Meeting& m, std::size_t e, std::size_t g, double nearest) {
  SideBySide sides;
  const double smallest = std::min(m.a.view.inner_radius, m.b.view.inner_radius);
  const SideBySide::EdgeLine on_a = edge_line(m.a.view, m.a.view.edges[e]),
                             on_b = edge_line(m.b_in_a, m.b_in_a.edges[g]);
  const int count = sides.side_by_side(on_a, on_b, 0.5 * preference(nearest, smallest), 0);
  double lowest = kNone;
  for (int k = 0; k < count; ++k) lowest = std::min(lowest, sides.side_place(on_a, on_b, k).apart);
  if (!(lowest <= nearest + preference(nearest, smallest))) return false;
  for (int k = 0; k < count; ++k) {
    const SideBySide::SidePlace p = sides.side_place(on_a, on_b, k);
    if (p.apart < m.reach)
      add_contact(m.out, m.a.number, m.b.number, m.a.c + m.a.R * Vec3(p.y), m.a.R * Vec3(p.n), p.apart,
                  edge_name(e, g, static_cast<unsigned>(p.where)));
  }
  return true;
}

// Nearest points of the two edges. False when they lie beyond the ends of an edge.
bool add_edge_contact(const Meeting& m, const BestEdge& best) {
  const HullEdge& edge_a = m.a.view.edges[static_cast<std::size_t>(best.e)];
  const HullEdge& edge_b = m.b_in_a.edges[static_cast<std::size_t>(best.g)];
  const Vec3 &p = m.a.view.vertices[edge_a.from], &q = m.b_in_a.vertices[edge_b.from];
  const Vec3 u = m.a.view.vertices[edge_a.to] - p, v = m.b_in_a.vertices[edge_b.to] - q, w = q - p;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;
  const double on_a = (uw * vv - uv * vw) / det, on_b = (uv * uw - uu * vw) / det;
  constexpr double kEnd = 1e-9;
  if (!(on_a >= -kEnd && on_a <= 1 + kEnd && on_b >= -kEnd && on_b <= 1 + kEnd)) return false;
  const double d = w.dot(best.n);
  const auto e = static_cast<std::size_t>(best.e), g = static_cast<std::size_t>(best.g);
  if (d > 0 && add_side_contacts(m, e, g, d)) return true;
  if (d < m.reach) {
    add_contact(m.out, m.a.number, m.b.number, m.a.c + m.a.R * (q + on_b * v), m.a.R * best.n, d,
                edge_name(e, g, SideBySide::SIDE_NEAREST));
  }
  return true;
}

struct NearestCorner {
  double distance = kNone;
  Vec3 corner, foot;
  std::size_t number = 0;
};

// Vertex of `other` nearest to `hull`, both in one frame, if nearer than `limit`.
NearestCorner nearest_corner(const HullView& hull, const HullView& other, double limit) {
  NearestCorner best;
  for (std::size_t v = 0; v < other.vertices.size(); ++v) {
    const Vec3& x = other.vertices[v];
    Vec3 foot = x;
    const double distance = nearest_point(hull, x, std::min(limit, best.distance), foot);
    if (distance < std::min(limit, best.distance)) best = {distance, x, foot, v};
  }
  return best;
}

// Along an edge through that corner which runs side by side with an edge of the other hull.
bool add_side_contacts_at(const Meeting& m, bool corner_of_b, std::size_t corner, double nearest) {
  const HullView &own = corner_of_b ? m.b_in_a : m.a.view, &other = corner_of_b ? m.a.view : m.b_in_a;
  for (std::size_t e = 0; e < own.edges.size(); ++e) {
    const HullEdge& edge = own.edges[e];
    if (edge.from != corner && edge.to != corner) continue;
    const Vec3 u = own.vertices[edge.to] - own.vertices[edge.from];
    for (std::size_t g = 0; g < other.edges.size(); ++g) {
      const Vec3 v = other.vertices[other.edges[g].to] - other.vertices[other.edges[g].from];
      const double uv = u.dot(v), uu_vv = u.squaredNorm() * v.squaredNorm();
      if (uv * uv < (1 - SideBySide::ALONG_SINE * SideBySide::ALONG_SINE) * uu_vv) continue;
      if (add_side_contacts(m, corner_of_b ? g : e, corner_of_b ? e : g, nearest)) return true;
    }
  }
  return false;
}

// Contacts of that face of a or b. The face of the other hull that looks most nearly against it is taken, but
// where that has not got the lowest corner and is above `bound`, one that has.
double add_face(const Meeting& m, bool b_owns, const BestFace& best, double bound) {
  const auto add = [&](const HullView& reference, const HullView& incident, const Side& owner, Index other) {
    const HullFaceQuery query{reference, incident, owner.c, owner.R, owner.number, other};
    const std::size_t start = m.out.size();
    const Vec3& n = reference.faces[static_cast<std::size_t>(best.face)].normal;
    const int first = facing(incident, n);
    const double d = add_hull_face(query, best.face, first, m.reach, m.out);
    if (d <= bound) return d;
    const int second = facing_with_lowest(incident, n);
    if (second == first) return d;
    const std::size_t middle = m.out.size();
    const double d_second = add_hull_face(query, best.face, second, m.reach, m.out);
    if (d_second < d) {
      replace(m.out, start, middle);
    } else {
      m.out.resize(middle);
    }
    return std::min(d, d_second);
  };
  if (!b_owns) return add(m.a.view, m.b_in_a, m.a, m.b.number);
  const MovedHull a_in_b(m.a.view, m.C.transpose(), -(m.C.transpose() * m.t));
  return add(m.b.view, a_in_b.view, m.b, m.a.number);
}

struct NearestPoints {
  NearestCorner at;
  bool corner_of_b;
};

NearestPoints nearest_points(const Meeting& m, double limit) {
  const NearestCorner on_b = nearest_corner(m.a.view, m.b_in_a, limit);
  const NearestCorner on_a = nearest_corner(m.b_in_a, m.a.view, std::min(limit, on_b.distance));
  const bool corner_of_b = on_b.distance <= on_a.distance * (1 + 1e-9);  // two corners: that of b
  return {corner_of_b ? on_b : on_a, corner_of_b};
}

void add_corner_contact(const Meeting& m, const NearestPoints& c) {
  const Side &owner = c.corner_of_b ? m.a : m.b, &other = c.corner_of_b ? m.b : m.a;
  add_contact(m.out, owner.number, other.number, m.a.c + m.a.R * c.at.corner,
              m.a.R * ((c.at.corner - c.at.foot) / c.at.distance), c.at.distance,
              hull_feature(HullFeature::corner, 0, (c.corner_of_b ? 1024u : 0u) | c.at.number));
}

// The hulls are apart, nearer than `limit`, and the chosen face does not say how far: the nearest points are a
// corner of one and its foot on the other, or lie within the edges of `edge`, which then has the largest
// separation there is. If the other hull's face, `rival`, with what separates says it, it is a face contact
// after all; if edges run side by side there, contacts along them. Either says all there is to say and replaces
// what the chosen face said from `start` on.
void add_apart(const Meeting& m, double limit, bool b_owns, const BestFace& rival, const BestEdge& edge,
               std::size_t start) {
  const NearestPoints c = nearest_points(m, limit);
  const double smallest = std::min(m.a.view.inner_radius, m.b_in_a.inner_radius);
  const std::size_t faces = m.out.size();
  const double bound = rival.separation + preference(rival.separation, smallest);
  if (c.corner_of_b == b_owns && c.at.distance < limit && c.at.distance <= bound) {
    if (add_face(m, !b_owns, rival, kNone) <= bound) return replace(m.out, start, faces);
    m.out.resize(faces);
  }
  if (edge.g >= 0 && edge.separation < c.at.distance - 1e-9 * smallest && add_edge_contact(m, edge)) {
    if (m.out.size() > faces + 1) replace(m.out, start, faces);
    return;
  }
  if (!(c.at.distance < limit) || !(c.at.distance > 1e-12 * smallest)) return;
  if (add_side_contacts_at(m, c.corner_of_b, c.at.number, c.at.distance)) return replace(m.out, start, faces);
  add_corner_contact(m, c);
}

void meet(const Side& a, const Side& b, double reach, Contacts& out) {
  const Mat3 C = a.R.transpose() * b.R;
  const Vec3 t = a.R.transpose() * (b.c - a.c);
  const MovedHull moved(b.view, C, t);
  const Meeting m{a, b, moved.view, C, t, reach, out};

  const BestFace face_a = best_face(a.view, moved.view, reach);
  if (!(face_a.separation < reach)) return;
  const BestFace face_b = best_face(moved.view, a.view, reach);
  if (!(face_b.separation < reach)) return;
  const double smallest = std::min(a.view.inner_radius, b.view.inner_radius);
  const bool b_owns = face_b.separation > face_a.separation + preference(face_a.separation, smallest);
  const double face = b_owns ? face_b.separation : face_a.separation;

  BestEdge edge = best_edge(a.view, moved.view, t, face, reach);
  if (!(edge.separation < reach)) return;
  const double bound = face + preference(face, smallest);
  const bool clearly_edge = edge.separation > bound, apart = edge.separation > 0;
  const BestFace& best = b_owns ? face_b : face_a;
  const auto faces_of_best = b_owns ? moved.view.faces : a.view.faces;
  const bool flat =
      edge.g >= 0 && is_nearly_along(edge.n, faces_of_best[static_cast<std::size_t>(best.face)].normal);
  const std::size_t start = out.size();
  if (clearly_edge) {
    if (flat && is_nearly(add_face(m, b_owns, best, kNone), edge.separation, smallest)) return;
    out.resize(start);
    if (add_edge_contact(m, edge)) return;
    edge.g = -1;  // its places are beyond the ends
  }
  // Of hulls that are apart, though not across a face, what is below one lies beyond the hull.
  const bool beyond = clearly_edge && apart && face <= 0;
  const double d = beyond ? kNone : add_face(m, b_owns, best, apart ? kNone : bound);
  if (d <= bound || (flat && is_nearly(d, edge.separation, smallest))) return;
  // The deepest or nearest part is not over that face.
  const BestFace& rival = b_owns ? face_a : face_b;
  if (apart) return add_apart(m, std::min(d, reach), b_owns, rival, edge, start);
  if (edge.g >= 0 && add_edge_contact(m, edge)) return;
  if (d < kNone && !(rival.separation > face)) return;
  const std::size_t middle = m.out.size();
  const double rival_bound = rival.separation + preference(rival.separation, smallest);
  if (add_face(m, !b_owns, rival, rival_bound) < d) {
    replace(m.out, start, middle);
  } else {
    m.out.resize(middle);
  }
}

}  // namespace

void hull_hull(const Placed<Hull>& a, const Placed<Hull>& b, double reach, Contacts& out) {
  const HullView view_a = view_of(*a.shape.data), view_b = view_of(*b.shape.data);
  meet({view_a, a.c, a.R, a.number}, {view_b, b.c, b.R, b.number}, reach, out);
}

void hull_box(const Placed<Hull>& hull, const Placed<Box>& box, double reach, Contacts& out) {
  const BoxHull storage(box.shape.half);
  const HullView view = view_of(*hull.shape.data), box_view = storage.view();
  const Side first{view, hull.c, hull.R, hull.number}, second{box_view, box.c, box.R, box.number};
  if (hull.first) {
    meet(first, second, reach, out);
  } else {
    meet(second, first, reach, out);
  }
}

}  // namespace pabd::narrow
