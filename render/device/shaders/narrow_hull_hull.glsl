// SPDX-License-Identifier: MIT
// hull_hull.cpp. Two hulls, or a hull and a box, a and b, a goes first.
//
// Eight over a face and up to three along edges, which replace them or not.
//
//   C, t   pose of b in the frame of a;  C_back, t_back   pose of a in the frame of b
TextHull view_a, view_b;
const int NEVER = MOST_FOUND + 1;
mat_wide3 C_back;
wide3 t, t_back;
wide smallest, the_reach;

// The face of the owner that separates best from the other, which stands at (M, m) in its frame. Stops as soon as one
// separates by the reach.
wide best_face(TextHull owner, TextHull other, mat_wide3 M, wide3 m, out uint face) {
  wide best = -NONE;
  face = 0u;
  for (uint f = 0u; f < owner.faces; ++f) {
    wide3 n = normal_of(owner, f), n_there = n * M;
    wide lowest = NONE;
    uint at = 0u;
    for (uint v = 0u; v < other.vertices; ++v) {
      wide height = dot(n_there, vertex_of(other, v));
      at = height < lowest ? v : at;
      lowest = min(lowest, height);
    }
    // As the processor rounds it: beside a corner that points at it two faces of a solid are as near.
    wide s = dot(n, m + M * vertex_of(other, at)) - offset_of(owner, f, n);
    if (s > best) {
      best = s;
      face = f;
    }
    if (s >= the_reach) break;
  }
  return best;
}

struct BestEdge {
  wide separation;
  int e, g;
  wide3 n;  // unit, from a towards b, in the frame of a
};

// See hull_hull.cpp. In the frame of b.
bool separates_less(wide3 p, wide3 A, wide3 B, wide s) {
  wide room = s + wide(0.99lf) * view_b.inner_radius, most = max(-dot(A, p), -dot(B, p));
  return most <= 0 ? most <= room : room > 0 && most * most <= room * room * (1 + dot(A, B)) / 2;
}

// Of the pairs whose arcs cross on the Gauss map, in the frame of b.
BestEdge best_edge(wide above) {
  BestEdge best = BestEdge(above, -1, -1, wide3(0));
  for (uint i = 0u; i < view_a.edges; ++i) {
    uvec4 edge_a = edge_of(view_a, i);
    wide3 p_a = vertex_of(view_a, edge_a.x);
    wide3 e = (vertex_of(view_a, edge_a.y) - p_a) * C, up = p_a * C, p = t_back + up;
    wide3 A = normal_of(view_a, edge_a.z) * C, B = normal_of(view_a, edge_a.w) * C;
    wide ee = dot(e, e);
    if (separates_less(p, A, B, best.separation)) continue;
    for (uint j = 0u; j < view_b.edges; ++j) {
      uvec4 edge_b = edge_of(view_b, j);
      wide C_e = -dot(normal_of(view_b, edge_b.z), e), D_e = -dot(normal_of(view_b, edge_b.w), e);
      if (C_e * D_e >= 0) continue;
      wide3 q = vertex_of(view_b, edge_b.x), g = vertex_of(view_b, edge_b.y) - q;
      wide A_g = dot(A, g), B_g = dot(B, g);
      if (A_g * B_g >= 0 || C_e * B_g <= 0) continue;
      wide3 n = cross(e, g);
      wide size2 = dot(n, n);
      if (!(size2 / (ee * dot(g, g)) > wide(1e-8lf))) continue;  // parallel: a face direction says the same
      n /= sqrt(size2);
      if (dot(n, up) < 0) n = -n;  // the centre of a lies below every one of its edges
      wide s = dot(n, q - p);
      if (s > best.separation) best = BestEdge(s, int(i), int(j), C * n);
      if (s >= the_reach) return best;
    }
  }
  return best;
}

// An edge of a hull that stands at (M, m).
EdgeLine edge_line(TextHull hull, uvec4 edge, mat_wide3 M, wide3 m) {
  wide3 from = vertex_of(hull, edge.x), to = vertex_of(hull, edge.y);
  wide size = sqrt(dot(to - from, to - from));
  wide3 u = (to - from) / size;
  return EdgeLine(m + M * (wide(0.5lf) * (from + to)), M * u, wide(0.5lf) * size, M * cross(normal_of(hull, edge.z), u),
                  M * cross(u, normal_of(hull, edge.w)));
}

