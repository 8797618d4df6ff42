// SPDX-License-Identifier: MIT
// hull_face.cpp: the incident face of a hull, clipped against the sides of the face of another.
const double SNAP = 0.02lf, RUN_ON = 0.05lf, DEEPER = 0.02lf;
const int MOST_SIDES = 32;    // of a face
const int MOST_CORNERS = 64;  // of a clipped one; no more than MOST_CANDIDATES
const int SIDE = 512;         // lines from here on are sides of the reference face

const uint INCIDENT_CORNER = 0u, REFERENCE_CORNER = 1u, CROSSING = 2u, EDGE_PAIR = 3u, CORNER = 4u, LOW_END = 5u,
           HIGH_END = 6u;
uint hull_feature(uint kind, uint face, uint place) { return kind << 28 | (face & 255u) << 20 | place; }

struct Corner {
  dvec3 p;   // along the reference face and above it
  int line;  // of the polygon's side that leaves this corner: incident edge, or SIDE + reference side
};

struct FaceQuery {
  HullView reference, incident;
  dmat3 M;  // pose of the incident hull in the frame of the reference
  dvec3 m;
  dvec3 c;  // pose of the reference
  dmat3 R;
  bool of_second;  // the reference is the second body
};

const uint CLIPPED = 1u << 31, RUNS_ON = 1u << 30;  // beside the name; neither is part of it

HullFace top, bottom;  // both walked anticlockwise from above
dvec2 top_corner[MOST_SIDES];
dvec3 bottom_corner[MOST_SIDES];
Corner clipped[2 * MOST_CORNERS];  // two polygons in turns
int pick[MOST_CORNERS];            // the corners that become contacts, one a name
uint pick_name[MOST_CORNERS];
int pick_count;
double pick_lowest;

// The corner k of the bottom face and the edge to the next one, in the order of `bottom_corner`.
uint bottom_vertex(HullView incident, int k) { return corner_of(incident, bottom, bottom.count - 1u - uint(k)).x; }
uint bottom_edge(HullView incident, int k) {
  int next = k + 1 == int(bottom.count) ? 0 : k + 1;
  return corner_of(incident, bottom, bottom.count - 1u - uint(next)).y;
}

// The face of those with vertex `lowest`, or of all (−1), that looks most nearly against n, in the hull's own frame.
uint facing(HullView hull, dvec3 n, int lowest_vertex) {
  uint best = 0u;
  double lowest = NONE;
  for (uint f = 0u; f < hull.faces; ++f) {
    HullFace face = face_of(hull, f);
    double c = dot(n, face.normal);
    if (c >= lowest - 1e-6lf) continue;
    bool counts = lowest_vertex < 0;
    for (uint k = 0u; k < face.count && !counts; ++k) counts = int(corner_of(hull, face, k).x) == lowest_vertex;
    if (!counts) continue;
    best = f;
    lowest = c;
  }
  return best;
}

int lowest_vertex(HullView hull, dvec3 n) {
  int best = 0;
  double lowest = NONE;
  for (uint v = 0u; v < hull.vertices; ++v) {
    double height = dot(n, vertex_of(hull, v));
    if (!(height < lowest)) continue;
    best = int(v);
    lowest = height;
  }
  return best;
}

// Keeps the part to the left of the line through a along u, unit; returns its size.
int clip_polygon(int in_at, int size, int out_at, dvec2 a, dvec2 u, int line) {
  int count = 0;
  Corner p = clipped[in_at + size - 1];
  double past_p = u.y * (p.p.x - a.x) - u.x * (p.p.y - a.y);
  for (int i = 0; i < size; ++i) {
    Corner q = clipped[in_at + i];
    double past_q = u.y * (q.p.x - a.x) - u.x * (q.p.y - a.y);
    if ((past_p <= 0) != (past_q <= 0) && count < MOST_CORNERS) {
      clipped[out_at + count] = Corner(p.p + (past_p / (past_p - past_q)) * (q.p - p.p), past_p <= 0 ? line : p.line);
      ++count;
    }
    if (past_q <= 0 && count < MOST_CORNERS) {
      clipped[out_at + count] = q;
      ++count;
    }
    p = q;
    past_p = past_q;
  }
  return count;
}

bool edge_runs_on(int edge, int side) {
  dvec2 e = bottom_corner[edge + 1 == int(bottom.count) ? 0 : edge + 1].xy - bottom_corner[edge].xy;
  dvec2 g = top_corner[side + 1 == int(top.count) ? 0 : side + 1] - top_corner[side];
  double along = dot(e, g), across = e.x * g.y - e.y * g.x;
  return along > 0 && abs(across) < RUN_ON * along;
}

double distance2(dvec3 p, dvec2 q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); }

