// SPDX-License-Identifier: MIT
// Face contacts of two boxes.
//
// In the frame of the reference box, with (x, y) the two directions along its face and z the height above it,
// the four corners of the incident face are clipped against |x| ≤ h_x, |y| ≤ h_y. What remains is a convex
// polygon on the incident face; each of its corners is a contact point y_b with d = z.
//
// Features. A corner of the clipped polygon is where two of eight lines meet: the four edges of the incident
// face and the four sides of the reference face. Named so it would change its name, and come and go, when two
// equal faces lie exactly on each other and twist by a rounding error. So a polygon corner close to an
// incident corner takes that corner's name, one close to a reference corner that one's, and one of equal
// names is kept. Where an edge and a side run on into each other at a small angle, their crossing may lie
// anywhere along them; it is left out unless it is the deepest point.
//
//   C, t     incident box in the frame of the reference box        1, m
//   k        axis of the reference face;  k1, k2 the axes along it
//   m        axis of the incident face;   m1, m2 the axes along it
static constexpr wide SNAP = 0.02;    // corners closer than this times the smallest half edge are one
static constexpr wide RUN_ON = 0.05;  // tangent of the angle below which an edge and a side are one
static constexpr wide DEEPER = 0.02;  // of the snap distance: what decides between two corners of one name
static constexpr int MOST_CORNERS = 8;

struct Corner {
  wide3 p;   // along the reference face and above it
  int line;  // of the polygon's side that leaves this corner: 0–3 incident edge, 4–7 reference side; once kept its name
};

// Names of clipped corners, 0–23: incident corners, reference corners, then crossings of an edge and a side.
static constexpr uint NAME = 31u, CLIPPED = 32u, RUNS_ON = 64u;  // the name, and two flags beside it

// The incident box as the reference box sees it.
struct FaceQuery {
  wide3 h, g;   // half edges of the reference and of the incident box
  mat_wide3 C;  // column j: axis j of the incident box, in the reference frame
  wide3 t;      // its centre there
  bool of_second;  // the reference is the second body
};
// Along and above the reference face; e_1, e_2: half edges.
struct IncidentFace {
  wide3 middle, e_1, e_2;
};

wide3 half_a, half_b;          // half edges of the bodies a and b
Corner clipped[MOST_CORNERS];  // from clip to clip in place
Corner kept[MOST_CORNERS];     // those in reach of the face that was kept last
int kept_count = 0;
uint clipped_base, kept_base;  // of the names; they say which face it is
uvec2 picks;                   // bytes: the corners that become contacts, one a name, which is in the low bits
int pick_count;
wide pick_lowest;

uint byte_of(uvec2 bytes, int i) { return ((i < 4 ? bytes.x : bytes.y) >> uint(8 * (i & 3))) & 255u; }
void set_byte(uvec2& bytes, int i, uint value) {
  uint shift = uint(8 * (i & 3)), rest = ~(255u << shift);
  if (i < 4) bytes.x = (bytes.x & rest) | (value << shift);
  else bytes.y = (bytes.y & rest) | (value << shift);
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
      Corner cut = {p.p + (past_p / (past_p - past_q)) * (q.p - p.p), past_p <= 0 ? side : p.line};
      if (along_x) cut.p.x = side_sign * bound;
      else cut.p.y = side_sign * bound;
      clipped[count] = cut;
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

wide distance2(wide3 p, wide x, wide y) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); }

// Sides are walked as the incident edges are: anticlockwise x = h goes up, y = h goes to −x. turn: +1 when the incident
// corners run anticlockwise, else −1.
bool edge_runs_on(IncidentFace face, int edge, int side, wide turn) {
  wide3 e = incident_corner(face, (edge + 1) & 3) - incident_corner(face, edge);
  wide walk = side == 0 || side == 3 ? turn : -turn;
  wide along = walk * (side < 2 ? e.y : e.x), across = side < 2 ? e.x : e.y;
  return along > 0 && abs(across) < RUN_ON * along;
}

uint name_of(IncidentFace face, Corner p, int line_in, wide h_x, wide h_y, wide snap2, wide turn) {
  // The first that it is at, incident corners before those of the reference.
  uint name = NAME;
  for (int v = 0; v < 8 && name == NAME; ++v) {
    wide3 corner = wide3((v & 1) != 0 ? -h_x : h_x, (v & 2) != 0 ? -h_y : h_y, 0);
    if (v < 4) corner = incident_corner(face, v);
    if (distance2(p.p, corner.x, corner.y) <= snap2) name = uint(v);
  }
  if (name != NAME) return name;
  int edge = min(p.line, line_in) & 3, side = max(p.line, line_in) & 3;
  return uint(8 + edge * 4 + side) | (edge_runs_on(face, edge, side, turn) ? RUNS_ON : 0u);
}

