// SPDX-License-Identifier: MIT
// box_box_face.cpp: the incident face of a box, clipped against the sides of the face of another.
const double SNAP = 0.02lf, RUN_ON = 0.05lf, DEEPER = 0.02lf;
const int MOST_CORNERS = 16;

struct Corner {
  dvec3 p;   // along the reference face and above it
  int line;  // of the polygon's side that leaves this corner: 0–3 incident edge, 4–7 reference side
};

const uint NAME = 31u, CLIPPED = 32u, RUNS_ON = 64u;  // the name, and two flags beside it

// The incident box as the reference box sees it.
struct FaceQuery {
  dvec3 c;  // of the reference, which has the half edges h
  dmat3 R;
  dvec3 h, g;
  dmat3 C;  // column j: axis j of the incident box, in the reference frame
  dvec3 t;
  bool of_second;  // the reference is the second body
};

dvec3 incident_corner[4];
Corner clipped[2 * MOST_CORNERS];  // two polygons in turns
int pick[MOST_CORNERS];            // the corners that become contacts, one a name
uint pick_name[MOST_CORNERS];
int pick_count;
double pick_lowest;

struct ClippedFace {
  dmat3 M;  // frame of the reference face, its normal last, and origin; world
  dvec3 m;
  uint base;  // of the names
  bool of_second;
};
ClippedFace clipped_face;

