// SPDX-License-Identifier: MIT
// Box against box: separating axes, then a face manifold, an edge pair, or a corner.
//
// Fifteen directions can separate two boxes: three face normals each and nine products of edges. The largest
// separation s (negative inside) tells how they meet:
//   face    the incident face clipped against the reference face (box_box_face); preferred to the rest, and
//           the first body's face to the other's, unless clearly worse (see `preference`)
//   edge    the nearest points of the two edges; along edges that run side by side, at both ends
//           (side_by_side). Not where faces are nearly flat on each other and come as near: they would
//           have one point in a step and four in the next
//   corner  apart: the corner of one box nearest to the other box, or the edges through it where they run
//           side by side
// The nearest or deepest place of the preferred face may lie beside it, as that face is not quite the best;
// what then is best, another face, an edge pair or a corner, is sure to have it.
//
//   C = R_aᵀ R_b, t = R_aᵀ (c_b − c_a), all in the frame of a;   h, g  half edges of a and b (m)
#include "sim/collision/box_box_face.h"
#include "sim/collision/pair_text.h"

namespace pabd::narrow {
namespace {

using text::SideBySide;

constexpr std::uint32_t kEdgeFeature = 1u << 16, kCornerFeature = 1u << 17;

struct Relative {
  double C[3][3], Q[3][3];  // Q = |C|
  double t[3], s[3];        // the offset of the centres in the frames of a and b
};

Relative relative_pose(const Placed<Box>& a, const Placed<Box>& b) {
  Relative r;
  const Vec3 offset = b.c - a.c;
  for (int i = 0; i < 3; ++i) {
    r.t[i] = a.R.col(i).dot(offset);
    r.s[i] = b.R.col(i).dot(offset);
    for (int j = 0; j < 3; ++j) {
      r.C[i][j] = a.R.col(i).dot(b.R.col(j));
      r.Q[i][j] = std::abs(r.C[i][j]);
    }
  }
  return r;
}

struct Best {
  double separation = -1e300;
  int i = -1, j = -1;  // face: axis i; edge: axis i of a, axis j of b
};

// Edge along axis i of a and edge along axis j of b that n, from a to b, looks at; in the frame of a.
struct EdgePair {
  SideBySide::EdgeLine on_a, on_b;
  std::uint32_t name;
};

EdgePair edges_towards(const Placed<Box>& a, const Placed<Box>& b, const Relative& r, int i, int j,
                       const Vec3& n) {
  const Vec3 &h = a.shape.half, &g = b.shape.half;
  const auto axis_of_b = [&](int k) { return Vec3(r.C[0][k], r.C[1][k], r.C[2][k]); };
  Vec3 middle_a = Vec3::Zero(), middle_b(r.t[0], r.t[1], r.t[2]), into_a[2], into_b[2];
  std::uint32_t id_a = static_cast<std::uint32_t>(4 * i), id_b = static_cast<std::uint32_t>(4 * j);
  for (std::uint32_t bit = 1, k = 1; k <= 2; ++k, bit <<= 1) {
    const int ka = (i + static_cast<int>(k)) % 3, kb = (j + static_cast<int>(k)) % 3;
    const Vec3 w = axis_of_b(kb);
    const double sign_a = sign_of(n[ka]), sign_b = -sign_of(n.dot(w));
    middle_a[ka] = sign_a * h[ka];
    middle_b += sign_b * g[kb] * w;
    into_a[k - 1] = -sign_a * Vec3::Unit(ka);
    into_b[k - 1] = -sign_b * w;
    if (sign_a < 0) id_a |= bit;
    if (sign_b < 0) id_b |= bit;
  }
  return {{middle_a, Vec3(Vec3::Unit(i)), h[i], into_a[0], into_a[1]},
          {middle_b, axis_of_b(j), g[j], into_b[0], into_b[1]},
          kEdgeFeature | id_a << 4 | id_b};
}

// Contacts along two edges that run side by side no farther apart than `nearest`. False when there are none.
bool add_side_contacts(const Placed<Box>& a, const Placed<Box>& b, const EdgePair& pair, double nearest,
                       double reach, Contacts& out) {
  SideBySide sides;
  const double smallest = std::min(a.shape.half.minCoeff(), b.shape.half.minCoeff());
  const int count = sides.side_by_side(pair.on_a, pair.on_b, 0.5 * preference(nearest, smallest), 0);
  double lowest = kNone;
  for (int k = 0; k < count; ++k) lowest = std::min(lowest, sides.side_place(pair.on_a, pair.on_b, k).apart);
  if (!(lowest <= nearest + preference(nearest, smallest))) return false;
  for (int k = 0; k < count; ++k) {
    const SideBySide::SidePlace p = sides.side_place(pair.on_a, pair.on_b, k);
    if (p.apart < reach)
      add_contact(out, a.number, b.number, a.c + a.R * Vec3(p.y), a.R * Vec3(p.n), p.apart,
                  pair.name | static_cast<std::uint32_t>(p.where) << 8);
  }
  return true;
}

// Is what separates the edges nearly the normal of that face, of a or of b?
bool is_nearly_flat(const Relative& r, const Best& edge, bool of_b, const Best& face) {
  const auto axis_of_b = [&](int k) { return Vec3(r.C[0][k], r.C[1][k], r.C[2][k]); };
  const Vec3 n = Vec3::Unit(edge.i).cross(axis_of_b(edge.j));
  return is_nearly_along(n, of_b ? axis_of_b(face.i) : Vec3(Vec3::Unit(face.i)));
}

// Nearest points of the two edges, in the frame of a. False when they lie beyond the ends of an edge.
bool add_edge_contact(const Placed<Box>& a, const Placed<Box>& b, const Relative& r, const Best& best,
                      double reach, Contacts& out) {
  const int i = best.i, j = best.j;
  const Vec3 t(r.t[0], r.t[1], r.t[2]);
  Vec3 n = Vec3::Unit(i).cross(Vec3(r.C[0][j], r.C[1][j], r.C[2][j]));
  const double sine2 = n.squaredNorm();
  n *= sign_of(n.dot(t)) / std::sqrt(sine2);
  const EdgePair pair = edges_towards(a, b, r, i, j, n);
  const Vec3 p = pair.on_a.middle, q = pair.on_b.middle, v = pair.on_b.direction, w = q - p;
  const double uv = r.C[i][j], uw = w[i], vw = v.dot(w);
  const double on_a = (uw - uv * vw) / sine2, on_b = (uv * uw - vw) / sine2;
  constexpr double kEnd = 1 + 1e-9;
  if (std::abs(on_a) > pair.on_a.half_length * kEnd || std::abs(on_b) > pair.on_b.half_length * kEnd)
    return false;
  const double d = w.dot(n);
  if (d > 0 && add_side_contacts(a, b, pair, d, reach, out)) return true;
  if (d < reach) add_contact(out, a.number, b.number, a.c + a.R * (q + on_b * v), a.R * n, d, pair.name);
  return true;
}

struct NearestCorner {
  double distance2 = 1e300;
  Vec3 corner, foot;  // in the frame of the box that has the foot
  std::uint32_t number = 0;
};

// Corner of `other` nearest to `box`.
NearestCorner nearest_corner(const Placed<Box>& box, const Placed<Box>& other) {
  NearestCorner best;
  const Vec3 &h = box.shape.half, &g = other.shape.half;
  const Vec3 t = box.R.transpose() * (other.c - box.c);
  const Mat3 C = box.R.transpose() * other.R;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Vec3 x = t + C * g.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    const Vec3 foot = x.cwiseMax(-h).cwiseMin(h);
    const double distance2 = (x - foot).squaredNorm();
    if (distance2 < best.distance2) best = {distance2, x, foot, k};
  }
  return best;
}

FaceQuery seen_from_a(const Placed<Box>& a, const Placed<Box>& b, const Relative& r) {
  FaceQuery q{a, b, {}, {}, 0};
  for (int i = 0; i < 3; ++i) {
    q.t[i] = r.t[i];
    for (int j = 0; j < 3; ++j) q.C[i][j] = r.C[i][j];
  }
  return q;
}

FaceQuery seen_from_b(const Placed<Box>& a, const Placed<Box>& b, const Relative& r) {
  FaceQuery q{b, a, {}, {}, 1};
  for (int i = 0; i < 3; ++i) {
    q.t[i] = -r.s[i];
    for (int j = 0; j < 3; ++j) q.C[i][j] = r.C[j][i];
  }
  return q;
}

// Contacts of the face that separates best, of a or of b.
double add_face(const Placed<Box>& a, const Placed<Box>& b, const Relative& r, bool of_b, const Best& face,
                double reach, Contacts& out) {
  return add_face_contacts(of_b ? seen_from_b(a, b, r) : seen_from_a(a, b, r), face.i, reach, out);
}

// Along edges through the nearest points that run side by side; n from a to b, in the frame of a.
bool add_parallel_edges(const Placed<Box>& a, const Placed<Box>& b, const Relative& r, const Vec3& n,
                        double d, double reach, Contacts& out) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (1 - r.C[i][j] * r.C[i][j] > SideBySide::ALONG_SINE * SideBySide::ALONG_SINE) continue;
      if (add_side_contacts(a, b, edges_towards(a, b, r, i, j, n), d, reach, out)) return true;
    }
  }
  return false;
}

