// SPDX-License-Identifier: MIT
// Face contacts of two boxes.
//
// In the frame of the reference box, with (x, y) the two directions along its face and z the height above it,
// the four corners of the incident face are clipped against |x| ≤ h_x, |y| ≤ h_y. What remains is a convex
// polygon on the incident face; each of its corners is a contact point y_b with d = z.
//
// Features. A corner of the clipped polygon is where two of eight lines meet: the four edges of the incident
// face and the four sides of the reference face. Named so it would change its name, and come and go, when two
// equal faces lie exactly on each other and twist by a rounding error. So a polygon corner close to an
// incident corner takes that corner's name, one close to a reference corner that one's, and one of equal
// names is kept. Where an edge and a side run on into each other at a small angle, their crossing may lie
// anywhere along them, near a corner too; it is left out unless it is the deepest point.
//
//   C, t     incident box in the frame of the reference box        1, m
//   k        axis of the reference face;  k1, k2 the axes along it
//   m        axis of the incident face;   m1, m2 the axes along it
#include "sim/collision/box_box_face.h"

#include "sim/collision/picks.h"

namespace pabd::narrow {
namespace {

constexpr double kSnap = 0.02;    // corners closer than this times the smallest half edge are one
constexpr double kRunOn = 0.05;   // tangent of the angle below which an edge and a side are one
constexpr double kDeeper = 0.02;  // of the snap distance: what decides between two corners of one name

struct Corner {
  double x, y, z;
  int line;  // of the polygon's side that leaves this corner: 0–3 incident edge, 4–7 reference side
};

struct Polygon {
  Corner corner[16];
  int size;
};

// Keeps the part with sign·(x or y) ≤ h.
template <bool kAlongX>
void clip(const Polygon& in, double sign, double h, int side, Polygon& out) {
  const auto beyond = [&](const Corner& p) { return sign * (kAlongX ? p.x : p.y) - h; };
  out.size = 0;
  Corner p = in.corner[in.size - 1];
  double past_p = beyond(p);
  for (int i = 0; i < in.size; ++i) {
    const Corner& q = in.corner[i];
    const double past_q = beyond(q);
    if ((past_p <= 0) != (past_q <= 0)) {
      const double s = past_p / (past_p - past_q);
      Corner cut{p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z),
                 past_p <= 0 ? side : p.line};
      (kAlongX ? cut.x : cut.y) = sign * h;
      out.corner[out.size++] = cut;
    }
    if (past_q <= 0) out.corner[out.size++] = q;
    p = q;
    past_p = past_q;
  }
}

double distance2(const Corner& p, double x, double y) {
  return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
}

// Names of clipped corners, 0–23: incident corners, reference corners, then crossings of an edge and a side.
struct Namer {
  static constexpr std::uint32_t kName = 31, kClipped = 32,
                                 kRunsOn = 64;  // the name, and two flags beside it

  const Polygon& incident;  // unclipped
  double h_x, h_y, snap2;
  double turn;  // +1 when the incident corners run anticlockwise, else −1

  std::uint32_t operator()(const Corner& p, int line_in) const {
    const int edge = std::min(p.line, line_in), side = std::max(p.line, line_in) & 3;
    const std::uint32_t flag = edge < 4 && runs_on(edge, side) ? kRunsOn : 0;
    for (std::uint32_t v = 0; v < 4; ++v) {
      const Corner& c = incident.corner[v];
      if (distance2(p, c.x, c.y) <= snap2) return v | flag;
    }
    for (std::uint32_t v = 0; v < 4; ++v) {
      if (distance2(p, v & 1 ? -h_x : h_x, v & 2 ? -h_y : h_y) <= snap2) return (4 + v) | flag;
    }
    return static_cast<std::uint32_t>(8 + (edge & 3) * 4 + side) | flag;
  }

  bool runs_on(int edge, int side) const {
    const Corner &from = incident.corner[edge], &to = incident.corner[(edge + 1) & 3];
    const double x = to.x - from.x, y = to.y - from.y;
    // Sides are walked as the incident edges are: anticlockwise x = h goes up, y = h goes to −x.
    const double sign = side == 0 || side == 3 ? turn : -turn;
    const double along = sign * (side < 2 ? y : x), across = side < 2 ? x : y;
    return along > 0 && std::abs(across) < kRunOn * along;
  }
};

}  // namespace

