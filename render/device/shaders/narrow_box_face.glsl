// SPDX-License-Identifier: MIT
// box_box_face.cpp: the incident face of a box, clipped against the sides of the face of another.
const wide SNAP = wide(0.02lf), RUN_ON = wide(0.05lf), DEEPER = wide(0.02lf);
const int MOST_CORNERS = 8;  // of a box's face clipped by another

struct Corner {
  wide3 p;   // along the reference face and above it
  int line;  // of the polygon's side that leaves this corner: 0–3 incident edge, 4–7 reference side; once kept its name
};

const uint NAME = 31u, CLIPPED = 32u, RUNS_ON = 64u;  // the name, and two flags beside it

// The incident box as the reference box sees it.
struct FaceQuery {
  wide3 h, g;   // half edges of the reference and of the incident box
  mat_wide3 C;  // column j: axis j of the incident box, in the reference frame
  wide3 t;
  bool of_second;  // the reference is the second body
};
// Along and above the reference face; e_1, e_2: half edges.
struct IncidentFace {
  wide3 middle, e_1, e_2;
};

wide3 h, g;                    // half edges of the bodies a and b
Corner clipped[MOST_CORNERS];  // from clip to clip in place
Corner kept[MOST_CORNERS];     // those in reach of the face that was kept last
int kept_count = 0;
uint clipped_base, kept_base;  // of the names; they say which face it is
uvec2 picks;                   // bytes: the corners that become contacts, one a name, which is in the low bits
int pick_count;
wide pick_lowest;

uint byte_of(uvec2 bytes, int i) { return (i < 4 ? bytes.x : bytes.y) >> 8 * (i & 3) & 255u; }
void set_byte(inout uvec2 bytes, int i, uint byte) {
  uint at = uint(8 * (i & 3)), rest = ~(255u << at);
  if (i < 4) bytes.x = bytes.x & rest | byte << at;
  else bytes.y = bytes.y & rest | byte << at;
}

wide3 incident_corner(IncidentFace face, int v) {
  wide3 x = v == 0 || v == 3 ? face.middle + face.e_1 : face.middle - face.e_1;
  return v < 2 ? x + face.e_2 : x - face.e_2;
}

// Keeps the part of the polygon of `size` corners with sign·(x or y) ≤ bound; returns its size. What is written is at
// most one ahead of what is read, as the polygon is convex; where rounding makes it none, a cut is left out.
int clip_polygon(int size, bool along_x, wide side_sign, wide bound, int side) {
  int count = 0;
  Corner p = clipped[size - 1], next = clipped[0];
  wide past_p = side_sign * (along_x ? p.p.x : p.p.y) - bound;
  for (int i = 0; i < size; ++i) {
    Corner q = next;
    next = clipped[min(i + 1, size - 1)];
    int room = min(i + 2, MOST_CORNERS);
    wide past_q = side_sign * (along_x ? q.p.x : q.p.y) - bound;
    bool keeps_q = past_q <= 0;
    if ((past_p <= 0) != keeps_q && count + (keeps_q ? 1 : 0) < room) {
      wide3 cut = p.p + (past_p / (past_p - past_q)) * (q.p - p.p);
      if (along_x) cut.x = side_sign * bound;
      else cut.y = side_sign * bound;
      clipped[count] = Corner(cut, past_p <= 0 ? side : p.line);
      ++count;
    }
    if (keeps_q && count < room) {
      clipped[count] = q;
      ++count;
    }
    p = q;
    past_p = past_q;
  }
  return count;
}

wide distance2(wide3 p, wide2 q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); }

// turn: +1 when the incident corners run anticlockwise, else −1.
bool edge_runs_on(IncidentFace face, int edge, int side, wide turn) {
  wide3 from = incident_corner(face, edge), to = incident_corner(face, (edge + 1) & 3);
  wide2 e = to.xy - from.xy;
  wide walk = side == 0 || side == 3 ? turn : -turn;
  wide along = walk * (side < 2 ? e.y : e.x), across = side < 2 ? e.x : e.y;
  return along > 0 && abs(across) < RUN_ON * along;
}

uint name_of(IncidentFace face, Corner p, int line_in, wide2 size, wide snap2, wide turn) {
  int edge = min(p.line, line_in), side = max(p.line, line_in) & 3;
  uint name = uint(8 + (edge & 3) * 4 + side);
  // The first that it is at, incident corners before those of the reference.
  for (int v = 7; v >= 0; --v) {
    wide2 at = wide2((v & 1) != 0 ? -size.x : size.x, (v & 2) != 0 ? -size.y : size.y);
    if (v < 4) at = incident_corner(face, v).xy;
    if (distance2(p.p, at) <= snap2) name = uint(v);
  }
  return name | (edge < 4 && edge_runs_on(face, edge, side, turn) ? RUNS_ON : 0u);
}

