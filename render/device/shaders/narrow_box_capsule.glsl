// SPDX-License-Identifier: MIT
// box_capsule.cpp. The axis of the capsule is p + t e, t ∈ [0, 1], of direction u, in the frame of the box.
const uint FACE_BASE = 16u, EDGE_LINE_BASE = 64u, NEAREST_BASE = 128u, PIERCE_BASE = 256u;

Placed the_box;
dvec3 h, seg_p, seg_e, seg_u;
double smallest, capsule_radius, capsule_half, the_reach;

dvec3 seg_at(double t) { return seg_p + t * seg_e; }

// y and n in the frame of the box.
void add_in_box(dvec3 y, dvec3 n, double d, uint feature) {
  if (d < the_reach) add_contact(false, the_box.c + the_box.R * y, the_box.R * n, d, feature);
}

uint edge_number(int axis, dvec3 toward) {
  int j = (axis + 1) % 3, k = (axis + 2) % 3;
  return uint(axis * 4 + (toward[j] < 0 ? 1 : 0) + (toward[k] < 0 ? 2 : 0));
}

// From the box to the point; exactly 0 along axes along which it is inside.
dvec3 gap_at(double t) {
  precise dvec3 x = seg_p + t * seg_e;
  precise dvec3 gap = x - clamp(x, -h, h);
  return gap;
}

// ContactPlace of the point nearest to the box.
double nearest_to_box() {
  double kink[8];  // sorted
  kink[0] = 0;
  kink[1] = 1;
  int count = 2;
  for (int k = 0; k < 6; ++k) {
    int axis = k >> 1;
    if (seg_e[axis] == 0) continue;
    double t = (((k & 1) == 0 ? -h[axis] : h[axis]) - seg_p[axis]) / seg_e[axis];
    if (!(t > 0 && t < 1)) continue;
    int at = count++;
    for (; at > 0; --at) {
      double below = kink[at - 1];
      if (!(below > t)) break;
      kink[at] = below;
    }
    kink[at] = t;
  }
  double t_0 = 0, slope_0 = 0;
  for (int k = 0; k < count; ++k) {
    double t_1 = kink[k], slope_1 = dot(seg_e, gap_at(t_1));
    if (slope_1 >= 0) return k == 0 ? 0.0lf : t_0 + (t_1 - t_0) * (-slope_0 / (slope_1 - slope_0));
    t_0 = t_1;
    slope_0 = slope_1;
  }
  return 1.0lf;
}

// The part [low, high] of x + t e with |x_k| ≤ h_k for both axes other than `axis`.
bool clip_to_face(dvec3 x, int axis, out double low, out double high) {
  low = 0;
  high = 1;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    if (abs(seg_e[k]) < 1e-14lf * h[k]) {
      if (abs(x[k]) > h[k]) return false;
      continue;
    }
    double t_0 = (-h[k] - x[k]) / seg_e[k], t_1 = (h[k] - x[k]) / seg_e[k];
    low = max(low, min(t_0, t_1));
    high = min(high, max(t_0, t_1));
  }
  return low <= high;
}

bool over_face(dvec3 x, int axis) {
  for (int k = 0; k < 3; ++k) {
    if (k != axis && abs(x[k]) > h[k]) return false;
  }
  return true;
}

// Returns the smallest d; NONE when nothing lies over the face.
double add_face(int axis, double face_sign, bool pierces) {
  dvec3 n = face_sign * unit_axis(axis);
  double slope = dot(n, seg_u), offset = h[axis];
  uint feature = FACE_BASE + 4u * uint(axis) + (face_sign < 0 ? 2u : 0u);
  double lowest = NONE;
  int done = -1;
  if (slope != 0) {
    int low_end = slope > 0 ? 0 : 1;
    dvec3 p = seg_at(low_end);
    if (over_face(p, axis)) {
      dvec3 y = p - capsule_radius * n;
      double d = dot(n, y) - offset;
      lowest = d;
      add_in_box(y, n, d, feature + uint(low_end));
      done = low_end;
    }
  }
  dvec3 side = n - slope * seg_u;
  double size = sqrt(dot(side, side));
  if (!(size > 1e-6lf)) return lowest;
  dvec3 line = seg_p - (capsule_radius / size) * side;
  double low, high;
  bool touches = false;
  for (int k = 0; k < 2 && !touches; ++k) {
    if (k == 1 && !(pierces && done < 0)) return lowest;
    touches = clip_to_face(k == 0 ? line : seg_p, axis, low, high);
  }
  if (!touches) return lowest;
  for (int end = 0; end < 2; ++end) {
    if (done == end || (end == 1 && !(high > low || done == 0))) continue;
    dvec3 y = line + (end == 0 ? low : high) * seg_e;
    double d = dot(n, y) - offset;
    lowest = min(lowest, d);
    add_in_box(y, n, d, feature + uint(end));
  }
  return lowest;
}

