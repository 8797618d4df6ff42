// SPDX-License-Identifier: MIT
// Face contacts of two hulls: box_box_face for faces of any number of corners.
//
// In the frame of the reference face, (x, y) along it and z above it, the corners of the incident face are
// clipped against the sides of the reference face. Names are given as there: a corner near an incident corner
// or a reference corner takes its name, others are named by edge and side; crossings of an edge and a side
// that run on into each other count only where they are deepest.
#include "sim/collision/hull_face.h"

#include "sim/collision/picks.h"
#include "sim/collision/spread.h"

namespace pabd::narrow {
namespace {

constexpr int kMostCorners = static_cast<int>(2 * kMostHullVertices);
static_assert(kMostCorners <= kMostCandidates);
constexpr double kSnap = 0.02;       // corners closer than this times half the shortest edge are one
constexpr double kRunOn = 0.05;      // tangent of the angle below which an edge and a side are one
constexpr double kDeeper = 0.02;     // of the snap distance: what decides between two corners of one name
constexpr int kSide = kMostCorners;  // lines from here on are sides of the reference face

struct Corner {
  double x, y, z;
  int line;  // of the polygon's side that leaves this corner: incident edge, or kSide + reference side
};

struct Polygon {
  Corner corner[kMostCorners];
  int size = 0;
};

struct Point2 {
  double x, y;
};

struct Frame {
  Vec3 origin, along_x, along_y, n;

  Frame(const HullView& hull, const HullFace& face)
      : origin(hull.vertices[hull.loop[face.first]]), n(face.normal) {
    const Vec3 e = hull.vertices[hull.loop[face.first + 1]] - origin;
    along_x = (e - e.dot(n) * n).normalized();
    along_y = n.cross(along_x);
    origin += (face.offset - n.dot(origin)) * n;
  }
  Corner corner(const Vec3& v, int line) const {
    const Vec3 r = v - origin;
    return {along_x.dot(r), along_y.dot(r), n.dot(r), line};
  }
};

// Keeps the part to the left of the line through a along (u_x, u_y), unit.
void clip(const Polygon& in, const Point2& a, double u_x, double u_y, int side, Polygon& out) {
  const auto beyond = [&](const Corner& p) { return u_y * (p.x - a.x) - u_x * (p.y - a.y); };
  out.size = 0;
  Corner p = in.corner[in.size - 1];
  double past_p = beyond(p);
  for (int i = 0; i < in.size; ++i) {
    const Corner& q = in.corner[i];
    const double past_q = beyond(q);
    if ((past_p <= 0) != (past_q <= 0) && out.size < kMostCorners) {
      const double s = past_p / (past_p - past_q);
      out.corner[out.size++] = {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z),
                                past_p <= 0 ? side : p.line};
    }
    if (past_q <= 0 && out.size < kMostCorners) out.corner[out.size++] = q;
    p = q;
    past_p = past_q;
  }
}

double distance2(const Corner& p, double x, double y) {
  return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
}

// The two faces in the plane of the reference, both walked anticlockwise from above.
struct Faces {
  const HullView &reference, &incident;
  const HullFace &top, &bottom;
  Point2 side[kMostHullVertices];  // corners of the reference
  Polygon first;                   // of the incident face
  double snap2 = 0;

  int sides() const { return top.count; }
  int corners() const { return bottom.count; }
  std::size_t vertex(int k) const {
    return incident.loop[bottom.first + bottom.count - 1 - static_cast<std::size_t>(k)];
  }
  std::size_t edge(int k) const {  // walked backwards: it leaves the next corner of the loop
    const int next = (k + 1) % bottom.count;
    return incident.loop_edge[bottom.first + bottom.count - 1 - static_cast<std::size_t>(next)];
  }
  std::size_t reference_vertex(int k) const {
    return reference.loop[top.first + static_cast<std::size_t>(k)];
  }
  std::size_t reference_edge(int k) const {
    return reference.loop_edge[top.first + static_cast<std::size_t>(k)];
  }
};

constexpr std::uint32_t kClipped = 1u << 31, kRunsOn = 1u << 30;  // beside the name; neither is part of it

bool runs_on(const Faces& f, int edge, int side) {
  const Corner &p = f.first.corner[edge], &q = f.first.corner[(edge + 1) % f.corners()];
  const Point2 &a = f.side[side], &b = f.side[(side + 1) % f.sides()];
  const double along = (q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y);
  const double across = (q.x - p.x) * (b.y - a.y) - (q.y - p.y) * (b.x - a.x);
  return along > 0 && std::abs(across) < kRunOn * along;
}

// Name of a corner that arrives along `line_in`; place and kind, without the reference face.
std::uint32_t name_of(const Faces& f, const Corner& p, int line_in) {
  if (line_in < kSide && p.line < kSide) {
    return hull_feature(HullFeature::incident_corner, 0, f.vertex(p.line));
  }
  const int edge = std::min(p.line, line_in), side = std::max(p.line, line_in) - kSide;
  const bool crosses = edge < kSide;
  const std::uint32_t flags = kClipped | (crosses && runs_on(f, edge, side) ? kRunsOn : 0);
  for (int v = 0; v < f.corners(); ++v) {
    const Corner& c = f.first.corner[v];
    if (distance2(p, c.x, c.y) <= f.snap2)
      return flags | hull_feature(HullFeature::incident_corner, 0, f.vertex(v));
  }
  for (int v = 0; v < f.sides(); ++v) {
    if (distance2(p, f.side[v].x, f.side[v].y) <= f.snap2)
      return flags | hull_feature(HullFeature::reference_corner, 0, f.reference_vertex(v));
  }
  if (!crosses)
    return flags | hull_feature(HullFeature::reference_corner, 0, f.reference_vertex(p.line - kSide));
  return flags | hull_feature(HullFeature::crossing, 0, f.edge(edge) << 10 | f.reference_edge(side));
}

// Of the faces that count. Ties go to the lower one, clearly.
template <class Counts>
int most_against(const HullView& hull, const Vec3& n, const Counts& counts) {
  int best = 0;
  double lowest = kNone;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const double c = n.dot(hull.faces[f].normal);
    if (c >= lowest - 1e-6 || !counts(hull.faces[f])) continue;
    best = static_cast<int>(f);
    lowest = c;
  }
  return best;
}

}  // namespace

