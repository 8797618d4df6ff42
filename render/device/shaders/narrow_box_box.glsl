// SPDX-License-Identifier: MIT
// box_box.cpp. Two boxes a and b, a goes first.
//
//   C, t   axes (column j: axis j) and centre of b in the frame of a;  s   that centre in the frame of b
//   h, g   half edges of a and b
// Eight of a face, which are kept apart, and three along edges, which replace them or not.
#define KEEPS_OTHERWISE
const int NEVER = 4;
const uint EDGE_FEATURE = 1u << 16, CORNER_FEATURE = 1u << 17;

wide3 t, s;
wide smallest, the_reach;

struct EdgePair {
  EdgeLine on_a, on_b;
  uint name;
};

// Edges along axis i of a and axis j of b that n, from a to b, looks at; in the frame of a.
EdgePair edges_towards(int i, int j, wide3 n) {
  EdgePair pair;
  wide3 into_a_0, into_b_0, into_a_1, into_b_1;
  wide3 middle_a = wide3(0), middle_b = t;
  uint id_a = uint(4 * i), id_b = uint(4 * j);
  for (int k = 0; k < 2; ++k) {
    int ka = k == 0 ? next_axis(i) : next_axis(next_axis(i)), kb = k == 0 ? next_axis(j) : next_axis(next_axis(j));
    wide3 w = column(C, kb);
    wide sign_a = sign_of(at(n, ka)), sign_b = -sign_of(dot(n, w));
    middle_a += sign_a * at(h, ka) * unit_axis(ka);
    middle_b += sign_b * at(g, kb) * w;
    into_a_0 = into_a_1;
    into_b_0 = into_b_1;
    into_a_1 = -sign_a * unit_axis(ka);
    into_b_1 = -sign_b * w;
    if (sign_a < 0) id_a |= 1u << k;
    if (sign_b < 0) id_b |= 1u << k;
  }
  pair.on_a = EdgeLine(middle_a, unit_axis(i), at(h, i), into_a_0, into_a_1);
  pair.on_b = EdgeLine(middle_b, column(C, j), at(g, j), into_b_0, into_b_1);
  pair.name = EDGE_FEATURE | id_a << 4 | id_b;
  return pair;
}

// Contacts along two edges that run side by side no farther apart than `nearest`; `replacing` of them in reach, or more,
// replace all others. False when there are none.
bool add_side_contacts(EdgePair pair, wide nearest, int replacing) {
  int count = side_by_side(pair.on_a, pair.on_b, wide(0.5lf) * preference(nearest, smallest), wide(0.0lf));
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
      add_contact(false, a.c + a.R * p.y, a.R * p.n, p.apart, pair.name | uint(p.where) << 8);
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
    wide along = at(column(C, f), e);
    if (!(i < 0 && 1 - along * along > ALONG_SINE * ALONG_SINE))
      added = add_side_contacts(edges_towards(e, f, n), nearest, replacing);
  }
  return added;
}

// Where an edge pair or a corner touches.
struct ContactPlace {
  wide3 y_b, n;     // world
  wide3 n_from_a;   // from a to b, in the frame of a
  wide d;
  uint feature;
  bool second_owns;
};

// Nearest points of the edges along axis i of a and axis j of b. False when they lie beyond the ends of an edge.
bool place_of_edges(int i, int j, out ContactPlace place) {
  wide3 n = cross(unit_axis(i), column(C, j));
  wide sine2 = dot(n, n);
  n *= sign_of(dot(n, t)) / sqrt(sine2);
  EdgePair pair = edges_towards(i, j, n);
  wide3 v = pair.on_b.direction, w = pair.on_b.middle - pair.on_a.middle;
  wide uv = at(pair.on_b.direction, i), uw = at(w, i), vw = dot(v, w);
  wide on_a = (uw - uv * vw) / sine2, on_b = (uv * uw - vw) / sine2;
  place = ContactPlace(a.c + a.R * (pair.on_b.middle + on_b * v), a.R * n, n, dot(w, n), pair.name, false);
  wide END = 1 + beyond_rounding(1e-9lf);
  return abs(on_a) <= pair.on_a.half_length * END && abs(on_b) <= pair.on_b.half_length * END;
}

struct NearestCorner {
  wide apart2;
  wide3 corner, foot;  // in the frame of the box that has the foot
  uint number;
};

// Corner of the box of half edges g, which stands at (C, t), nearest to that of half edges h.
NearestCorner nearest_corner(wide3 h, wide3 g, mat_wide3 C, wide3 t) {
  NearestCorner best;
  best.apart2 = NONE;
  for (uint k = 0u; k < 8u; ++k) {
    precise wide3 x = t + C * (g * corner_signs(k));
    wide3 foot = clamp(x, -h, h);
    wide3 gap = x - foot;
    wide apart2 = dot(gap, gap);
    if (apart2 < best.apart2) best = NearestCorner(apart2, x, foot, k);
  }
  return best;
}

ContactPlace place_of_corner(NearestCorner c, bool corner_of_b) {
  wide apart = sqrt(c.apart2);
  wide3 n = (c.corner - c.foot) / apart;
  wide3 corner = corner_of_b ? a.c + a.R * c.corner : b.c + b.R * c.corner;
  return ContactPlace(corner, corner_of_b ? a.R * n : b.R * n, corner_of_b ? n : -(C * n), apart,
               CORNER_FEATURE | (corner_of_b ? 8u : 0u) | c.number, !corner_of_b);
}

