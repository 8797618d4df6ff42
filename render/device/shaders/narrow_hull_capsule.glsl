// SPDX-License-Identifier: MIT
// hull_capsule.cpp, of a hull or a box. The axis of the capsule is p + t e, t ∈ [0, 1], of direction u, in the frame of the hull.
// Two over a face, then up to three along an edge.
#define MOST_FOUND 5
const uint NEAREST_BASE = 4096u, PIERCED_BASE = 8192u, EDGE_LINE_BASE = 16384u;

HullView view;
wide3 seg_p, seg_e, seg_u;
wide capsule_radius, capsule_half, the_reach;

wide3 seg_at(wide t) { return seg_p + t * seg_e; }

// y and n in the frame of the hull.
void add_in_hull(wide3 y, wide3 n, wide d, uint feature) {
  if (d < the_reach) add_contact(false, a.c + a.R * y, a.R * n, d, feature);
}

// Cuts [low, high] to where m·(x + t e) ≤ bound.
bool cut_part(wide3 m, wide bound, wide3 x, wide3 e, inout wide low, inout wide high) {
  wide start = dot(m, x) - bound, slope = dot(m, e);
  if (!(abs(slope) > beyond_rounding(1e-14lf) * sqrt(dot(e, e)))) return start <= 0;
  wide t = -start / slope;
  if (slope > 0) high = min(high, t);
  else low = max(low, t);
  return low <= high;
}

bool clip_to_face(HullFace face, wide3 x, wide3 e, out wide low, out wide high) {
  low = 0;
  high = 1;
  wide3 p = vertex_of(view, corner_of(view, face, 0u).x);
  for (uint k = 0u; k < face.count; ++k) {
    wide3 q = vertex_of(view, corner_of(view, face, k + 1u).x);
    wide3 m = unit(cross(q - p, face.normal));
    if (!cut_part(m, dot(m, p), x, e, low, high)) return false;
    p = q;
  }
  return true;
}

bool axis_pierces() {
  wide low = 0, high = 1;
  for (uint f = 0u; f < view.faces; ++f) {
    wide3 n = normal_of(view, f);
    if (!cut_part(n, offset_of(view, f, n), seg_p, seg_e, low, high)) return false;
  }
  return true;
}

// Returns the smallest d; NONE when nothing lies over the face.
wide add_face(uint number, bool through) {
  HullFace face = face_of(view, number);
  wide3 n = face.normal;
  wide slope = dot(n, seg_u), lowest = NONE, low = 0, high = 1;
  int low_end = slope > 0 ? 0 : 1, done = -1;
  wide3 side = n - slope * seg_u;
  wide size = sqrt(dot(side, side));
  wide3 line = seg_p - (capsule_radius / size) * side;
  // The lower end; the line along the side of the cylinder; the axis.
  for (int k = 0; k < 3; ++k) {
    if (k == 0 && slope == 0) continue;
    if (k == 1 && !(size > wide(1e-6lf))) return lowest;
    if (k == 2 && !(through && done < 0)) return lowest;
    wide3 x = k == 0 ? seg_at(low_end) : k == 1 ? line : seg_p;
    if (!clip_to_face(face, x, k == 0 ? wide3(0) : seg_e, low, high)) {
      if (k == 2) return lowest;
      continue;
    }
    if (k > 0) break;
    done = low_end;
    wide3 y = x - capsule_radius * n;
    lowest = dot(n, y) - face.offset;
    add_in_hull(y, n, lowest, 2u * number + uint(low_end));
  }
  for (int end = 0; end < 2; ++end) {
    if (done == end || (end == 1 && !(high > low || done == 0))) continue;
    wide3 y = line + (end == 0 ? low : high) * seg_e;
    wide d = dot(n, y) - face.offset;
    lowest = min(lowest, d);
    add_in_hull(y, n, d, 2u * number + uint(end));
  }
  return lowest;
}

struct Nearest {
  wide apart, t;
  wide3 foot;
};

// The segment is outside.
Nearest nearest_to() {
  Nearest best = Nearest(NONE, wide(0.0lf), wide3(0));
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 a = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - a, w = seg_p - a;
    wide ee = dot(seg_e, seg_e), gg = dot(g, g), eg = dot(seg_e, g), ew = dot(seg_e, w), gw = dot(g, w);
    wide det = ee * gg - eg * eg;
    wide t = det > beyond_rounding(1e-14lf) * ee * gg ? clamp((eg * gw - ew * gg) / det, wide(0.0lf), wide(1.0lf)) : wide(0.0lf);
    wide s = clamp((gw + t * eg) / gg, wide(0.0lf), wide(1.0lf));
    t = clamp((s * eg - ew) / ee, wide(0.0lf), wide(1.0lf));
    wide3 foot = a + s * g, between = seg_at(t) - foot;
    wide apart = sqrt(dot(between, between));
    if (apart < best.apart) best = Nearest(apart, t, foot);
  }
  for (int t = 0; t < 2; ++t) {
    wide3 foot;
    wide apart = nearest_point(view, seg_at(t), best.apart, foot);
    if (apart < best.apart) best = Nearest(apart, wide(t), foot);
  }
  return best;
}