bool add_along_edge(dvec3 gap) {
  int axis = largest_axis(abs(seg_u)), j = (axis + 1) % 3, k = (axis + 2) % 3;
  if (gap[j] == 0 || gap[k] == 0) return false;
  dvec3 to_j = sign_of(gap[j]) * unit_axis(j), to_k = sign_of(gap[k]) * unit_axis(k);
  EdgeLine edge = EdgeLine(h[j] * to_j + h[k] * to_k, unit_axis(axis), h[axis], -to_j, -to_k);
  EdgeLine segment = EdgeLine(seg_at(0.5lf), seg_u, capsule_half, dvec3(0), dvec3(0));
  double nearest = sqrt(dot(gap, gap)) - capsule_radius, slack = preference(nearest, smallest);
  int count = side_by_side(edge, segment, 0.5lf * slack, 0.0lf);
  uint feature = EDGE_LINE_BASE + 4u * edge_number(axis, gap);
  double d[3], lowest = NONE;
  for (int n = 0; n < count; ++n) {
    d[n] = distance_to_capsule(side_place[n], segment, capsule_radius);
    lowest = min(lowest, d[n]);
  }
  if (!(lowest <= nearest + slack)) return false;
  for (int n = 0; n < count; ++n) {
    SidePlace p = side_place[n];
    uint end = p.where == SIDE_LOW ? 0u : p.where == SIDE_HIGH ? 1u : 2u;
    add_in_box(p.y - (p.apart - d[n]) * p.n, p.n, d[n], feature + end);
  }
  return true;
}

void add_nearest(double t) {
  dvec3 gap = gap_at(t);
  double apart = sqrt(dot(gap, gap));
  if (!(apart > 0) || add_along_edge(gap)) return;
  dvec3 n = gap / apart;
  add_in_box(seg_at(t) - capsule_radius * n, n, apart - capsule_radius,
             NEAREST_BASE + (t <= 0 ? 0u : t >= 1 ? 1u : 2u));
}

// Best separating direction among (edge of the box) × (segment); `n` from the box towards the segment.
double best_edge(out int axis, out dvec3 n) {
  double best = -NONE, size_e = sqrt(dot(seg_e, seg_e));
  dvec3 middle = seg_at(0.5lf);
  axis = 0;
  n = dvec3(0);
  for (int k = 0; k < 3; ++k) {
    dvec3 m = cross(unit_axis(k), seg_e);
    double size = sqrt(dot(m, m));
    if (!(size > 1e-4lf * size_e)) continue;
    m /= sign_of(dot(m, middle)) * size;
    double separation = dot(m, middle) - dot(abs(m), h);
    if (separation > best) {
      best = separation;
      axis = k;
      n = m;
    }
  }
  return best;
}

void add_pierced_edge(int axis, dvec3 n) {
  dvec3 beside = dvec3(1) - unit_axis(axis);
  dvec3 corner = signs_of(n) * h * beside;
  dvec3 across = seg_e * beside, offset = (corner - seg_p) * beside;
  double t = clamp(dot(offset, across) / dot(across, across), 0.0lf, 1.0lf);
  dvec3 y = seg_at(t) - capsule_radius * n;
  add_in_box(y, n, dot(n, y - corner), PIERCE_BASE + edge_number(axis, n));
}

void find_contacts(Placed first, Placed second, double reach) {
  put_first(BOX, first, second);
  the_box = first;
  the_reach = reach;
  h = shapes[first.shape].size.xyz;
  smallest = shapes[first.shape].size.w;
  capsule_radius = shapes[second.shape].size.x;
  capsule_half = 0.5lf * shapes[second.shape].size.y;
  dvec3 centre = (second.c - first.c) * first.R;
  seg_u = second.R[1] * first.R;
  dvec3 along = capsule_half * seg_u;
  seg_p = centre - along;
  seg_e = 2 * along;

  dvec3 separation = abs(centre) - abs(along) - h;
  int face = largest_axis(separation);
  double face_separation = separation[face];
  if (!(face_separation - capsule_radius < reach)) return;

  double t = nearest_to_box();
  dvec3 gap = gap_at(t), edge_n = dvec3(0);
  double apart = sqrt(dot(gap, gap)), bound, edge_separation = -NONE;
  int edge_axis = 0;
  bool outside = apart > 1e-9lf * smallest, want_face;
  if (outside) {
    double d = apart - capsule_radius;
    if (!(d < reach)) return;
    bound = d + preference(d, smallest);
    want_face = apart - face_separation <= preference(apart, smallest);
  } else {
    edge_separation = best_edge(edge_axis, edge_n);
    bound = face_separation + preference(face_separation, smallest);
    want_face = !(edge_separation > bound);
    bound -= capsule_radius;
  }
  double by_face = want_face ? add_face(face, sign_of(centre[face]), !outside) : NONE;
  if (outside) {
    if (by_face > bound) add_nearest(t);
    return;
  }
  if (want_face && (by_face <= bound || !(edge_separation > face_separation))) return;
  add_pierced_edge(edge_axis, edge_n);
}
