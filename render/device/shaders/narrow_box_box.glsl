// SPDX-License-Identifier: MIT
// box_box.cpp. Two boxes a and b, a the lower number.
//
//   C, t   axes (column j: axis j) and centre of b in the frame of a;  s   that centre in the frame of b
//   h, g   half edges of a and b
const uint EDGE_FEATURE = 1u << 16, CORNER_FEATURE = 1u << 17;

Placed a, b;
dmat3 C;
dvec3 t, s, h, g;
double smallest, the_reach;

struct EdgePair {
  EdgeLine on_a, on_b;
  uint name;
};

// Edges along axis i of a and axis j of b that n, from a to b, looks at; in the frame of a.
EdgePair edges_towards(int i, int j, dvec3 n) {
  EdgePair pair;
  dvec3 into_a[2], into_b[2];
  dvec3 middle_a = dvec3(0), middle_b = t;
  uint id_a = uint(4 * i), id_b = uint(4 * j);
  for (int k = 0; k < 2; ++k) {
    int ka = (i + k + 1) % 3, kb = (j + k + 1) % 3;
    dvec3 w = C[kb];
    double sign_a = sign_of(n[ka]), sign_b = -sign_of(dot(n, w));
    middle_a += sign_a * h[ka] * unit_axis(ka);
    middle_b += sign_b * g[kb] * w;
    into_a[k] = -sign_a * unit_axis(ka);
    into_b[k] = -sign_b * w;
    if (sign_a < 0) id_a |= 1u << k;
    if (sign_b < 0) id_b |= 1u << k;
  }
  pair.on_a = EdgeLine(middle_a, unit_axis(i), h[i], into_a[0], into_a[1]);
  pair.on_b = EdgeLine(middle_b, C[j], g[j], into_b[0], into_b[1]);
  pair.name = EDGE_FEATURE | id_a << 4 | id_b;
  return pair;
}

// Contacts along two edges that run side by side no farther apart than `nearest`; `replacing` of them in reach, or more,
// replace all others. False when there are none.
bool add_side_contacts(EdgePair pair, double nearest, int replacing) {
  int count = side_by_side(pair.on_a, pair.on_b, 0.5lf * preference(nearest, smallest), 0.0lf);
  double lowest = NONE;
  int in_reach = 0;
  for (int k = 0; k < count; ++k) {
    lowest = min(lowest, side_place[k].apart);
    if (side_place[k].apart < the_reach) ++in_reach;
  }
  if (!(lowest <= nearest + preference(nearest, smallest))) return false;
  if (in_reach >= replacing) found_count = 0;
  for (int k = 0; k < count; ++k) {
    SidePlace p = side_place[k];
    if (p.apart < the_reach)
      add_contact(false, a.c + a.R * p.y, a.R * p.n, p.apart, pair.name | uint(p.where) << 8);
  }
  return true;
}

// Contacts along the edges of axes i and j that n, from a to b, looks at, or, where i < 0, along any two that run side by
// side; in the frame of a. False when there are none.
bool add_along_edges(int i, int j, dvec3 n, double nearest, int replacing) {
  int begin = i < 0 ? 0 : 3 * i + j, end = i < 0 ? 9 : begin + 1;
  for (int k = begin; k < end; ++k) {
    int e = k / 3, g = k % 3;
    if (i < 0 && 1 - C[g][e] * C[g][e] > ALONG_SINE * ALONG_SINE) continue;
    if (add_side_contacts(edges_towards(e, g, n), nearest, replacing)) return true;
  }
  return false;
}

// Where an edge pair or a corner touches.
struct ContactPlace {
  dvec3 y_b, n;     // world
  dvec3 n_from_a;   // from a to b, in the frame of a
  double d;
  uint feature;
  bool second_owns;
};

// Nearest points of the edges along axis i of a and axis j of b. False when they lie beyond the ends of an edge.
bool place_of_edges(int i, int j, out ContactPlace place) {
  dvec3 n = cross(unit_axis(i), C[j]);
  double sine2 = dot(n, n);
  n *= sign_of(dot(n, t)) / sqrt(sine2);
  EdgePair pair = edges_towards(i, j, n);
  dvec3 v = pair.on_b.direction, w = pair.on_b.middle - pair.on_a.middle;
  double uv = C[j][i], uw = w[i], vw = dot(v, w);
  double on_a = (uw - uv * vw) / sine2, on_b = (uv * uw - vw) / sine2;
  place = ContactPlace(a.c + a.R * (pair.on_b.middle + on_b * v), a.R * n, n, dot(w, n), pair.name, false);
  const double END = 1 + 1e-9lf;
  return abs(on_a) <= pair.on_a.half_length * END && abs(on_b) <= pair.on_b.half_length * END;
}

struct NearestCorner {
  double apart2;
  dvec3 corner, foot;  // in the frame of the box that has the foot
  uint number;
};

// Corner of the box of half edges g, which stands at (C, t), nearest to that of half edges h.
NearestCorner nearest_corner(dvec3 h, dvec3 g, dmat3 C, dvec3 t) {
  NearestCorner best;
  best.apart2 = NONE;
  for (uint k = 0u; k < 8u; ++k) {
    precise dvec3 x = t + C * (g * corner_signs(k));
    dvec3 foot = clamp(x, -h, h);
    dvec3 gap = x - foot;
    double apart2 = dot(gap, gap);
    if (apart2 < best.apart2) best = NearestCorner(apart2, x, foot, k);
  }
  return best;
}

