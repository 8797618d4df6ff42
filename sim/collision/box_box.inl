// SPDX-License-Identifier: MIT
// Box against box: separating axes, then a face manifold, an edge pair, or a corner. a goes first.
//
// Fifteen directions can separate two boxes: three face normals each and nine products of edges. The largest
// separation s (negative inside) tells how they meet:
//   face    the incident face clipped against the reference face (box_face); preferred to the rest, and
//           the first body's face to the other's, unless clearly worse (see `preference`)
//   edge    the nearest points of the two edges; along edges that run side by side, at both ends
//           (side_by_side). Not where faces are nearly flat on each other and come as near: they would
//           have one point in a step and four in the next
//   corner  apart: the corner of one box nearest to the other box, or the edges through it where they run
//           side by side
// The nearest or deepest place of the preferred face may lie beside it, as that face is not quite the best;
// what then is best, another face, an edge pair or a corner, is sure to have it.
//
//   C, t_in_a   axes (column j: axis j) of b and the way from a to it in the frame of a;  t_in_b   in that of b
//
// Contacts of a face are kept apart (kept_contact); up to three along edges replace them or not.
static constexpr int NEVER = 4;
static constexpr uint EDGE_FEATURE = 1u << 16, CORNER_FEATURE = 1u << 17;

wide3 t_in_a, t_in_b;
wide smallest, the_reach;

// Edge along axis i of a and edge along axis j of b that n, from a to b, looks at; in the frame of a.
struct EdgePair {
  EdgeLine on_a, on_b;
  uint name;
};

EdgePair edges_towards(int i, int j, wide3 n) {
  wide3 none = wide3(0, 0, 0);
  EdgePair pair = {{none, unit_axis(i), at(half_a, i), none, none}, {t_in_a, column(C, j), at(half_b, j), none, none}, 0u};
  uint id_a = uint(4 * i), id_b = uint(4 * j);
  for (int k = 0; k < 2; ++k) {
    int ka = k == 0 ? next_axis(i) : next_axis(next_axis(i)), kb = k == 0 ? next_axis(j) : next_axis(next_axis(j));
    wide3 w = column(C, kb);
    wide sign_a = sign_of(at(n, ka)), sign_b = -sign_of(dot(n, w));
    pair.on_a.middle += sign_a * at(half_a, ka) * unit_axis(ka);
    pair.on_b.middle += sign_b * at(half_b, kb) * w;
    pair.on_a.into_0 = pair.on_a.into_1;
    pair.on_b.into_0 = pair.on_b.into_1;
    pair.on_a.into_1 = -sign_a * unit_axis(ka);
    pair.on_b.into_1 = -sign_b * w;
    if (sign_a < 0) id_a |= 1u << uint(k);
    if (sign_b < 0) id_b |= 1u << uint(k);
  }
  pair.name = EDGE_FEATURE | (id_a << 4) | id_b;
  return pair;
}

// Contacts along two edges that run side by side no farther apart than `nearest`; `replacing` of them in reach, or more,
// replace all others. False when there are none.
bool add_side_contacts(EdgePair pair, wide nearest, int replacing) {
  int count = side_by_side(pair.on_a, pair.on_b, 0.5 * preference(nearest, smallest), 0.0);
  wide lowest = NONE;
  int in_reach = 0;
  for (int k = 0; k < count; ++k) {
    lowest = min(lowest, at(side_apart, k));
    if (at(side_apart, k) < the_reach) ++in_reach;
  }
  bool are_there = lowest <= nearest + preference(nearest, smallest);
  if (are_there && in_reach >= replacing) kept_count = 0;
  for (int k = 0; are_there && k < count; ++k) {
    SidePlace p = side_place(pair.on_a, pair.on_b, k);
    if (p.apart < the_reach)
      add_contact(false, a.c + a.R * p.y, a.R * p.n, p.apart, pair.name | (uint(p.where) << 8));
  }
  return are_there;
}

// Contacts along the edges of axes i and j that n, from a to b, looks at, or, where i < 0, along any two that run side by
// side; in the frame of a. False when there are none.
bool add_along_edges(int i, int j, wide3 n, wide nearest, int replacing) {
  int begin = i < 0 ? 0 : 3 * i + j, end = i < 0 ? 9 : begin + 1;
  bool added = false;
  for (int k = begin; k < end && !added; ++k) {
    int e = k / 3, f = k % 3;
    wide along = entry(C, e, f);
    if (!(i < 0 && 1 - along * along > ALONG_SINE * ALONG_SINE))
      added = add_side_contacts(edges_towards(e, f, n), nearest, replacing);
  }
  return added;
}

// Where an edge pair or a corner touches.
struct ContactPlace {
  wide3 y_b, n;    // world
  wide3 n_from_a;  // from a to b, in the frame of a
  wide d;
  uint feature;
  bool second_owns;
};