uint name_of(FaceQuery q, Corner p, int line_in, double snap2) {
  if (line_in < SIDE && p.line < SIDE) return hull_feature(INCIDENT_CORNER, 0u, bottom_vertex(q.incident, p.line));
  for (int v = 0; v < int(bottom.count); ++v) {
    if (distance2(p.p, bottom_corner[v].xy) <= snap2)
      return CLIPPED | hull_feature(INCIDENT_CORNER, 0u, bottom_vertex(q.incident, v));
  }
  for (int v = 0; v < int(top.count); ++v) {
    if (distance2(p.p, top_corner[v]) <= snap2)
      return CLIPPED | hull_feature(REFERENCE_CORNER, 0u, corner_of(q.reference, top, uint(v)).x);
  }
  if (line_in >= SIDE && p.line >= SIDE)
    return CLIPPED | hull_feature(REFERENCE_CORNER, 0u, corner_of(q.reference, top, uint(p.line - SIDE)).x);
  int edge = min(p.line, line_in), side = max(p.line, line_in) - SIDE;
  return CLIPPED | (edge_runs_on(edge, side) ? RUNS_ON : 0u) |
         hull_feature(CROSSING, 0u, bottom_edge(q.incident, edge) << 10 | corner_of(q.reference, top, uint(side)).y);
}

void add_pick(int at, uint name, double clearly) {
  double z = clipped[at].p.z;
  pick_lowest = min(pick_lowest, z);
  for (int i = 0; i < pick_count; ++i) {
    if (pick_name[i] != name) continue;
    if (z < clipped[pick[i]].p.z - clearly) pick[i] = at;
    return;
  }
  pick[pick_count] = at;
  pick_name[pick_count] = name;
  ++pick_count;
}

// Adds up to 8 contacts for that face of the reference and that one of the incident hull, or only tells: the smallest
// d over the face, in reach or not; NONE when nothing of the incident face is over it.
double add_hull_face(FaceQuery q, uint face, uint incident_face, double reach, bool adds) {
  top = face_of(q.reference, face);
  bottom = face_of(q.incident, incident_face);
  // The frame of the reference face.
  dvec3 n = top.normal, origin = vertex_of(q.reference, corner_of(q.reference, top, 0u).x);
  dvec3 e = vertex_of(q.reference, corner_of(q.reference, top, 1u).x) - origin;
  dvec3 along_x = unit(e - dot(e, n) * n), along_y = cross(n, along_x);
  origin += (top.offset - dot(n, origin)) * n;

  int sides = min(int(top.count), MOST_SIDES), corners = min(int(bottom.count), MOST_SIDES);
  double shortest2 = NONE;
  for (int k = 0; k < sides; ++k) {
    dvec3 r = vertex_of(q.reference, corner_of(q.reference, top, uint(k)).x) - origin;
    top_corner[k] = dvec2(dot(along_x, r), dot(along_y, r));
  }
  for (int k = 0; k < sides; ++k) {
    dvec2 side = top_corner[k + 1 == sides ? 0 : k + 1] - top_corner[k];
    shortest2 = min(shortest2, dot(side, side));
  }
  dvec3 last = vertex_of(q.incident, bottom_vertex(q.incident, corners - 1));
  for (int k = 0; k < corners; ++k) {
    dvec3 x = vertex_of(q.incident, bottom_vertex(q.incident, k)), r = q.m + q.M * x - origin;
    shortest2 = min(shortest2, dot(x - last, x - last));
    last = x;
    bottom_corner[k] = dvec3(dot(along_x, r), dot(along_y, r), dot(n, r));
    clipped[k] = Corner(bottom_corner[k], k);
  }
  double snap = 0.5lf * SNAP * sqrt(shortest2), clearly = DEEPER * snap;

  int count = corners, at = 0;
  for (int k = 0; k < sides; ++k) {
    dvec2 side = top_corner[k + 1 == sides ? 0 : k + 1] - top_corner[k];
    count = clip_polygon(at, count, MOST_CORNERS - at, top_corner[k], side / sqrt(dot(side, side)), SIDE + k);
    at = MOST_CORNERS - at;
    if (count == 0) return NONE;
  }

  uint names[MOST_CORNERS];
  pick_count = 0;
  pick_lowest = NONE;
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < count; ++i) {
      if (pass == 0)
        names[i] = name_of(q, clipped[at + i], clipped[at + (i == 0 ? count - 1 : i - 1)].line, snap * snap);
      uint name = names[i] & ~(CLIPPED | RUNS_ON), flags = names[i] & (CLIPPED | RUNS_ON);
      bool now = pass == 0   ? flags == 0u
                 : pass == 1 ? flags == CLIPPED
                             : (flags & RUNS_ON) != 0u && clipped[at + i].p.z < pick_lowest - clearly;
      if (now) add_pick(at + i, name, clearly);
    }
  }
  if (!adds) return pick_lowest;

  int candidates = 0;
  for (int i = 0; i < pick_count; ++i) {
    dvec3 p = clipped[pick[i]].p;
    if (!(p.z < reach)) continue;
    candidate[candidates] = origin + p.x * along_x + p.y * along_y;
    candidate_d[candidates] = p.z;
    candidate_name[candidates] = pick_name[i] | hull_feature(0u, face, 0u);
    ++candidates;
  }
  int few = choose_spread(candidates, reach, clearly);
  dvec3 world = q.R * n;
  for (int i = 0; i < few; ++i) {
    int k = chosen[i];
    dvec3 y_a = q.c + q.R * candidate[k];
    add_contact(q.of_second, y_a + candidate_d[k] * world, world, candidate_d[k], candidate_name[k]);
  }
  return pick_lowest;
}