ContactPlace place_of_corner(NearestCorner c, bool corner_of_b) {
  double apart = sqrt(c.apart2);
  dvec3 n = (c.corner - c.foot) / apart;
  dvec3 corner = corner_of_b ? a.c + a.R * c.corner : b.c + b.R * c.corner;
  return ContactPlace(corner, corner_of_b ? a.R * n : b.R * n, corner_of_b ? n : -(C * n), apart,
               CORNER_FEATURE | (corner_of_b ? 8u : 0u) | c.number, !corner_of_b);
}

// Clips against a face of a or of b, for add_box_face.
double clip_to_face(bool of_b, int axis) {
  FaceQuery q = FaceQuery(a.c, a.R, h, g, C, t, false);
  if (of_b) q = FaceQuery(b.c, b.R, g, h, transpose(C), -s, true);
  return clip_box_face(q, axis);
}

// The edge pair that separates best and better than `face`; false: not within reach.
bool best_edge(double face, out double separation, out int edge_i, out int edge_j) {
  separation = -NONE;
  edge_i = edge_j = -1;
  double bar = min(face, 0.0lf);
  for (int i = 0; i < 3; ++i) {
    int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      double along = abs(t[i2] * C[j][i1] - t[i1] * C[j][i2]) -
                     (h[i1] * abs(C[j][i2]) + h[i2] * abs(C[j][i1]) + g[j1] * abs(C[j2][i]) + g[j2] * abs(C[j1][i]));
      if (along <= bar) continue;
      double sine2 = C[j][i1] * C[j][i1] + C[j][i2] * C[j][i2];
      if (sine2 < 1e-8lf) continue;  // parallel: a face direction says the same
      double apart = along / sqrt(sine2);
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

void find_contacts(Placed first, Placed second, double reach) {
  begin_contacts();
  a = first;
  b = second;
  the_reach = reach;
  h = shapes[a.shape].size.xyz;
  g = shapes[b.shape].size.xyz;
  smallest = min(shapes[a.shape].size.w, shapes[b.shape].size.w);
  C = transpose(a.R) * b.R;
  t = (b.c - a.c) * a.R;
  s = (b.c - a.c) * b.R;

  double face_a = -NONE, face_b = -NONE;
  int axis_a = 0, axis_b = 0;
  for (int i = 0; i < 3; ++i) {
    double s_a = abs(t[i]) - h[i] - (abs(C[0][i]) * g[0] + abs(C[1][i]) * g[1] + abs(C[2][i]) * g[2]);
    double s_b = abs(s[i]) - g[i] - (abs(C[i][0]) * h[0] + abs(C[i][1]) * h[1] + abs(C[i][2]) * h[2]);
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
  double face = b_owns ? face_b : face_a, rival = b_owns ? face_a : face_b;
  double edge;
  int edge_i, edge_j;
  if (!best_edge(face, edge, edge_i, edge_j)) return;

  double bound = face + preference(face, smallest), rival_bound = rival + preference(rival, smallest);
  bool clearly_edge = edge > bound, apart = max(face, edge) > 0;
  // In turns, so that each kind of contact is made at one place of the shader, which saves a driver's time. Turn 0: the
  // edge pair that is clearly best, the chosen face. Turn 1 of boxes that overlap: the edge pair, the other face. Turn 1
  // of those that are apart: the other face; turn 2: the edge pair; turn 3: a corner.
  bool try_edge = clearly_edge, try_face = true, corner_of_b = false;
  double d = NONE, nearest = NONE;
  NearestCorner corner;
  for (int turn = 0; turn < 4; ++turn) {
    bool at_corner = turn == 3;
    if (try_edge || at_corner) {
      ContactPlace place;
      bool is_there;
      if (at_corner) {
        place = place_of_corner(corner, corner_of_b);
        is_there = nearest < d && nearest > 1e-12lf * smallest;
      } else {
        is_there = place_of_edges(edge_i, edge_j, place);
      }
      if (is_there) {
        // Contacts along edges replace those of the face at a corner, and where there are several.
        int replacing = at_corner ? 0 : turn == 2 ? 2 : MOST_FOUND;
        if (!(place.d > 0 && add_along_edges(at_corner ? -1 : edge_i, edge_j, place.n_from_a, place.d, replacing)) &&
            place.d < reach)
          add_contact(place.second_owns, place.y_b, place.n, place.d, place.feature);
      }
      if (is_there || at_corner) break;
      edge_j = -1;  // its places are beyond the ends
    }
    if (turn == 0) try_face = !(clearly_edge && edge > 0 && face <= 0);
    bool of_b = b_owns != (turn > 0);
    double over = try_face ? clip_to_face(of_b, of_b ? axis_b : axis_a) : NONE;
    bool better = turn == 0 || (apart ? over <= rival_bound : over < d);
    if (try_face && better) {
      found_count = 0;
      add_box_face(reach);
    }
    if (turn == 0) {
      d = over;
      if (d <= bound) break;
      // The deepest or nearest part is not over that face.
      if (apart) {
        d = min(d, reach);
        NearestCorner on_b = nearest_corner(h, g, C, t), on_a = nearest_corner(g, h, transpose(C), -s);
        corner_of_b = on_b.apart2 <= on_a.apart2 * (1 + 1e-9lf);
        corner = on_a;
        if (corner_of_b) corner = on_b;
        nearest = sqrt(corner.apart2);
        try_edge = false;
        try_face = corner_of_b == b_owns && nearest < d && nearest <= rival_bound;
      } else {
        try_edge = edge_j >= 0;
        try_face = !(d < NONE) || rival > face;
      }
    } else if (turn == 1) {
      if ((try_face && better) || !apart) break;
      try_edge = edge_j >= 0 && edge < nearest - 1e-9lf * smallest;
      try_face = false;
    }
  }
}