// Contacts along two edges that run side by side no farther apart than `nearest`; `replacing` of them in reach, or more,
// replace all others. False when there are none.
bool add_side_contacts(EdgeLine on_a, EdgeLine on_b, uint pair, wide nearest, int replacing) {
  int count = side_by_side(on_a, on_b, wide(0.5lf) * preference(nearest, smallest), wide(0.0lf));
  wide lowest = NONE;
  int in_reach = 0;
  for (int k = 0; k < count; ++k) {
    lowest = min(lowest, at(side_apart, k));
    if (at(side_apart, k) < the_reach) ++in_reach;
  }
  bool are_there = lowest <= nearest + preference(nearest, smallest);
  if (are_there && in_reach >= replacing) found_count = 0;
  for (int k = 0; are_there && k < count; ++k) {
    SidePlace p = side_place(on_a, on_b, k);
    uint kind = p.where == SIDE_LOW ? LOW_END : p.where == SIDE_HIGH ? HIGH_END : EDGE_PAIR;
    if (p.apart < the_reach)
      add_contact(false, a.c + a.R * p.y, a.R * p.n, p.apart, hull_feature(kind, 0u, pair));
  }
  return are_there;
}

// Where an edge pair or a corner touches. y, n in the world.
struct ContactPlace {
  wide3 y_b, n;
  wide d;
  uint feature;
  bool second_owns;
};

// Nearest points of the two edges. False when they lie beyond the ends of an edge.
bool place_of_edges(BestEdge best, out ContactPlace place) {
  uint e = uint(best.e), g = uint(best.g);
  uvec4 edge_a = edge_of(view_a, e), edge_b = edge_of(view_b, g);
  wide3 p = vertex_of(view_a, edge_a.x), q = t + C * vertex_of(view_b, edge_b.x);
  wide3 u = vertex_of(view_a, edge_a.y) - p, v = t + C * vertex_of(view_b, edge_b.y) - q, w = q - p;
  wide uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  wide det = uu * vv - uv * uv;
  wide on_a = (uw * vv - uv * vw) / det, on_b = (uv * uw - uu * vw) / det;
  place = ContactPlace(a.c + a.R * (q + on_b * v), a.R * best.n, dot(w, best.n), hull_feature(EDGE_PAIR, 0u, e << 10 | g),
                false);
  wide END = beyond_rounding(1e-9lf);
  return on_a >= -END && on_a <= 1 + END && on_b >= -END && on_b <= 1 + END;
}

struct NearestCorner {
  wide apart;
  wide3 corner, foot;  // in the frame of the hull that has the foot
  uint number;
};

// Nearest points where one is a corner, if nearer than `limit`.
// The faces that separate best say of most corners that they are not.
NearestCorner nearest_corner(wide limit, uint face_a, uint face_b, out bool corner_of_b) {
  NearestCorner best = NearestCorner(NONE, wide3(0), wide3(0), 0u);
  corner_of_b = true;
  // First the corners of b, then those of a; two corners: that of b.
  for (int turn = 0; turn < 2; ++turn) {
    TextHull hull = view_a, other = view_b;
    mat_wide3 M = C;
    wide3 m = t;
    if (turn == 1) {
      hull = view_b;
      other = view_a;
      M = C_back;
      m = t_back;
    }
    uint face = turn == 1 ? face_b : face_a;
    wide3 n = normal_of(hull, face);
    wide offset = offset_of(hull, face, n);
    NearestCorner on_other = NearestCorner(NONE, wide3(0), wide3(0), 0u);
    for (uint v = 0u; v < other.vertices; ++v) {
      wide3 x = m + M * vertex_of(other, v), foot;
      wide nearer = min(limit, on_other.apart);
      if (dot(n, x) - offset >= nearer) continue;
      wide apart = nearest_point(hull, x, nearer, foot);
      if (apart < nearer) on_other = NearestCorner(apart, x, foot, v);
    }
    if (turn == 0) {
      best = on_other;
      limit = min(limit, best.apart);
    } else if (!(best.apart <= on_other.apart * (1 + beyond_rounding(1e-9lf)))) {
      best = on_other;
      corner_of_b = false;
    }
  }
  return best;
}