int facing(const HullView& hull, const Vec3& n) {
  return most_against(hull, n, [](const HullFace&) { return true; });
}

int facing_with_lowest(const HullView& hull, const Vec3& n) {
  std::size_t lowest = 0;
  for (std::size_t v = 1; v < hull.vertices.size(); ++v) {
    if (n.dot(hull.vertices[v]) < n.dot(hull.vertices[lowest])) lowest = v;
  }
  return most_against(hull, n, [&](const HullFace& face) {
    const auto loop = hull.loop.subspan(face.first, face.count);
    return std::find(loop.begin(), loop.end(), lowest) != loop.end();
  });
}

double add_hull_face(const HullFaceQuery& q, int face, int incident_face, double reach, Contacts& out) {
  const HullFace& top = q.reference.faces[static_cast<std::size_t>(face)];
  const HullFace& bottom = q.incident.faces[static_cast<std::size_t>(incident_face)];
  const Frame frame(q.reference, top);
  Faces f{q.reference, q.incident, top, bottom, {}, {}, 0};
  double shortest2 = kNone;
  for (int k = 0; k < f.sides(); ++k) {
    const Corner c = frame.corner(q.reference.vertices[f.reference_vertex(k)], 0);
    f.side[k] = {c.x, c.y};
  }
  for (int k = 0; k < f.sides(); ++k) {
    const Point2 &a = f.side[k], &b = f.side[(k + 1) % f.sides()];
    shortest2 = std::min(shortest2, (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  }
  for (int k = 0; k < f.corners(); ++k) f.first.corner[k] = frame.corner(q.incident.vertices[f.vertex(k)], k);
  f.first.size = f.corners();
  for (int k = 0; k < f.corners(); ++k) {
    const std::size_t v = f.vertex(k), w = f.vertex((k + 1) % f.corners());
    shortest2 = std::min(shortest2, (q.incident.vertices[v] - q.incident.vertices[w]).squaredNorm());
  }
  const double snap = 0.5 * kSnap * std::sqrt(shortest2);
  f.snap2 = snap * snap;

  Polygon scratch[2];
  const Polygon* polygon = &f.first;
  int spare = 0;
  for (int k = 0; k < f.sides(); ++k) {
    const Point2 &a = f.side[k], &b = f.side[(k + 1) % f.sides()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    clip(*polygon, a, (b.x - a.x) / length, (b.y - a.y) / length, kSide + k, scratch[spare]);
    polygon = &scratch[spare];
    spare = 1 - spare;
    if (polygon->size == 0) return kNone;
  }

  Picks<Corner, kMostCorners> picks(kDeeper * snap);
  std::uint32_t names[kMostCorners];
  const int size = polygon->size;
  const Corner* corner = polygon->corner;
  for (int i = 0; i < size; ++i) {
    names[i] = name_of(f, corner[i], corner[i == 0 ? size - 1 : i - 1].line);
    if ((names[i] & kClipped) == 0) picks.add(corner[i], names[i]);
  }
  for (int i = 0; i < size; ++i) {
    if ((names[i] & (kClipped | kRunsOn)) == kClipped) picks.add(corner[i], names[i] & ~kClipped);
  }
  for (int i = 0; i < size; ++i) {
    const bool deepest = corner[i].z < picks.lowest() - kDeeper * snap;
    if ((names[i] & kRunsOn) != 0 && deepest) picks.add(corner[i], names[i] & ~(kClipped | kRunsOn));
  }

  Vec3 x[kMostCorners];
  double d[kMostCorners];
  std::uint32_t feature[kMostCorners];
  int count = 0;
  for (int i = 0; i < picks.size(); ++i) {
    const auto& [p, id] = picks[i];
    if (!(p.z < reach)) continue;
    x[count] = frame.origin + p.x * frame.along_x + p.y * frame.along_y;
    d[count] = p.z;
    feature[count++] = id | hull_feature(HullFeature{}, static_cast<std::size_t>(face), 0);
  }
  int chosen[kMostPoints];
  const int few = choose_spread(x, d, count, reach, kDeeper * snap, chosen);
  const Vec3 n = q.R * top.normal;
  for (int i = 0; i < few; ++i) {
    const int k = chosen[i];
    const Vec3 y_a = q.c + q.R * x[k];
    out.push_back({q.reference_number, q.incident_number, y_a, y_a + d[k] * n, n, d[k], feature[k]});
  }
  return picks.lowest();
}

}  // namespace pabd::narrow