// Nearest points of the edges along axis i of a and axis j of b. False when they lie beyond the ends of an edge.
bool place_of_edges(int i, int j, ContactPlace& place) {
  wide3 n = cross(unit_axis(i), column(C, j));
  wide sine2 = dot(n, n);
  n *= sign_of(dot(n, t_in_a)) / sqrt(sine2);
  EdgePair pair = edges_towards(i, j, n);
  wide3 v = pair.on_b.direction, w = pair.on_b.middle - pair.on_a.middle;
  wide uv = at(pair.on_b.direction, i), uw = at(w, i), vw = dot(v, w);
  wide on_a = (uw - uv * vw) / sine2, on_b = (uv * uw - vw) / sine2, most = 1 + beyond_rounding(1.0e-9);
  place.y_b = a.c + a.R * (pair.on_b.middle + on_b * v);
  place.n = a.R * n;
  place.n_from_a = n;
  place.d = dot(w, n);
  place.feature = pair.name;
  place.second_owns = false;
  return abs(on_a) <= pair.on_a.half_length * most && abs(on_b) <= pair.on_b.half_length * most;
}

struct NearestCorner {
  wide apart2;
  wide3 corner, foot;  // in the frame of the box that has the foot
  uint number;
};

// Corner of the box of half edges `other`, which stands at (M, m), nearest to that of half edges `box`.
NearestCorner nearest_corner(wide3 box, wide3 other, mat_wide3 M, wide3 m) {
  NearestCorner best = {NONE, wide3(0, 0, 0), wide3(0, 0, 0), 0u};
  for (uint k = 0u; k < 8u; ++k) {
    precise wide3 x = m + M * (other * corner_signs(k));
    wide3 foot = clamp(x, -box, box), gap = x - foot;
    wide apart2 = dot(gap, gap);
    if (apart2 < best.apart2) {
      best.apart2 = apart2;
      best.corner = x;
      best.foot = foot;
      best.number = k;
    }
  }
  return best;
}

void place_of_corner(NearestCorner c, bool corner_of_b, ContactPlace& place) {
  mat_wide3 R = a.R;
  wide3 centre = a.c;
  if (!corner_of_b) {
    R = b.R;
    centre = b.c;
  }
  place.d = sqrt(c.apart2);
  place.n = R * ((c.corner - c.foot) / place.d);
  place.y_b = centre + R * c.corner;
  place.n_from_a = (corner_of_b ? place.n : -place.n) * a.R;
  place.feature = CORNER_FEATURE | (corner_of_b ? 8u : 0u) | c.number;
  place.second_owns = !corner_of_b;
}

// Clips against a face of a or of b, for keep_box_face.
wide clip_to_face(bool of_b, int axis) {
  FaceQuery q = {half_a, half_b, C, t_in_a, false};
  if (of_b) {
    q.h = half_b;
    q.g = half_a;
    q.C = transpose(C);
    q.t = -t_in_b;
    q.of_second = true;
  }
  return clip_box_face(q, axis);
}

// The edge pair that separates best and better than `face`; false: some pair is not within reach. With sine ≤ 1 most are
// settled without their square root.
bool best_edge(wide face, wide& separation, int& edge_i, int& edge_j) {
  separation = -NONE;
  edge_i = -1;
  edge_j = -1;
  wide bar = min(face, 0.0);
  for (int i = 0; i < 3; ++i) {
    int i1 = next_axis(i), i2 = next_axis(i1);
    for (int j = 0; j < 3; ++j) {
      int j1 = next_axis(j), j2 = next_axis(j1);
      wide c_1 = entry(C, i1, j), c_2 = entry(C, i2, j);
      wide along = abs(at(t_in_a, i2) * c_1 - at(t_in_a, i1) * c_2) -
                   (at(half_a, i1) * abs(c_2) + at(half_a, i2) * abs(c_1) + at(half_b, j1) * abs(entry(C, i, j2)) +
                    at(half_b, j2) * abs(entry(C, i, j1)));
      if (along <= bar) continue;
      wide sine2 = c_1 * c_1 + c_2 * c_2;
      if (sine2 < 1.0e-8) continue;  // parallel: a face direction says the same
      wide apart = along / sqrt(sine2);
      if (!(apart < the_reach)) return false;
      if (apart > face && apart > separation) {
        separation = apart;
        edge_i = i;
        edge_j = j;
      }
    }
  }
  return true;
}