void add_pick(int at, uint name, wide clearly) {
  wide z = clipped[at].p.z;
  uint pick = uint(at) << 5 | name;
  pick_lowest = min(pick_lowest, z);
  int place = 0;
  while (place < pick_count && (byte_of(picks, place) & NAME) != name) ++place;
  bool is_new = place == pick_count;
  if (is_new || z < clipped[byte_of(picks, place) >> 5].p.z - clearly) set_byte(picks, place, pick);
  if (is_new) ++pick_count;
}

// Clips the incident face to the face across `axis`, for keep_box_face. Returns the smallest d over the face, in reach or
// not; NONE when nothing of the incident face is over it.
wide clip_box_face(FaceQuery q, int axis) {
  int k = axis, k1 = next_axis(k), k2 = next_axis(k1);
  wide up = sign_of(at(q.t, k)), height = at(q.h, k);
  wide2 size = wide2(at(q.h, k1), at(q.h, k2));

  wide3 towards = wide3(at(q.C[0], k), at(q.C[1], k), at(q.C[2], k));
  int m = 0;
  for (int j = 1; j < 3; ++j) {
    if (abs(at(towards, j)) > abs(at(towards, m)) + wide(1e-6lf)) m = j;
  }
  int m1 = next_axis(m), m2 = next_axis(m1);
  wide down = -sign_of(up * at(towards, m));
  wide g_1 = at(q.g, m1), g_2 = at(q.g, m2);
  wide3 middle = q.t + (down * at(q.g, m)) * column(q.C, m), e_1 = g_1 * column(q.C, m1), e_2 = g_2 * column(q.C, m2);
  middle = wide3(at(middle, k1), at(middle, k2), up * at(middle, k) - height);
  e_1 = wide3(at(e_1, k1), at(e_1, k2), up * at(e_1, k));
  e_2 = wide3(at(e_2, k1), at(e_2, k2), up * at(e_2, k));
  IncidentFace face = IncidentFace(middle, e_1, e_2);
  for (int v = 0; v < 4; ++v) clipped[v] = Corner(incident_corner(face, v), v);

  int count = 4;
  wide2 extent = abs(e_1.xy) + abs(e_2.xy);
  for (int side = 0; side < 4 && count > 0; ++side) {
    bool along_x = side < 2;
    wide side_sign = (side & 1) == 0 ? wide(1.0lf) : -wide(1.0lf), bound = along_x ? size.x : size.y;
    wide reaches = side_sign * (along_x ? middle.x : middle.y) + (along_x ? extent.x : extent.y);
    if (reaches > bound) count = clip_polygon(count, along_x, side_sign, bound, 4 + side);
  }

  clipped_base = (q.of_second ? 1u : 0u) << 11 | uint(2 * k + (up < 0 ? 1 : 0)) << 8 |
                 uint(2 * m + (down < 0 ? 1 : 0)) << 5;
  wide snap = SNAP * min(min(size.x, size.y), min(g_1, g_2));
  wide turn = sign_of(e_1.x * e_2.y - e_2.x * e_1.y), clearly = DEEPER * snap;
  uvec2 names = uvec2(0u);
  picks = uvec2(0u);
  pick_count = 0;
  pick_lowest = NONE;
  // Incident corners that survived come before anything near them, crossings that are probably left out come last.
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < count; ++i) {
      if (pass == 0) {
        Corner p = clipped[i];
        int line_in = clipped[i == 0 ? count - 1 : i - 1].line;
        bool whole = line_in < 4 && p.line < 4;
        set_byte(names, i, whole ? uint(p.line) : name_of(face, p, line_in, size, snap * snap, turn) | CLIPPED);
      }
      uint name = byte_of(names, i), flags = name & ~NAME;
      bool now = pass == 0   ? flags == 0u
                 : pass == 1 ? flags == CLIPPED
                             : (flags & RUNS_ON) != 0u && clipped[i].p.z < pick_lowest - clearly;
      if (now) add_pick(i, name & NAME, clearly);
    }
  }
  return pick_lowest;
}

// Keeps what touches of the faces that were clipped last, instead of what was kept before.
void keep_box_face(wide reach) {
  kept_base = clipped_base;
  kept_count = 0;
  for (int i = 0; i < pick_count; ++i) {
    uint pick = byte_of(picks, i);
    wide3 p = clipped[pick >> 5].p;
    if (p.z < reach) {
      kept[kept_count] = Corner(p, int(pick & NAME));
      ++kept_count;
    }
  }
}

FoundContact kept_contact(int i) {
  Corner corner = kept[i];
  bool of_second = (kept_base >> 11 & 1u) != 0u;
  int k = int(kept_base >> 9 & 3u), k1 = next_axis(k), k2 = next_axis(k1);
  wide up = (kept_base >> 8 & 1u) != 0u ? -wide(1.0lf) : wide(1.0lf), height = at(of_second ? g : h, k);
  mat_wide3 R = of_second ? b.R : a.R;
  wide3 c = of_second ? b.c : a.c, n = up * column(R, k), m = c + height * n;
  wide3 y = m + (corner.p.x * column(R, k1) + corner.p.y * column(R, k2) + corner.p.z * n);
  return FoundContact(y, n, corner.p.z, kept_base | uint(corner.line) | (of_second ? SECOND_OWNS : 0u));
}
