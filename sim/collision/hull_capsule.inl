// SPDX-License-Identifier: MIT
// Capsule b against hull or box a, in the frame of the hull, which owns the normal.
//
// The capsule is its axis, the segment p + t e, t ∈ [0, 1], swollen by its radius. Three cases, in this order:
//   face    the segment lies over a face (or so nearly that the face is as good as any other normal): the part over
//           the face, two contacts
//   apart   the segment is outside: its nearest point to the hull, one contact (more along an edge: side_by_side)
//   edge    the segment pierces the hull and the shortest way out is across an edge
//
//   u   direction of the segment                                                unit
//   separation   of the segment from the hull along a direction, negative inside    m

// Bases of the features; faces and edges are numbered from them.
static constexpr uint NEAREST_BASE = 4096u, PIERCED_BASE = 8192u, EDGE_LINE_BASE = 16384u;

TextHull view;
wide3 seg_p, seg_e, seg_u;
wide capsule_radius, capsule_half, the_reach;

wide3 seg_at(wide t) { return seg_p + t * seg_e; }

// y and n in the frame of the hull.
void add_in_hull(wide3 y, wide3 n, wide d, uint feature) {
  if (d < the_reach) add_contact(false, a.c + a.R * y, a.R * n, d, feature);
}

// Cuts [low, high] to where m·(x + t e) ≤ bound.
bool cut_part(wide3 m, wide bound, wide3 x, wide3 e, wide& low, wide& high) {
  wide start_height = dot(m, x) - bound, slope = dot(m, e);
  if (!(abs(slope) > beyond_rounding(1.0e-14) * sqrt(dot(e, e)))) return start_height <= 0;
  wide t = -start_height / slope;
  if (slope > 0) high = min(high, t);
  else low = max(low, t);
  return low <= high;
}

// The part of the line x + t e, t ∈ [0, 1], over a face.
bool clip_to_face(TextFace face, wide3 x, wide3 e, wide& low, wide& high) {
  low = 0.0;
  high = 1.0;
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
  wide low = 0.0, high = 1.0;
  for (uint f = 0u; f < view.faces; ++f) {
    wide3 n = normal_of(view, f);
    if (!cut_part(n, offset_of(view, f, n), seg_p, seg_e, low, high)) return false;
  }
  return true;
}