void find_contacts(wide reach) {
  kept_count = 0;
  the_reach = reach;
  half_a = half_edges(a);
  half_b = half_edges(b);
  smallest = min(smallest_half(a), smallest_half(b));
  t_in_a = (b.c - a.c) * a.R;
  t_in_b = (b.c - a.c) * b.R;

  wide face_a = -NONE, face_b = -NONE;
  int axis_a = 0, axis_b = 0;
  for (int i = 0; i < 3; ++i) {
    wide3 row = abs(wide3(entry(C, i, 0), entry(C, i, 1), entry(C, i, 2))), axis = abs(column(C, i));
    wide s_a = abs(at(t_in_a, i)) - at(half_a, i) - (row.x * half_b.x + row.y * half_b.y + row.z * half_b.z);
    wide s_b = abs(at(t_in_b, i)) - at(half_b, i) - (axis.x * half_a.x + axis.y * half_a.y + axis.z * half_a.z);
    if (!(s_a < reach) || !(s_b < reach)) return;
    if (s_a > face_a) {
      face_a = s_a;
      axis_a = i;
    }
    if (s_b > face_b) {
      face_b = s_b;
      axis_b = i;
    }
  }
  bool b_owns = face_b > face_a + preference(face_a, smallest);
  wide face = b_owns ? face_b : face_a, rival = b_owns ? face_a : face_b, edge = -NONE;
  int edge_i = -1, edge_j = -1;
  if (!best_edge(face, edge, edge_i, edge_j)) return;

  wide bound = face + preference(face, smallest), rival_bound = rival + preference(rival, smallest);
  bool clearly_edge = edge > bound, apart = max(face, edge) > 0;
  // In turns, so that each kind of contact is made at one place of the shader, which saves a driver's time.
  //   −1  the chosen face, where the edge pair that is clearly best is nearly along it
  //    0  that edge pair; the chosen face
  //    1  of boxes that overlap: the edge pair, the other face; of those that are apart: the other face. If that, with
  //       what separates, says how far they are apart, it replaces the chosen one
  //    2  the edge pair. The nearest points are a corner of one and its foot on the other, or lie within the edges of the
  //       pair, which then has the largest separation there is
  //    3  that corner
  bool is_flat = false;
  if (edge_j >= 0)
    is_flat = is_nearly_along(cross(unit_axis(edge_i), column(C, edge_j)),
                              b_owns ? column(C, axis_b) : unit_axis(axis_a));
  bool try_edge = clearly_edge && !is_flat, try_face = true, corner_of_b = false;
  wide d = NONE, nearest = NONE;
  NearestCorner corner = {NONE, wide3(0, 0, 0), wide3(0, 0, 0), 0u};
  ContactPlace place = {wide3(0, 0, 0), wide3(0, 0, 0), wide3(0, 0, 0), 0.0, 0u, false};
  bool done = false;  // in place of `break`: one driver's loops with several ends and calls with loops inside never end
  for (int turn = clearly_edge && is_flat ? -1 : 0; turn < 4 && !done; ++turn) {
    bool at_corner = turn == 3;
    if (try_edge || at_corner) {
      bool is_there = false;
      if (at_corner) {
        place_of_corner(corner, corner_of_b, place);
        is_there = nearest < d && nearest > 1.0e-12 * smallest;
      } else {
        is_there = place_of_edges(edge_i, edge_j, place);
      }
      if (is_there) {
        // Contacts along edges replace those of the face at a corner, and where there are several.
        int replacing = at_corner ? 0 : turn == 2 ? 2 : NEVER;
        if (!(place.d > 0 && add_along_edges(at_corner ? -1 : edge_i, edge_j, place.n_from_a, place.d, replacing)) &&
            place.d < reach)
          add_contact(place.second_owns, place.y_b, place.n, place.d, place.feature);
      }
      done = is_there || at_corner;
      if (!done) edge_j = -1;  // its places are beyond the ends
    }
    // Of boxes that are apart, though not across a face, what is below one lies beyond the box.
    if (turn == 0) try_face = !(clearly_edge && edge > 0 && face <= 0);
    try_face = try_face && !done;
    bool of_b = b_owns != (turn > 0);
    wide over = NONE;
    if (try_face) over = clip_to_face(of_b, of_b ? axis_b : axis_a);
    bool is_nearly = is_flat && abs(over - edge) <= preference(edge, smallest);
    bool better = turn < 0    ? is_nearly
                  : turn == 0 || (apart ? over <= rival_bound : over < d);
    if (try_face && better) keep_box_face(reach);
    if (turn < 0) {
      done = better;
      try_edge = true;
    } else if (!done && turn == 0) {
      d = over;
      done = d <= bound || is_nearly;
      // Else the deepest or nearest part is not over that face.
      if (!done && apart) {
        d = min(d, reach);
        NearestCorner on_b = nearest_corner(half_a, half_b, C, t_in_a),
                      on_a = nearest_corner(half_b, half_a, transpose(C), -t_in_b);
        corner_of_b = on_b.apart2 <= on_a.apart2 * (1 + beyond_rounding(1.0e-9));  // two corners: that of b
        corner = on_a;
        if (corner_of_b) corner = on_b;
        nearest = sqrt(corner.apart2);
        try_edge = false;
        try_face = corner_of_b == b_owns && nearest < d && nearest <= rival_bound;
      } else {
        try_edge = edge_j >= 0;
        try_face = !(d < NONE) || rival > face;
      }
    } else if (!done && turn == 1) {
      done = (try_face && better) || !apart;
      try_edge = edge_j >= 0 && edge < nearest - beyond_rounding(1.0e-9) * smallest;
      try_face = false;
    }
  }
}