// The first of a name, unless a later one is clearly deeper.
void add_pick(int corner, uint name, wide clearly) {
  wide z = clipped[corner].p.z;
  uint pick = (uint(corner) << 5) | name;
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
  wide up = sign_of(at(q.t, k)), height = at(q.h, k), h_x = at(q.h, k1), h_y = at(q.h, k2);

  // The incident face looks most nearly against the reference face. Ties go to the lower axis, clearly.
  wide3 towards = wide3(entry(q.C, k, 0), entry(q.C, k, 1), entry(q.C, k, 2));
  int m = 0;
  for (int j = 1; j < 3; ++j) {
    if (abs(at(towards, j)) > abs(at(towards, m)) + 1.0e-6) m = j;
  }
  int m1 = next_axis(m), m2 = next_axis(m1);
  wide down = -sign_of(up * at(towards, m));
  wide g_1 = at(q.g, m1), g_2 = at(q.g, m2);
  wide3 middle = q.t + (down * at(q.g, m)) * column(q.C, m), e_1 = g_1 * column(q.C, m1), e_2 = g_2 * column(q.C, m2);
  middle = wide3(at(middle, k1), at(middle, k2), up * at(middle, k) - height);
  e_1 = wide3(at(e_1, k1), at(e_1, k2), up * at(e_1, k));
  e_2 = wide3(at(e_2, k1), at(e_2, k2), up * at(e_2, k));
  IncidentFace face = {middle, e_1, e_2};
  for (int v = 0; v < 4; ++v) {
    clipped[v].p = incident_corner(face, v);
    clipped[v].line = v;
  }

  int count = 4;
  wide extent_x = abs(e_1.x) + abs(e_2.x), extent_y = abs(e_1.y) + abs(e_2.y);
  for (int side = 0; side < 4 && count > 0; ++side) {
    bool along_x = side < 2;
    wide side_sign = (side & 1) == 0 ? 1.0 : -1.0, bound = along_x ? h_x : h_y;
    wide reaches = side_sign * (along_x ? middle.x : middle.y) + (along_x ? extent_x : extent_y);
    if (reaches > bound) count = clip_polygon(count, along_x, side_sign, bound, 4 + side);
  }

  clipped_base = ((q.of_second ? 1u : 0u) << 11) | (uint(2 * k + (up < 0 ? 1 : 0)) << 8) |
                 (uint(2 * m + (down < 0 ? 1 : 0)) << 5);
  wide snap = SNAP * min(min(h_x, h_y), min(g_1, g_2));
  wide turn = sign_of(e_1.x * e_2.y - e_2.x * e_1.y), clearly = DEEPER * snap;
  uvec2 names = uvec2(0u, 0u);
  picks = uvec2(0u, 0u);
  pick_count = 0;
  pick_lowest = NONE;
  // Incident corners that survived come before anything near them, crossings that are probably left out come last.
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < count; ++i) {
      if (pass == 0) {
        Corner p = clipped[i];
        int line_in = clipped[i == 0 ? count - 1 : i - 1].line;
        bool whole = line_in < 4 && p.line < 4;
        set_byte(names, i, whole ? uint(p.line) : name_of(face, p, line_in, h_x, h_y, snap * snap, turn) | CLIPPED);
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
    Corner corner = {clipped[pick >> 5].p, int(pick & NAME)};
    if (corner.p.z < reach) {
      kept[kept_count] = corner;
      ++kept_count;
    }
  }
}

// Of contact i of the face that was kept: the body that owns the normal n, the place y_a on its surface and d.
bool kept_contact(int i, wide3& y_a, wide3& n, wide& d, uint& feature) {
  Corner corner = kept[i];
  bool of_second = ((kept_base >> 11) & 1u) != 0u;
  int k = int((kept_base >> 9) & 3u), k1 = next_axis(k), k2 = next_axis(k1);
  wide up = ((kept_base >> 8) & 1u) != 0u ? -1.0 : 1.0, height = of_second ? at(half_b, k) : at(half_a, k);
  n = up * (of_second ? column(b.R, k) : column(a.R, k));
  wide3 along_x = of_second ? column(b.R, k1) : column(a.R, k1), along_y = of_second ? column(b.R, k2) : column(a.R, k2);
  y_a = (of_second ? b.c : a.c) + height * n + corner.p.x * along_x + corner.p.y * along_y;
  d = corner.p.z;
  feature = kept_base | uint(corner.line);
  return of_second;
}
