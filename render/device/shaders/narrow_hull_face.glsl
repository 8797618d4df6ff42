// SPDX-License-Identifier: MIT
// hull_face.cpp: the incident face of a hull, clipped against the sides of the face of another.
const wide SNAP = wide(0.02lf), RUN_ON = wide(0.05lf), DEEPER = wide(0.02lf);
const int MOST_SIDES = FACE_CORNERS;        // of a face
const int MOST_CORNERS = 2 * FACE_CORNERS;  // of a clipped one; no more than MOST_CANDIDATES
const int SIDE = 512;         // lines from here on are sides of the reference face

const uint INCIDENT_CORNER = 0u, REFERENCE_CORNER = 1u, CROSSING = 2u, EDGE_PAIR = 3u, CORNER = 4u, LOW_END = 5u,
           HIGH_END = 6u;
uint hull_feature(uint kind, uint face, uint place) { return kind << 28 | (face & 255u) << 20 | place; }

struct Corner {
  wide3 p;   // along the reference face and above it
  int line;  // of the polygon's side that leaves this corner: incident edge, or SIDE + reference side
};

struct FaceQuery {
  TextHull reference, incident;
  mat_wide3 M;  // pose of the incident hull in the frame of the reference
  wide3 m;
  wide3 c;  // pose of the reference
  mat_wide3 R;
  bool of_second;  // the reference is the second body
};

const uint CLIPPED = 1u << 31, RUNS_ON = 1u << 30;  // beside the name; neither is part of it

// Both faces, walked anticlockwise from above: where the corners are, their vertices and the edges that leave them.
int sides, corners;
wide2 top_corner[MOST_SIDES];
wide3 bottom_corner[MOST_SIDES];
uvec2 top_name[MOST_SIDES], bottom_name[MOST_SIDES];
Corner clipped[2 * MOST_CORNERS];  // two polygons in turns
int pick[MOST_CORNERS];            // the corners that become contacts, one a name
uint pick_name[MOST_CORNERS];
int pick_count;
wide pick_lowest;

struct ClippedFace {
  mat_wide3 M;  // frame of the reference face, its normal last, and origin; world
  wide3 m;
  wide clearly;  // what decides between two corners
  uint number;
  bool of_second;
};
ClippedFace clipped_face;

// The face of those with vertex `lowest`, or of all (−1), that looks most nearly against n, in the hull's own frame.
uint facing(TextHull hull, wide3 n, int lowest_vertex) {
  uint best = 0u;
  wide lowest = NONE;
  for (uint f = 0u; f < hull.faces; ++f) {
    TextFace face = face_of(hull, f);
    wide c = dot(n, face.normal);
    if (c >= lowest - wide(1e-6lf)) continue;
    bool counts = lowest_vertex < 0;
    for (uint k = 0u; k < face.count && !counts; ++k) counts = int(corner_of(hull, face, k).x) == lowest_vertex;
    if (!counts) continue;
    best = f;
    lowest = c;
  }
  return best;
}

int lowest_vertex(TextHull hull, wide3 n) {
  int best = 0;
  wide lowest = NONE;
  for (uint v = 0u; v < hull.vertices; ++v) {
    wide height = dot(n, vertex_of(hull, v));
    if (!(height < lowest)) continue;
    best = int(v);
    lowest = height;
  }
  return best;
}

// Keeps the part to the left of the line through a along u, unit; returns its size.
int clip_polygon(int in_at, int size, int out_at, wide2 a, wide2 u, int line) {
  int count = 0;
  Corner p = clipped[in_at + size - 1];
  wide past_p = u.y * (p.p.x - a.x) - u.x * (p.p.y - a.y);
  for (int i = 0; i < size; ++i) {
    Corner q = clipped[in_at + i];
    wide past_q = u.y * (q.p.x - a.x) - u.x * (q.p.y - a.y);
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
  wide2 e = bottom_corner[edge + 1 == corners ? 0 : edge + 1].xy - bottom_corner[edge].xy;
  wide2 g = top_corner[side + 1 == sides ? 0 : side + 1] - top_corner[side];
  wide along = dot(e, g), across = e.x * g.y - e.y * g.x;
  return along > 0 && abs(across) < RUN_ON * along;
}

wide distance2(wide3 p, wide2 q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); }

uint name_of(Corner p, int line_in, wide snap2) {
  int edge = min(p.line, line_in), side = max(p.line, line_in) - SIDE;
  bool whole = side < 0, crosses = edge < SIDE && !whole;
  int below = whole ? p.line : -1, at = whole || crosses ? -1 : p.line - SIDE;
  for (int v = 0; v < corners && below < 0; ++v) {
    if (distance2(p.p, bottom_corner[v].xy) <= snap2) below = v;
  }
  bool is_near = false;
  for (int v = 0; v < sides && below < 0 && !is_near; ++v) {
    is_near = distance2(p.p, top_corner[v]) <= snap2;
    if (is_near) at = v;
  }
  uint name = 0u;
  if (below >= 0) {
    name = hull_feature(INCIDENT_CORNER, 0u, bottom_name[below].x);
  } else if (at >= 0) {
    name = hull_feature(REFERENCE_CORNER, 0u, top_name[at].x);
  } else {
    name = hull_feature(CROSSING, 0u, bottom_name[edge].y << 10 | top_name[side].y);
  }
  return name | (whole ? 0u : CLIPPED) | (crosses && edge_runs_on(edge, side) ? RUNS_ON : 0u);
}