// Contacts along that pair of edges, or, where there is none, along an edge through the corner which runs side by side
// with an edge of the other hull. False when there are none.
bool add_along_edges(bool one_pair, BestEdge pair, bool corner_of_b, uint corner, wide nearest, int replacing) {
  bool own_b = !one_pair && corner_of_b;
  TextHull own = view_a, other = view_b;
  mat_wide3 M_own = mat_wide3(1), M_other = C;
  wide3 at_own = wide3(0), at_other = t;
  if (own_b) {
    own = view_b;
    other = view_a;
    M_own = C;
    M_other = mat_wide3(1);
    at_own = t;
    at_other = wide3(0);
  }
  uint e_begin = one_pair ? uint(pair.e) : 0u, e_end = one_pair ? e_begin + 1u : own.edges;
  uint g_begin = one_pair ? uint(pair.g) : 0u, g_end = one_pair ? g_begin + 1u : other.edges;
  bool added = false;
  for (uint e = e_begin; e < e_end && !added; ++e) {
    uvec4 edge = edge_of(own, e);
    if (!one_pair && edge.x != corner && edge.y != corner) continue;
    EdgeLine on_own = edge_line(own, edge, M_own, at_own);
    for (uint g = g_begin; g < g_end && !added; ++g) {
      EdgeLine on_a = on_own, on_b = edge_line(other, edge_of(other, g), M_other, at_other);
      wide uv = dot(on_a.direction, on_b.direction);
      if (!one_pair && uv * uv < 1 - ALONG_SINE * ALONG_SINE) continue;
      if (own_b) {
        on_a = on_b;
        on_b = on_own;
      }
      added = add_side_contacts(on_a, on_b, own_b ? g << 10 | e : e << 10 | g, nearest, replacing);
    }
  }
  return added;
}

// Clips against that face of a or b, for add_hull_face; returns the smallest d. The face of the other that looks most
// nearly against it is taken, but where that has not got the lowest corner and is above `bound`, one that has.
wide clip_to_face(bool of_b, uint face, wide bound) {
  FaceQuery q = FaceQuery(view_a, view_b, C, t, a.c, a.R, false);
  if (of_b) q = FaceQuery(view_b, view_a, C_back, t_back, b.c, b.R, true);
  wide3 n = normal_of(q.reference, face) * q.M;
  uint first = 0u, incident = 0u;
  wide d = NONE;
  // The face most nearly against it; one with the lowest corner; the first again, which said more.
  bool done = false;
  for (int turn = 0; turn < 3 && !done; ++turn) {
    if (turn < 2) incident = facing(q.incident, n, turn == 0 ? -1 : lowest_vertex(q.incident, n));
    if (turn == 0) first = incident;
    if (turn == 2) incident = first;
    done = turn == 1 && incident == first;
    wide over = NONE;
    if (!done) over = clip_hull_face(q, face, incident);
    if (!done && (turn != 1 || over < d)) {
      d = over;
      done = turn > 0 || d <= bound;
    }
  }
  return d;
}

ContactPlace place_of_corner(NearestCorner c, bool corner_of_b) {
  Placed owner = a;
  if (!corner_of_b) owner = b;
  return ContactPlace(owner.c + owner.R * c.corner, owner.R * ((c.corner - c.foot) / c.apart), c.apart,
               hull_feature(CORNER, 0u, (corner_of_b ? 1024u : 0u) | c.number), !corner_of_b);
}

// What separates them best, by may_touch().
wide face_a, face_b;
uint number_a, number_b;
bool b_owns;
BestEdge edge;

