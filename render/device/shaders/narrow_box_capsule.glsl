// SPDX-License-Identifier: MIT
// box_capsule.cpp. The axis of the capsule is p + t e, t ∈ [0, 1], of direction u, in the frame of the box.
// Two over a face, then up to three along an edge.
#define MOST_FOUND 5
const uint FACE_BASE = 16u, EDGE_LINE_BASE = 64u, NEAREST_BASE = 128u, PIERCE_BASE = 256u;

wide3 h, seg_p, seg_e, seg_u;
wide smallest, capsule_radius, capsule_half, the_reach;

wide3 seg_at(wide t) { return seg_p + t * seg_e; }

// y and n in the frame of the box.
void add_in_box(wide3 y, wide3 n, wide d, uint feature) {
  if (d < the_reach) add_contact(false, a.c + a.R * y, a.R * n, d, feature);
}

uint edge_number(int axis, wide3 toward) {
  int j = (axis + 1) % 3, k = (axis + 2) % 3;
  return uint(axis * 4 + (at(toward, j) < 0 ? 1 : 0) + (at(toward, k) < 0 ? 2 : 0));
}

// From the box to the point; exactly 0 along axes along which it is inside.
wide3 gap_at(wide t) {
  precise wide3 x = seg_p + t * seg_e;
  precise wide3 gap = x - clamp(x, -h, h);
  return gap;
}

// Where the segment crosses a plane of the box; 2 where it does not.
wide kink(wide e, wide way) { return e == 0 ? wide(2) : way / e; }

// Place of the point nearest to the box.
wide nearest_to_box() {
  wide3 low = wide3(kink(seg_e.x, -h.x - seg_p.x), kink(seg_e.y, -h.y - seg_p.y), kink(seg_e.z, -h.z - seg_p.z));
  wide3 high = wide3(kink(seg_e.x, h.x - seg_p.x), kink(seg_e.y, h.y - seg_p.y), kink(seg_e.z, h.z - seg_p.z));
  wide t_0 = 0, slope_0 = dot(seg_e, gap_at(t_0));
  if (slope_0 >= 0) return t_0;
  while (t_0 < 1) {
    wide t_1 = 1;  // the next of the kinks
    for (int k = 0; k < 3; ++k) {
      wide t_low = at(low, k), t_high = at(high, k);
      if (t_low > t_0) t_1 = min(t_1, t_low);
      if (t_high > t_0) t_1 = min(t_1, t_high);
    }
    wide slope_1 = dot(seg_e, gap_at(t_1));
    if (slope_1 >= 0) return t_0 + (t_1 - t_0) * (-slope_0 / (slope_1 - slope_0));
    t_0 = t_1;
    slope_0 = slope_1;
  }
  return wide(1.0lf);
}

// The part [low, high] of x + t e with |x_k| ≤ h_k for both axes other than `axis`.
bool clip_to_face(wide3 x, int axis, out wide low, out wide high) {
  low = 0;
  high = 1;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    if (abs(at(seg_e, k)) < beyond_rounding(1e-14lf) * at(h, k)) {
      if (abs(at(x, k)) > at(h, k)) return false;
      continue;
    }
    wide t_0 = (-at(h, k) - at(x, k)) / at(seg_e, k), t_1 = (at(h, k) - at(x, k)) / at(seg_e, k);
    low = max(low, min(t_0, t_1));
    high = min(high, max(t_0, t_1));
  }
  return low <= high;
}

bool over_face(wide3 x, int axis) {
  for (int k = 0; k < 3; ++k) {
    if (k != axis && abs(at(x, k)) > at(h, k)) return false;
  }
  return true;
}

// Returns the smallest d; NONE when nothing lies over the face.
wide add_face(int axis, wide face_sign, bool pierces) {
  wide3 n = face_sign * unit_axis(axis);
  wide slope = dot(n, seg_u), offset = at(h, axis);
  uint feature = FACE_BASE + 4u * uint(axis) + (face_sign < 0 ? 2u : 0u);
  wide lowest = NONE;
  int done = -1;
  if (slope != 0) {
    int low_end = slope > 0 ? 0 : 1;
    wide3 p = seg_at(low_end);
    if (over_face(p, axis)) {
      wide3 y = p - capsule_radius * n;
      wide d = dot(n, y) - offset;
      lowest = d;
      add_in_box(y, n, d, feature + uint(low_end));
      done = low_end;
    }
  }
  wide3 side = n - slope * seg_u;
  wide size = sqrt(dot(side, side));
  if (!(size > wide(1e-6lf))) return lowest;
  wide3 line = seg_p - (capsule_radius / size) * side;
  wide low, high;
  bool touches = false;
  for (int k = 0; k < 2 && !touches; ++k) {
    if (k == 1 && !(pierces && done < 0)) return lowest;
    touches = clip_to_face(k == 0 ? line : seg_p, axis, low, high);
  }
  if (!touches) return lowest;
  for (int end = 0; end < 2; ++end) {
    if (done == end || (end == 1 && !(high > low || done == 0))) continue;
    wide3 y = line + (end == 0 ? low : high) * seg_e;
    wide d = dot(n, y) - offset;
    lowest = min(lowest, d);
    add_in_box(y, n, d, feature + uint(end));
  }
  return lowest;
}