// Keeps the part of the polygon of `size` corners from `in_at` on with sign·(x or y) ≤ bound; returns its size.
int clip_polygon(int in_at, int size, int out_at, bool along_x, double side_sign, double bound, int side) {
  int count = 0;
  Corner p = clipped[in_at + size - 1];
  double past_p = side_sign * (along_x ? p.p.x : p.p.y) - bound;
  for (int i = 0; i < size; ++i) {
    Corner q = clipped[in_at + i];
    double past_q = side_sign * (along_x ? q.p.x : q.p.y) - bound;
    if ((past_p <= 0) != (past_q <= 0) && count < MOST_CORNERS) {
      dvec3 cut = p.p + (past_p / (past_p - past_q)) * (q.p - p.p);
      if (along_x) cut.x = side_sign * bound;
      else cut.y = side_sign * bound;
      clipped[out_at + count] = Corner(cut, past_p <= 0 ? side : p.line);
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

double distance2(dvec3 p, dvec2 q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); }

// turn: +1 when the incident corners run anticlockwise, else −1.
bool edge_runs_on(int edge, int side, double turn) {
  dvec3 from = incident_corner[edge], to = incident_corner[(edge + 1) & 3];
  dvec2 e = to.xy - from.xy;
  double walk = side == 0 || side == 3 ? turn : -turn;
  double along = walk * (side < 2 ? e.y : e.x), across = side < 2 ? e.x : e.y;
  return along > 0 && abs(across) < RUN_ON * along;
}

uint name_of(Corner p, int line_in, dvec2 size, double snap2, double turn) {
  for (int v = 0; v < 4; ++v) {
    if (distance2(p.p, incident_corner[v].xy) <= snap2) return uint(v);
  }
  for (int v = 0; v < 4; ++v) {
    dvec2 at = dvec2((v & 1) != 0 ? -size.x : size.x, (v & 2) != 0 ? -size.y : size.y);
    if (distance2(p.p, at) <= snap2) return uint(4 + v);
  }
  int edge = min(p.line, line_in) & 3, side = max(p.line, line_in) & 3;
  return uint(8 + edge * 4 + side) | (edge_runs_on(edge, side, turn) ? RUNS_ON : 0u);
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

// Clips the incident face to the face across `axis`, for add_box_face. Returns the smallest d over the face, in reach or
// not; NONE when nothing of the incident face is over it.
double clip_box_face(FaceQuery q, int axis) {
  int k = axis, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  double up = sign_of(q.t[k]);
  dvec2 size = dvec2(q.h[k1], q.h[k2]);

  int m = 0;
  for (int j = 1; j < 3; ++j) {
    if (abs(q.C[j][k]) > abs(q.C[m][k]) + 1e-6lf) m = j;
  }
  int m1 = (m + 1) % 3, m2 = (m + 2) % 3;
  double down = -sign_of(up * q.C[m][k]);
  // (x, y, z) of the middle of the incident face and of its half edges.
  dvec3 middle = q.t + (down * q.g[m]) * q.C[m], e_1 = q.g[m1] * q.C[m1], e_2 = q.g[m2] * q.C[m2];
  middle = dvec3(middle[k1], middle[k2], up * middle[k] - q.h[k]);
  e_1 = dvec3(e_1[k1], e_1[k2], up * e_1[k]);
  e_2 = dvec3(e_2[k1], e_2[k2], up * e_2[k]);
  incident_corner[0] = middle + e_1 + e_2;
  incident_corner[1] = middle - e_1 + e_2;
  incident_corner[2] = middle - e_1 - e_2;
  incident_corner[3] = middle + e_1 - e_2;
  for (int v = 0; v < 4; ++v) clipped[v] = Corner(incident_corner[v], v);

  int count = 4, at = 0;
  dvec2 wide = abs(e_1.xy) + abs(e_2.xy);
  for (int side = 0; side < 4; ++side) {
    bool along_x = side < 2;
    double side_sign = (side & 1) == 0 ? 1.0lf : -1.0lf, bound = along_x ? size.x : size.y;
    double reaches = side_sign * (along_x ? middle.x : middle.y) + (along_x ? wide.x : wide.y);
    if (!(reaches > bound)) continue;
    count = clip_polygon(at, count, MOST_CORNERS - at, along_x, side_sign, bound, 4 + side);
    at = MOST_CORNERS - at;
    if (count == 0) return NONE;
  }

  uint base = (q.of_second ? 1u : 0u) << 11 | uint(2 * k + (up < 0 ? 1 : 0)) << 8 |
              uint(2 * m + (down < 0 ? 1 : 0)) << 5;
  double snap = SNAP * min(min(size.x, size.y), min(q.g[m1], q.g[m2]));
  double turn = sign_of(e_1.x * e_2.y - e_2.x * e_1.y), clearly = DEEPER * snap;
  uint names[MOST_CORNERS];
  pick_count = 0;
  pick_lowest = NONE;
  // Incident corners that survived come before anything near them, crossings that are probably left out come last.
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < count; ++i) {
      if (pass == 0) {
        Corner p = clipped[at + i];
        int line_in = clipped[at + (i == 0 ? count - 1 : i - 1)].line;
        bool whole = line_in < 4 && p.line < 4;
        if (whole) names[i] = uint(p.line);
        else names[i] = name_of(p, line_in, size, snap * snap, turn) | CLIPPED;
      }
      uint flags = names[i] & ~NAME;
      bool now = pass == 0   ? flags == 0u
                 : pass == 1 ? flags == CLIPPED
                             : (flags & RUNS_ON) != 0u && clipped[at + i].p.z < pick_lowest - clearly;
      if (now) add_pick(at + i, names[i] & NAME, clearly);
    }
  }

  dvec3 n = up * q.R[k];
  clipped_face.M = dmat3(q.R[k1], q.R[k2], n);
  clipped_face.m = q.c + q.h[k] * n;
  clipped_face.base = base;
  clipped_face.of_second = q.of_second;
  return pick_lowest;
}

// Adds up to 8 contacts of the faces that were clipped last.
void add_box_face(double reach) {
  ClippedFace face = clipped_face;
  for (int i = 0; i < pick_count; ++i) {
    dvec3 p = clipped[pick[i]].p;
    if (p.z < reach) add_contact(face.of_second, face.m + face.M * p, face.M[2], p.z, face.base | pick_name[i]);
  }
}