// False: they are farther apart than the reach.
bool may_touch(wide reach) {
  the_reach = reach;
  view_a = view_of(a.shape);
  view_b = view_of(b.shape);
  smallest = min(view_a.inner_radius, view_b.inner_radius);
  t = (b.c - a.c) * a.R;
  C_back = transpose(C);
  t_back = -(C_back * t);

  for (int side = 0; side < 2; ++side) {
    TextHull owner = view_a, other = view_b;
    mat_wide3 M = C;
    wide3 m = t;
    if (side == 1) {
      owner = view_b;
      other = view_a;
      M = C_back;
      m = t_back;
    }
    uint number;
    wide best = best_face(owner, other, M, m, number);
    if (!(best < reach)) return false;
    if (side == 0) {
      face_a = best;
      number_a = number;
    } else {
      face_b = best;
      number_b = number;
    }
  }
  b_owns = face_b > face_a + preference(face_a, smallest);
  edge = best_edge(b_owns ? face_b : face_a);
  return edge.separation < reach;
}

void find_contacts(wide reach) {
  if (!may_touch(reach)) return;
  wide face = b_owns ? face_b : face_a, rival = b_owns ? face_a : face_b;
  wide bound = face + preference(face, smallest), rival_bound = rival + preference(rival, smallest);
  bool clearly_edge = edge.separation > bound, apart = edge.separation > 0;
  // In turns, so that each kind of contact is made at one place of the shader. Turn −1: the chosen face, where the edge
  // pair that is clearly best is nearly along it. Turn 0: that edge pair, the chosen face. Turn 1 of hulls that overlap:
  // the edge pair, the other face. Turn 1 of those that are apart: the other face; turn 2: the edge pair; turn 3: a corner.
  bool is_flat = edge.g >= 0 && is_nearly_along(edge.n, b_owns ? C * normal_of(view_b, number_b)
                                                               : normal_of(view_a, number_a));
  bool try_edge = clearly_edge && !is_flat, try_face = true, corner_of_b = false;
  wide d = NONE;
  NearestCorner corner = NearestCorner(NONE, wide3(0), wide3(0), 0u);
  bool done = false;  // in place of `break`: see narrow_box_box.glsl
  for (int turn = clearly_edge && is_flat ? -1 : 0; turn < 4 && !done; ++turn) {
    bool at_corner = turn == 3;
    if (try_edge || at_corner) {
      ContactPlace place;
      bool is_there;
      if (at_corner) {
        place = place_of_corner(corner, corner_of_b);
        is_there = place.d < d && place.d > wide(1e-12lf) * smallest;
      } else {
        is_there = place_of_edges(edge, place);
      }
      if (is_there) {
        // Contacts along edges replace those of the face at a corner, and where there are several.
        int replacing = at_corner ? 0 : turn == 2 ? 2 : NEVER;
        if (!(place.d > 0 && add_along_edges(!at_corner, edge, corner_of_b, corner.number, place.d, replacing)) &&
            place.d < reach)
          add_contact(place.second_owns, place.y_b, place.n, place.d, place.feature);
      }
      done = is_there || at_corner;
      if (!done) edge.g = -1;  // its places are beyond the ends
    }
    if (turn == 0) try_face = !(clearly_edge && apart && face <= 0);
    try_face = try_face && !done;
    bool of_b = b_owns != (turn > 0);
    wide face_bound = apart || turn < 0 ? NONE : turn == 0 ? bound : rival_bound, over = NONE;
    if (try_face) over = clip_to_face(of_b, of_b ? number_b : number_a, face_bound);
    bool is_nearly = is_flat && abs(over - edge.separation) <= preference(edge.separation, smallest);
    bool better = turn < 0    ? is_nearly
                  : turn == 0 || (apart ? over <= rival_bound : over < d);
    if (try_face && better) {
      found_count = 0;
      add_hull_face(reach);
    }
    if (turn < 0) {
      done = better;
      try_edge = true;
    } else if (!done && turn == 0) {
      d = over;
      done = d <= bound || is_nearly;
      // Else the deepest or nearest part is not over that face.
      if (!done && apart) {
        d = min(d, reach);
        corner = nearest_corner(d, number_a, number_b, corner_of_b);
        try_edge = false;
        try_face = corner_of_b == b_owns && corner.apart < d && corner.apart <= rival_bound;
      } else {
        try_edge = edge.g >= 0;
        try_face = !(d < NONE) || rival > face;
      }
    } else if (!done && turn == 1) {
      done = (try_face && better) || !apart;
      try_edge = edge.g >= 0 && edge.separation < corner.apart - beyond_rounding(1e-9lf) * smallest;
      try_face = false;
    }
  }
}