// What the chosen face says of two boxes that are apart: its smallest d and where its contacts start.
struct ChosenFace {
  bool of_b;
  double d;
  std::size_t start;
};

// The boxes are apart, and the chosen face does not say how far: the nearest points are a corner of one and
// its foot on the other, or lie within the edges of `edge`, which then has the largest separation there is. If
// the other box's face, `rival`, with what separates says it, it is a face contact after all; if edges run side
// by side there, contacts along them. Either says all there is to say and replaces what the chosen face said.
void add_apart(const Placed<Box>& a, const Placed<Box>& b, const Relative& r, const ChosenFace& chosen,
               const Best& rival, const Best& edge, double reach, Contacts& out) {
  const NearestCorner on_b = nearest_corner(a, b), on_a = nearest_corner(b, a);
  const bool corner_of_b = on_b.distance2 <= on_a.distance2 * (1 + 1e-9);  // two corners: that of b
  const NearestCorner& c = corner_of_b ? on_b : on_a;
  const double d = std::sqrt(c.distance2);
  const double smallest = std::min(a.shape.half.minCoeff(), b.shape.half.minCoeff());
  const std::size_t faces = out.size();
  const auto replaces_faces = [&] { replace(out, chosen.start, faces); };
  const double bound = rival.separation + preference(rival.separation, smallest);
  if (corner_of_b == chosen.of_b && d < std::min(chosen.d, reach) && d <= bound) {
    if (add_face(a, b, r, !chosen.of_b, rival, reach, out) <= bound) return replaces_faces();
    out.resize(faces);
  }
  if (edge.j >= 0 && edge.separation < d - 1e-9 * smallest && add_edge_contact(a, b, r, edge, reach, out)) {
    if (out.size() > faces + 1) replaces_faces();
    return;
  }
  if (!(d < std::min(chosen.d, reach)) || !(d > 1e-12 * smallest)) return;
  const Placed<Box>&owner = corner_of_b ? a : b, &other = corner_of_b ? b : a;
  const Vec3 n = owner.R * ((c.corner - c.foot) / d);
  const Vec3 from_a = a.R.transpose() * (corner_of_b ? n : Vec3(-n));
  if (add_parallel_edges(a, b, r, from_a, d, reach, out)) return replaces_faces();
  add_contact(out, owner.number, other.number, owner.c + owner.R * c.corner, n, d,
              kCornerFeature | (corner_of_b ? 8u : 0u) | c.number);
}

}  // namespace