// Where the segment runs side by side with the edge. False where it does not, or not where it is nearest.
bool add_along_edge(uint number, wide apart) {
  uvec4 edge = edge_of(view, number);
  wide3 a = vertex_of(view, edge.x), b = vertex_of(view, edge.y);
  wide size = sqrt(dot(b - a, b - a));
  wide3 u = (b - a) / size;
  EdgeLine line = EdgeLine(wide(0.5lf) * (a + b), u, wide(0.5lf) * size, cross(normal_of(view, edge.z), u),
                           cross(u, normal_of(view, edge.w)));
  EdgeLine segment = EdgeLine(seg_at(wide(0.5lf)), seg_u, capsule_half, wide3(0), wide3(0));
  wide nearest = apart - capsule_radius, slack = preference(nearest, view.inner_radius);
  int count = side_by_side(line, segment, wide(0.5lf) * slack, wide(0.0lf));
  wide lowest = NONE;
  for (int k = 0; k < count; ++k) {
    lowest = min(lowest, distance_to_capsule(side_place(line, segment, k), segment, capsule_radius));
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int k = 0; k < count; ++k) {
    SidePlace p = side_place(line, segment, k);
    wide d = distance_to_capsule(p, segment, capsule_radius);
    uint end = p.where == SIDE_LOW ? 0u : p.where == SIDE_HIGH ? 1u : 2u;
    add_in_hull(p.y - (p.apart - d) * p.n, p.n, d, EDGE_LINE_BASE + 4u * number + end);
  }
  return true;
}

// The nearest point may be a corner, and the edge to follow any that meets there.
bool add_along_edges(Nearest nearest) {
  wide same = beyond_rounding(1e-9lf) * view.inner_radius;
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 a = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - a;
    if (!runs_along(unit(g), seg_u)) continue;
    wide s = clamp(dot(g, nearest.foot - a) / dot(g, g), wide(0.0lf), wide(1.0lf));
    wide3 between = a + s * g - nearest.foot;
    if (sqrt(dot(between, between)) > same) continue;
    if (add_along_edge(k, nearest.apart)) return true;
  }
  return false;
}

void add_nearest(Nearest nearest) {
  if (add_along_edges(nearest)) return;
  wide3 n = (seg_at(nearest.t) - nearest.foot) / nearest.apart;
  uint end = nearest.t <= 0 ? 0u : nearest.t >= 1 ? 1u : 2u;
  add_in_hull(seg_at(nearest.t) - capsule_radius * n, n, nearest.apart - capsule_radius, NEAREST_BASE + end);
}

// Best separating direction among (edge of the hull) × (segment).
wide best_edge(out uint number, out wide3 best_n) {
  wide best = -NONE;
  number = 0u;
  best_n = wide3(0);
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 a = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - a, n = cross(g, seg_u);
    wide size = sqrt(dot(n, n));
    if (!(size > wide(1e-4lf) * sqrt(dot(g, g)))) continue;  // parallel: a face direction says the same
    n /= dot(n, a) < 0 ? -size : size;
    if (dot(cross(normal_of(view, edge.z), n), g) < 0 || dot(cross(n, normal_of(view, edge.w)), g) < 0) continue;
    wide separation = dot(n, seg_p - a);
    if (separation > best) {
      best = separation;
      number = k;
      best_n = n;
    }
  }
  return best;
}

void add_pierced_edge(uint number, wide3 n) {
  uvec4 edge = edge_of(view, number);
  wide3 a = vertex_of(view, edge.x), g = unit(vertex_of(view, edge.y) - a);
  wide3 across = seg_e - dot(seg_e, g) * g, offset = (a - seg_p) - dot(a - seg_p, g) * g;
  wide t = clamp(dot(offset, across) / dot(across, across), wide(0.0lf), wide(1.0lf));
  wide3 y = seg_at(t) - capsule_radius * n;
  add_in_hull(y, n, dot(n, y - a), PIERCED_BASE + number);
}

void find_contacts(wide reach) {
  put_first(kind_of(a) == int(CAPSULE) ? kind_of(b) : kind_of(a));
  the_reach = reach;
  view = view_of(a.shape);
  capsule_radius = size_of(b).x;
  capsule_half = wide(0.5lf) * size_of(b).y;
  wide3 centre = (b.c - a.c) * a.R;
  seg_u = C[1];
  wide3 along = capsule_half * seg_u;
  seg_p = centre - along;
  seg_e = 2 * along;

  uint face = 0u;
  wide face_separation = -NONE;
  for (uint f = 0u; f < view.faces; ++f) {
    wide3 n = normal_of(view, f);
    wide s = dot(n, centre) - abs(dot(n, along)) - offset_of(view, f, n);
    if (s > face_separation) {
      face_separation = s;
      face = f;
    }
  }
  if (!(face_separation - capsule_radius < reach)) return;

  wide size = view.inner_radius, bound, edge_separation = -NONE;
  Nearest nearest = Nearest(-wide(1.0lf), wide(0.0lf), wide3(0));
  if (!axis_pierces()) nearest = nearest_to();
  bool outside = nearest.apart > ON_SURFACE * size, want_face;
  uint edge = 0u;
  wide3 edge_n = wide3(0);
  if (outside) {
    wide d = nearest.apart - capsule_radius, slack = preference(d, size);
    if (!(d < reach)) return;
    bound = d + slack;
    want_face = nearest.apart - face_separation <= slack;
  } else {
    edge_separation = best_edge(edge, edge_n);
    bound = face_separation + preference(face_separation, size);
    want_face = !(edge_separation > bound);
    bound -= capsule_radius;
  }
  wide lowest = want_face ? add_face(face, !outside) : NONE;
  if (outside) {
    if (lowest > bound) add_nearest(nearest);
    return;
  }
  if (want_face && (lowest <= bound || !(edge_separation > face_separation))) return;
  add_pierced_edge(edge, edge_n);
}