bool add_along_edge(wide3 gap) {
  int axis = largest_axis(abs(seg_u)), j = (axis + 1) % 3, k = (axis + 2) % 3;
  if (at(gap, j) == 0 || at(gap, k) == 0) return false;
  wide3 to_j = sign_of(at(gap, j)) * unit_axis(j), to_k = sign_of(at(gap, k)) * unit_axis(k);
  EdgeLine edge = EdgeLine(at(h, j) * to_j + at(h, k) * to_k, unit_axis(axis), at(h, axis), -to_j, -to_k);
  EdgeLine segment = EdgeLine(seg_at(wide(0.5lf)), seg_u, capsule_half, wide3(0), wide3(0));
  wide nearest = sqrt(dot(gap, gap)) - capsule_radius, slack = preference(nearest, smallest);
  int count = side_by_side(edge, segment, wide(0.5lf) * slack, wide(0.0lf));
  uint feature = EDGE_LINE_BASE + 4u * edge_number(axis, gap);
  wide lowest = NONE;
  for (int n = 0; n < count; ++n) {
    lowest = min(lowest, distance_to_capsule(side_place(edge, segment, n), segment, capsule_radius));
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int n = 0; n < count; ++n) {
    SidePlace p = side_place(edge, segment, n);
    wide d = distance_to_capsule(p, segment, capsule_radius);
    uint end = p.where == SIDE_LOW ? 0u : p.where == SIDE_HIGH ? 1u : 2u;
    add_in_box(p.y - (p.apart - d) * p.n, p.n, d, feature + end);
  }
  return true;
}

void add_nearest(wide t) {
  wide3 gap = gap_at(t);
  wide apart = sqrt(dot(gap, gap));
  if (!(apart > 0) || add_along_edge(gap)) return;
  wide3 n = gap / apart;
  add_in_box(seg_at(t) - capsule_radius * n, n, apart - capsule_radius,
             NEAREST_BASE + (t <= 0 ? 0u : t >= 1 ? 1u : 2u));
}

// Best separating direction among (edge of the box) × (segment); `n` from the box towards the segment.
wide best_edge(out int axis, out wide3 n) {
  wide best = -NONE, size_e = sqrt(dot(seg_e, seg_e));
  wide3 middle = seg_at(wide(0.5lf));
  axis = 0;
  n = wide3(0);
  for (int k = 0; k < 3; ++k) {
    wide3 m = cross(unit_axis(k), seg_e);
    wide size = sqrt(dot(m, m));
    if (!(size > wide(1e-4lf) * size_e)) continue;
    m /= sign_of(dot(m, middle)) * size;
    wide separation = dot(m, middle) - dot(abs(m), h);
    if (separation > best) {
      best = separation;
      axis = k;
      n = m;
    }
  }
  return best;
}

void add_pierced_edge(int axis, wide3 n) {
  wide3 beside = wide3(1) - unit_axis(axis);
  wide3 corner = signs_of(n) * h * beside;
  wide3 across = seg_e * beside, offset = (corner - seg_p) * beside;
  wide t = clamp(dot(offset, across) / dot(across, across), wide(0.0lf), wide(1.0lf));
  wide3 y = seg_at(t) - capsule_radius * n;
  add_in_box(y, n, dot(n, y - corner), PIERCE_BASE + edge_number(axis, n));
}

void find_contacts(wide reach) {
  put_first(BOX);
  the_reach = reach;
  h = size_of(a).xyz;
  smallest = size_of(a).w;
  capsule_radius = size_of(b).x;
  capsule_half = wide(0.5lf) * size_of(b).y;
  wide3 centre = (b.c - a.c) * a.R;
  seg_u = C[1];
  wide3 along = capsule_half * seg_u;
  seg_p = centre - along;
  seg_e = 2 * along;

  wide3 separation = abs(centre) - abs(along) - h;
  int face = largest_axis(separation);
  wide face_separation = at(separation, face);
  if (!(face_separation - capsule_radius < reach)) return;

  wide t = nearest_to_box();
  wide3 gap = gap_at(t), edge_n = wide3(0);
  wide apart = sqrt(dot(gap, gap)), bound, edge_separation = -NONE;
  int edge_axis = 0;
  bool outside = apart > beyond_rounding(1e-9lf) * smallest, want_face;
  if (outside) {
    wide d = apart - capsule_radius;
    if (!(d < reach)) return;
    bound = d + preference(d, smallest);
    want_face = apart - face_separation <= preference(apart, smallest);
  } else {
    edge_separation = best_edge(edge_axis, edge_n);
    bound = face_separation + preference(face_separation, smallest);
    want_face = !(edge_separation > bound);
    bound -= capsule_radius;
  }
  wide by_face = want_face ? add_face(face, sign_of(at(centre, face)), !outside) : NONE;
  if (outside) {
    if (by_face > bound) add_nearest(t);
    return;
  }
  if (want_face && (by_face <= bound || !(edge_separation > face_separation))) return;
  add_pierced_edge(edge_axis, edge_n);
}