// Clips against a face of a or of b, for keep_box_face.
wide clip_to_face(bool of_b, int axis) {
  FaceQuery q = FaceQuery(h, g, C, t, false);
  if (of_b) q = FaceQuery(g, h, transpose(C), -s, true);
  return clip_box_face(q, axis);
}

// The edge pair that separates best and better than `face`; false: not within reach.
bool best_edge(wide face, out wide separation, out int edge_i, out int edge_j) {
  separation = -NONE;
  edge_i = edge_j = -1;
  wide bar = min(face, wide(0.0lf));
  for (int i = 0; i < 3; ++i) {
    int i1 = next_axis(i), i2 = next_axis(i1);
    for (int j = 0; j < 3; ++j) {
      int j1 = next_axis(j), j2 = next_axis(j1);
      wide3 axis = column(C, j);
      wide c_1 = at(axis, i1), c_2 = at(axis, i2);
      wide along = abs(at(t, i2) * c_1 - at(t, i1) * c_2) -
                   (at(h, i1) * abs(c_2) + at(h, i2) * abs(c_1) + at(g, j1) * abs(at(column(C, j2), i)) +
                    at(g, j2) * abs(at(column(C, j1), i)));
      if (along <= bar) continue;
      wide sine2 = c_1 * c_1 + c_2 * c_2;
      if (sine2 < wide(1e-8lf)) continue;  // parallel: a face direction says the same
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

// What separates them best, by may_touch().
wide face_a, face_b, edge;
int axis_a, axis_b, edge_i, edge_j;
bool b_owns;

// False: they are farther apart than the reach.
bool may_touch(wide reach) {
  kept_count = 0;
  the_reach = reach;
  h = size_of(a).xyz;
  g = size_of(b).xyz;
  smallest = min(size_of(a).w, size_of(b).w);
  t = (b.c - a.c) * a.R;
  s = (b.c - a.c) * b.R;

  face_a = face_b = -NONE;
  axis_a = axis_b = 0;
  for (int i = 0; i < 3; ++i) {
    wide3 row = abs(wide3(at(C[0], i), at(C[1], i), at(C[2], i))), axis = abs(column(C, i));
    wide s_a = abs(at(t, i)) - at(h, i) - (row.x * g.x + row.y * g.y + row.z * g.z);
    wide s_b = abs(at(s, i)) - at(g, i) - (axis.x * h.x + axis.y * h.y + axis.z * h.z);
    if (!(s_a < reach) || !(s_b < reach)) return false;
    if (s_a > face_a) {
      face_a = s_a;
      axis_a = i;
    }
    if (s_b > face_b) {
      face_b = s_b;
      axis_b = i;
    }
  }
  b_owns = face_b > face_a + preference(face_a, smallest);
  return best_edge(b_owns ? face_b : face_a, edge, edge_i, edge_j);
}

void find_contacts(wide reach) {
  if (!may_touch(reach)) return;
  wide face = b_owns ? face_b : face_a, rival = b_owns ? face_a : face_b;
  wide bound = face + preference(face, smallest), rival_bound = rival + preference(rival, smallest);
  bool clearly_edge = edge > bound, apart = max(face, edge) > 0;
  // In turns, so that each kind of contact is made at one place of the shader, which saves a driver's time. Turn −1: the
  // chosen face, where the edge pair that is clearly best is nearly along it. Turn 0: that edge pair, the chosen face.
  // Turn 1 of boxes that overlap: the edge pair, the other face. Turn 1 of those that are apart: the other face; turn 2:
  // the edge pair; turn 3: a corner.
  bool is_flat = false;
  if (edge_j >= 0)
    is_flat = is_nearly_along(cross(unit_axis(edge_i), column(C, edge_j)),
                              b_owns ? column(C, axis_b) : unit_axis(axis_a));
  bool try_edge = clearly_edge && !is_flat, try_face = true, corner_of_b = false;
  wide d = NONE, nearest = NONE;
  NearestCorner corner = NearestCorner(NONE, wide3(0), wide3(0), 0u);
  bool done = false;  // in place of `break`: one driver's loops with several ends and calls with loops inside never end
  for (int turn = clearly_edge && is_flat ? -1 : 0; turn < 4 && !done; ++turn) {
    bool at_corner = turn == 3;
    if (try_edge || at_corner) {
      ContactPlace place;
      bool is_there;
      if (at_corner) {
        place = place_of_corner(corner, corner_of_b);
        is_there = nearest < d && nearest > wide(1e-12lf) * smallest;
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
        NearestCorner on_b = nearest_corner(h, g, C, t), on_a = nearest_corner(g, h, transpose(C), -s);
        corner_of_b = on_b.apart2 <= on_a.apart2 * (1 + beyond_rounding(1e-9lf));
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
      try_edge = edge_j >= 0 && edge < nearest - beyond_rounding(1e-9lf) * smallest;
      try_face = false;
    }
  }
}

int contacts_found() { return kept_count + found_count; }
FoundContact found_contact(int k) {
  if (k < kept_count) return kept_contact(k);
  return added_contact(k - kept_count);
}