void add_pick(int at, uint name, wide clearly) {
  wide z = clipped[at].p.z;
  pick_lowest = min(pick_lowest, z);
  int place = 0;
  while (place < pick_count && pick_name[place] != name) ++place;
  bool is_new = place == pick_count;
  if (is_new || z < clipped[pick[place]].p.z - clearly) pick[place] = at;
  if (is_new) pick_name[place] = name;
  if (is_new) ++pick_count;
}

// Clips that face of the incident hull to that one of the reference, for add_hull_face. Returns the smallest d over the
// face, in reach or not; NONE when nothing of the incident face is over it.
wide clip_hull_face(FaceQuery q, uint face, uint incident_face) {
  TextFace top = face_of(q.reference, face), bottom = face_of(q.incident, incident_face);
  sides = min(int(top.count), MOST_SIDES);
  corners = min(int(bottom.count), MOST_SIDES);
  // The first corner becomes the origin.
  wide3 n = top.normal, origin = wide3(0), along_x = wide3(0), along_y = wide3(0);
  for (int k = 0; k < sides; ++k) {
    top_name[k] = corner_of(q.reference, top, uint(k));
    wide3 x = vertex_of(q.reference, top_name[k].x);
    if (k == 0) origin = x;
    wide3 r = x - origin;
    if (k == 1) {
      along_x = unit(r - dot(r, n) * n);
      along_y = cross(n, along_x);
    }
    top_corner[k] = wide2(dot(along_x, r), dot(along_y, r));
  }
  origin += (top.offset - dot(n, origin)) * n;
  wide shortest2 = NONE;
  for (int k = 0; k < sides; ++k) {
    wide2 side = top_corner[k + 1 == sides ? 0 : k + 1] - top_corner[k];
    shortest2 = min(shortest2, dot(side, side));
  }
  // Backwards: the edge that leaves a corner is that of the next corner of the loop.
  wide3 last = wide3(0);
  for (int k = -1; k < corners; ++k) {
    uvec2 name = corner_of(q.incident, bottom, uint(k < 0 ? 0 : corners - 1 - k));
    wide3 x = vertex_of(q.incident, name.x);
    if (k >= 0) {
      shortest2 = min(shortest2, dot(x - last, x - last));
      wide3 r = q.m + q.M * x - origin;
      bottom_corner[k] = wide3(dot(along_x, r), dot(along_y, r), dot(n, r));
      clipped[k] = Corner(bottom_corner[k], k);
      bottom_name[k].x = name.x;
      bottom_name[k == 0 ? corners - 1 : k - 1].y = name.y;
    }
    last = x;
  }
  wide snap = wide(0.5lf) * SNAP * sqrt(shortest2), clearly = DEEPER * snap;

  int count = corners, at = 0;
  for (int k = 0; k < sides && count > 0; ++k) {
    wide2 side = top_corner[k + 1 == sides ? 0 : k + 1] - top_corner[k];
    count = clip_polygon(at, count, MOST_CORNERS - at, top_corner[k], side / sqrt(dot(side, side)), SIDE + k);
    at = MOST_CORNERS - at;
  }

  uint names[MOST_CORNERS];
  pick_count = 0;
  pick_lowest = NONE;
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < count; ++i) {
      if (pass == 0)
        names[i] = name_of(clipped[at + i], clipped[at + (i == 0 ? count - 1 : i - 1)].line, snap * snap);
      uint name = names[i] & ~(CLIPPED | RUNS_ON), flags = names[i] & (CLIPPED | RUNS_ON);
      bool now = pass == 0   ? flags == 0u
                 : pass == 1 ? flags == CLIPPED
                             : (flags & RUNS_ON) != 0u && clipped[at + i].p.z < pick_lowest - clearly;
      if (now) add_pick(at + i, name, clearly);
    }
  }
  clipped_face.m = q.c + q.R * origin;
  clipped_face.M = mat_wide3(q.R * along_x, q.R * along_y, q.R * n);
  clipped_face.clearly = clearly;
  clipped_face.number = face;
  clipped_face.of_second = q.of_second;
  return pick_lowest;
}

// Adds up to 8 contacts of the faces that were clipped last.
void add_hull_face(wide reach) {
  ClippedFace face = clipped_face;
  int candidates = 0;
  for (int i = 0; i < pick_count; ++i) {
    wide3 p = clipped[pick[i]].p;
    if (p.z < reach) {
      candidate[candidates] = face.m + p.x * face.M[0] + p.y * face.M[1];  // below it
      candidate_d[candidates] = p.z;
      candidate_name[candidates] = pick_name[i] | hull_feature(0u, face.number, 0u);
      ++candidates;
    }
  }
  int few = choose_spread(candidates, reach, face.clearly);
  for (int i = 0; i < few; ++i) {
    int k = chosen[i];
    add_contact(face.of_second, candidate[k] + candidate_d[k] * face.M[2], face.M[2], candidate_d[k], candidate_name[k]);
  }
}