// Both ends of the part of the capsule that lies over a face. Returns the smallest d of the two, in reach or
// not; NONE when nothing lies over the face. The lower end is the bottom of its cap, if that is over the
// face. Everything else touches along the side of the cylinder, one radius off the axis: that line is clipped, or,
// when the segment pierces the hull, the segment itself, which is sure to leave something.
wide add_face(uint number, bool through) {
  TextFace face = face_of(view, number);
  wide3 n = face.normal;
  wide slope = dot(n, seg_u), lowest = NONE, low = 0.0, high = 1.0;
  int low_end = slope > 0 ? 0 : 1, done = -1;
  wide3 side = n - slope * seg_u;
  wide size = sqrt(dot(side, side));
  wide3 line = seg_p - capsule_radius * (side / size);
  // The lower end; the line along the side of the cylinder; the axis.
  for (int k = 0; k < 3; ++k) {
    if (k == 0 && slope == 0) continue;
    if (k == 1 && !(size > 1.0e-6)) return lowest;
    if (k == 2 && !(through && done < 0)) return lowest;
    wide3 x = k == 0 ? seg_at(wide(low_end)) : k == 1 ? line : seg_p;
    if (!clip_to_face(face, x, k == 0 ? wide3(0, 0, 0) : seg_e, low, high)) {
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
  Nearest best = {NONE, 0.0, wide3(0, 0, 0)};
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 p = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - p, w = seg_p - p;
    wide ee = dot(seg_e, seg_e), gg = dot(g, g), eg = dot(seg_e, g), ew = dot(seg_e, w), gw = dot(g, w);
    wide det = ee * gg - eg * eg;
    wide t = det > beyond_rounding(1.0e-14) * ee * gg ? clamp((eg * gw - ew * gg) / det, 0.0, 1.0) : 0.0;
    wide s = clamp((gw + t * eg) / gg, 0.0, 1.0);
    t = clamp((s * eg - ew) / ee, 0.0, 1.0);
    wide3 foot = p + s * g, between = seg_at(t) - foot;
    wide apart = sqrt(dot(between, between));
    if (apart < best.apart) {
      best.apart = apart;
      best.t = t;
      best.foot = foot;
    }
  }
  for (int end = 0; end < 2; ++end) {
    wide3 foot = wide3(0, 0, 0);
    wide apart = nearest_point(view, seg_at(wide(end)), best.apart, foot);
    if (apart < best.apart) {
      best.apart = apart;
      best.t = wide(end);
      best.foot = foot;
    }
  }
  return best;
}

// Where the segment runs side by side with the edge. False where it does not, or not where it is nearest.
bool add_along_edge(uint number, wide apart) {
  uvec4 edge = edge_of(view, number);
  wide3 p = vertex_of(view, edge.x), q = vertex_of(view, edge.y);
  wide size = sqrt(dot(q - p, q - p));
  wide3 u = (q - p) / size;
  EdgeLine line = {0.5 * (p + q), u, 0.5 * size, cross(normal_of(view, edge.z), u), cross(u, normal_of(view, edge.w))};
  EdgeLine segment = {seg_at(0.5), seg_u, capsule_half, wide3(0, 0, 0), wide3(0, 0, 0)};
  wide nearest = apart - capsule_radius, slack = preference(nearest, view.inner_radius), lowest = NONE;
  int count = side_by_side(line, segment, 0.5 * slack, 0.0);
  for (int k = 0; k < count; ++k) {
    lowest = min(lowest, distance_to_capsule(side_place(line, segment, k), segment, capsule_radius));
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int k = 0; k < count; ++k) {
    SidePlace place = side_place(line, segment, k);
    wide d = distance_to_capsule(place, segment, capsule_radius);
    uint end = place.where == SIDE_LOW ? 0u : place.where == SIDE_HIGH ? 1u : 2u;
    add_in_hull(place.y - (place.apart - d) * place.n, place.n, d, EDGE_LINE_BASE + 4u * number + end);
  }
  return true;
}

// The nearest point may be a corner, and the edge to follow any that meets there.
bool add_along_edges(Nearest nearest) {
  wide same = beyond_rounding(1.0e-9) * view.inner_radius;
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 p = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - p;
    if (!runs_along(unit(g), seg_u)) continue;
    wide s = clamp(dot(g, nearest.foot - p) / dot(g, g), 0.0, 1.0);
    wide3 between = p + s * g - nearest.foot;
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

// Best separating direction among (edge of the hull) × (segment), unit and outward: only those that lie on the edge's arc
// of the Gauss map, between the normals of its faces, have the edge as their outermost part.
wide best_edge(uint& number, wide3& best_n) {
  wide best = -NONE;
  number = 0u;
  best_n = wide3(0, 0, 0);
  for (uint k = 0u; k < view.edges; ++k) {
    uvec4 edge = edge_of(view, k);
    wide3 p = vertex_of(view, edge.x), g = vertex_of(view, edge.y) - p, n = cross(g, seg_u);
    wide size = sqrt(dot(n, n));
    if (!(size > 1.0e-4 * sqrt(dot(g, g)))) continue;  // parallel: a face direction says the same
    n /= dot(n, p) < 0 ? -size : size;
    if (dot(cross(normal_of(view, edge.z), n), g) < 0 || dot(cross(n, normal_of(view, edge.w)), g) < 0) continue;
    wide separation = dot(n, seg_p - p);
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
  wide3 p = vertex_of(view, edge.x), g = unit(vertex_of(view, edge.y) - p);
  // Nearest point of the segment to the line of the edge: only the components across the edge count.
  wide3 across = seg_e - dot(seg_e, g) * g, offset = (p - seg_p) - dot(p - seg_p, g) * g;
  wide t = clamp(dot(offset, across) / dot(across, across), 0.0, 1.0);
  wide3 y = seg_at(t) - capsule_radius * n;
  add_in_hull(y, n, dot(n, y - p), PIERCED_BASE + number);
}

void find_contacts(wide reach) {
  the_reach = reach;
  view = hull_of(a);
  capsule_radius = radius_of(b);
  capsule_half = half_axis(b);
  wide3 centre = (b.c - a.c) * a.R;
  seg_u = C[1];
  wide3 along = capsule_half * seg_u;
  seg_p = centre - along;
  seg_e = 2.0 * along;

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

  wide size = view.inner_radius, bound = 0.0, edge_separation = -NONE;
  Nearest nearest = {-1.0, 0.0, wide3(0, 0, 0)};
  if (!axis_pierces()) nearest = nearest_to();
  bool outside = nearest.apart > ON_SURFACE * size, want_face = true;
  uint edge = 0u;
  wide3 edge_n = wide3(0, 0, 0);
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