double add_face_contacts(const FaceQuery& q, int axis, double reach, Contacts& out) {
  const int k = axis, k1 = kNext[k], k2 = kNext[k1];
  const double up = sign_of(q.t[k]);
  const Vec3& h = q.reference.shape.half;
  const Vec3& g = q.incident.shape.half;
  const double h_x = h[k1], h_y = h[k2];

  // The incident face looks most nearly against the reference face. Ties go to the lower axis, clearly.
  int m = 0;
  for (int j = 1; j < 3; ++j) {
    if (std::abs(q.C[k][j]) > std::abs(q.C[k][m]) + 1e-6) m = j;
  }
  const int m1 = kNext[m], m2 = kNext[m1];
  const double down = -sign_of(up * q.C[k][m]);

  const double f = down * g[m], g1 = g[m1], g2 = g[m2];
  const double x = q.t[k1] + f * q.C[k1][m], x_1 = g1 * q.C[k1][m1], x_2 = g2 * q.C[k1][m2];
  const double y = q.t[k2] + f * q.C[k2][m], y_1 = g1 * q.C[k2][m1], y_2 = g2 * q.C[k2][m2];
  const double z = up * (q.t[k] + f * q.C[k][m]) - h[k], z_1 = up * g1 * q.C[k][m1],
               z_2 = up * g2 * q.C[k][m2];

  Polygon first;
  first.size = 4;
  first.corner[0] = {x + x_1 + x_2, y + y_1 + y_2, z + z_1 + z_2, 0};
  first.corner[1] = {x - x_1 + x_2, y - y_1 + y_2, z - z_1 + z_2, 1};
  first.corner[2] = {x - x_1 - x_2, y - y_1 - y_2, z - z_1 - z_2, 2};
  first.corner[3] = {x + x_1 - x_2, y + y_1 - y_2, z + z_1 - z_2, 3};

  Polygon scratch[2];
  const Polygon* polygon = &first;
  int spare = 0;
  const auto cut = [&](bool along_x, double sign, double bound, int side) {
    Polygon& next = scratch[spare];
    if (along_x) {
      clip<true>(*polygon, sign, bound, side, next);
    } else {
      clip<false>(*polygon, sign, bound, side, next);
    }
    polygon = &next;
    spare = 1 - spare;
    return next.size > 0;
  };
  const double wide_x = std::abs(x_1) + std::abs(x_2), wide_y = std::abs(y_1) + std::abs(y_2);
  if (x + wide_x > h_x && !cut(true, 1, h_x, 4)) return kNone;
  if (-x + wide_x > h_x && !cut(true, -1, h_x, 5)) return kNone;
  if (y + wide_y > h_y && !cut(false, 1, h_y, 6)) return kNone;
  if (-y + wide_y > h_y && !cut(false, -1, h_y, 7)) return kNone;

  const std::uint32_t base = q.owner << 11 | static_cast<std::uint32_t>(2 * k + (up < 0)) << 8 |
                             static_cast<std::uint32_t>(2 * m + (down < 0)) << 5;
  const double snap = kSnap * std::min(std::min(h_x, h_y), std::min(g1, g2));
  const Namer name{first, h_x, h_y, snap * snap, sign_of(x_1 * y_2 - x_2 * y_1)};
  Picks<Corner, 16> picks(kDeeper * snap);
  // Incident corners that survived come before anything near them, crossings that are probably left out come
  // last.
  const int size = polygon->size;
  const Corner* corner = polygon->corner;
  std::uint32_t names[16];
  for (int i = 0; i < size; ++i) {
    const int line_in = corner[i == 0 ? size - 1 : i - 1].line;
    const bool whole = line_in < 4 && corner[i].line < 4;
    names[i] =
        whole ? static_cast<std::uint32_t>(corner[i].line) : name(corner[i], line_in) | Namer::kClipped;
    if (whole) picks.add(corner[i], names[i]);
  }
  for (int i = 0; i < size; ++i) {
    if ((names[i] & ~Namer::kName) == Namer::kClipped) picks.add(corner[i], names[i] & Namer::kName);
  }
  for (int i = 0; i < size; ++i) {
    const bool runs_on = (names[i] & Namer::kRunsOn) != 0;
    if (runs_on && corner[i].z < picks.lowest() - kDeeper * snap)
      picks.add(corner[i], names[i] & Namer::kName);
  }

  const Vec3 along_x = q.reference.R.col(k1), along_y = q.reference.R.col(k2), n = up * q.reference.R.col(k);
  const Vec3 face = q.reference.c + h[k] * n;
  for (int i = 0; i < picks.size(); ++i) {
    const auto& [p, id] = picks[i];
    if (!(p.z < reach)) continue;
    const Vec3 y_a = face + p.x * along_x + p.y * along_y;
    out.push_back({q.reference.number, q.incident.number, y_a, y_a + p.z * n, n, p.z, base | id});
  }
  return picks.lowest();
}

}  // namespace pabd::narrow