void box_box(const Placed<Box>& a, const Placed<Box>& b, double reach, Contacts& out) {
  const double *h = a.shape.half.data(), *g = b.shape.half.data();
  const Relative r = relative_pose(a, b);
  const auto& Q = r.Q;

  Best face_a, face_b, edge;
  for (int i = 0; i < 3; ++i) {
    const double s_a = std::abs(r.t[i]) - h[i] - (Q[i][0] * g[0] + Q[i][1] * g[1] + Q[i][2] * g[2]);
    const double s_b = std::abs(r.s[i]) - g[i] - (Q[0][i] * h[0] + Q[1][i] * h[1] + Q[2][i] * h[2]);
    if (!(s_a < reach) || !(s_b < reach)) return;
    if (s_a > face_a.separation) face_a = {s_a, i, -1};
    if (s_b > face_b.separation) face_b = {s_b, i, -1};
  }

  const double smallest = std::min({h[0], h[1], h[2], g[0], g[1], g[2]});
  const bool b_owns = face_b.separation > face_a.separation + preference(face_a.separation, smallest);
  const double face = b_owns ? face_b.separation : face_a.separation;

  // An edge pair matters only where it separates better than the chosen face; with sine ≤ 1 most are settled
  // without their square root.
  constexpr double kParallelSine2 = 1e-8;  // parallel edges: a face direction says the same
  const double bar = std::min(face, 0.0);
  for (int i = 0; i < 3; ++i) {
    const int i1 = kNext[i], i2 = kNext[i1];
    for (int j = 0; j < 3; ++j) {
      const int j1 = kNext[j], j2 = kNext[j1];
      const double along = std::abs(r.t[i2] * r.C[i1][j] - r.t[i1] * r.C[i2][j]) -
                           (h[i1] * Q[i2][j] + h[i2] * Q[i1][j] + g[j1] * Q[i][j2] + g[j2] * Q[i][j1]);
      if (along <= bar) continue;
      const double sine2 = r.C[i1][j] * r.C[i1][j] + r.C[i2][j] * r.C[i2][j];
      if (sine2 < kParallelSine2) continue;
      const double s = along / std::sqrt(sine2);
      if (!(s < reach)) return;
      if (s > face && s > edge.separation) edge = {s, i, j};
    }
  }
  const double bound = face + preference(face, smallest);
  const bool clearly_edge = edge.separation > bound;
  const bool flat = edge.j >= 0 && is_nearly_flat(r, edge, b_owns, b_owns ? face_b : face_a);
  const auto add_chosen = [&] { return add_face(a, b, r, b_owns, b_owns ? face_b : face_a, reach, out); };
  const std::size_t start = out.size();
  if (clearly_edge) {
    if (flat && is_nearly(add_chosen(), edge.separation, smallest)) return;
    out.resize(start);
    if (add_edge_contact(a, b, r, edge, reach, out)) return;
    edge.j = -1;  // its places are beyond the ends
  }
  // Of boxes that are apart, though not across a face, what is below one lies beyond the box.
  const bool beyond = clearly_edge && edge.separation > 0 && face <= 0;
  const double d = beyond ? kNone : add_chosen();
  if (d <= bound || (flat && is_nearly(d, edge.separation, smallest))) return;
  // The deepest or nearest part is not over that face.
  const Best& rival = b_owns ? face_a : face_b;
  if (std::max(face, edge.separation) > 0)
    return add_apart(a, b, r, {b_owns, d, start}, rival, edge, reach, out);
  if (edge.j >= 0 && add_edge_contact(a, b, r, edge, reach, out)) return;
  if (d < kNone && !(rival.separation > face)) return;
  const std::size_t faces = out.size();
  if (add_face(a, b, r, !b_owns, rival, reach, out) < d) {
    replace(out, start, faces);
  } else {
    out.resize(faces);
  }
}

}  // namespace pabd::narrow
