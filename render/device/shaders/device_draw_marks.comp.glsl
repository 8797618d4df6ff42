// SPDX-License-Identifier: MIT
// Contacts as glyphs (render/visual/contact_glyphs.cpp): two discs, two cylinders and two cones each, those of a mesh and
// level side by side in the order of the contacts. A thread a contact.
//   COUNT    which classes each glyph has, and how many there are in each work group
//   STARTS   where those of each work group begin, and the commands; one work group
//   EMIT     the instances
const uint LEVELS_EACH = 5u, CLASSES = 15u;  // discs, cylinders, cones
const uint NO_CLASS = 31u, NO_GLYPH = 0x3fffffffu;  // six classes of 5 bits

struct Command {
  uint indices, instances, first_index;
  int first_vertex;
  uint first_instance;
};
struct ContactTold {
  uvec4 ends;      // a, b
  dvec4 y_b;       // w: d
  dvec4 n;         // w: normal force
  dvec4 friction;
};
layout(std430, binding = DRAW_TOLD) readonly buffer DrawTold { ContactTold told[]; };
layout(std430, binding = DRAW_COUNTERS) readonly buffer DrawCounters { uint counter[]; };
layout(std430, binding = DRAW_FIXED) readonly buffer DrawFixed { uint fixed_bits[]; };
layout(std430, binding = DRAW_GLYPHS) readonly buffer DrawGlyphs {
  dvec3 eye;
  double d_hat;
  dvec3 forward;
  double scale, weight, slope;  // scale: radius of a disc
  uint work_groups, parallel;
};
layout(std430, binding = DRAW_GLYPH_CLASSES) buffer DrawGlyphClasses { uint glyph_classes[]; };
layout(std430, binding = DRAW_COUNTS) buffer DrawCounts { uint group_first[]; };  // class · work_groups + work group; then of all

#ifdef STARTS
layout(std430, binding = DRAW_MESHES) readonly buffer DrawMeshes { uvec2 mesh_range[]; };  // a class: indices, first
layout(std430, binding = DRAW_COMMANDS) writeonly buffer DrawCommands { Command commands[]; };
shared uint sum[GROUP];

void main() {
  const uint t = gl_LocalInvocationID.x, size = CLASSES * work_groups, share = (size + GROUP - 1u) / GROUP;
  const uint begin = min(t * share, size), end = min(begin + share, size);
  uint mine = 0u;
  for (uint k = begin; k < end; ++k) mine += group_first[k];
  sum[t] = mine;
  barrier();
  uint before = 0u, total = 0u;
  for (uint k = 0u; k < GROUP; ++k) {
    if (k < t) before += sum[k];
    total += sum[k];
  }
  for (uint k = begin; k < end; ++k) {
    const uint count = group_first[k];
    group_first[k] = before;
    before += count;
  }
  memoryBarrierBuffer();
  barrier();
  if (t == 0u) group_first[size] = total;
  if (t >= CLASSES) return;
  const uint first = group_first[t * work_groups], next = t + 1u < CLASSES ? group_first[(t + 1u) * work_groups] : total;
  commands[t] = Command(mesh_range[t].x, next - first, mesh_range[t].y, 0, first);
}
#else

struct Glyph {
  dvec3 at, towards;
  double d, force;
};
struct Piece {
  dvec3 at;
  double across, along;
};
shared uint here[GROUP];
shared uint count_here[CLASSES];

bool is_number(dvec4 v) {
  for (int k = 0; k < 4; ++k) {
    if ((unpackDouble2x32(v[k]).y & 0x7ff00000u) == 0x7ff00000u) return false;
  }
  return true;
}
bool is_shown(ContactTold c) {
  return c.y_b.w < d_hat && is_number(c.y_b) && is_number(dvec4(c.n.xyz, 0.0lf));
}
bool is_fixed(uint body) { return (fixed_bits[body / 32u] >> (body % 32u) & 1u) != 0u; }
double loaded(double force) { return is_number(dvec4(force)) ? max(0.0lf, force) : 0.0lf; }

bool pushes_b(ContactTold c) {
  const bool a = is_fixed(c.ends.x), b = is_fixed(c.ends.y);
  if (a != b) return a;
  if (abs(c.n.y) > SIDE) return c.n.y > 0.0lf;
  return abs(c.n.x) > SIDE ? c.n.x > 0.0lf : c.n.z > 0.0lf;
}
Glyph glyph_of(ContactTold c) {
  const bool b = pushes_b(c);
  const dvec3 y_b = c.y_b.xyz, n = c.n.xyz;
  return Glyph(b ? y_b : y_b - c.y_b.w * n, b ? n : -n, c.y_b.w, c.n.w);
}
bool same_pair(uvec2 x, uvec2 y) { return x == y || x == y.yx; }

// PixelMeter::at().
double meter_at(dvec3 p) {
  return parallel != 0u ? slope : slope * max(dot(p - eye, forward), 0.02lf * length(p - eye));
}

// Whether a glyph begins at contact k: one for those of the same two bodies with the same normal where there are many, or
// where they are closer together than a mark.
bool find_glyph(uint k, uint contacts, out Glyph all_) {
  const ContactTold c = told[k];
  if (!is_shown(c)) return false;
  all_ = glyph_of(c);
  const bool many = counter[PUSHING] > MANY;
  uint first = k, head = NONE;
  while (first > 0u && same_pair(told[first - 1u].ends.xy, c.ends.xy)) --first;
  double load = 0.0lf;
  bool over = false;
  for (uint j = first; j < contacts && !over; ++j) {
    const ContactTold other = told[j];
    over = !same_pair(other.ends.xy, c.ends.xy);
    if (over || other.ends.xy != c.ends.xy || !is_shown(other)) continue;
    const Glyph next = glyph_of(other);
    const double force = loaded(next.force);
    if (head == NONE || !(dot(next.towards, all_.towards) > SAME_NORMAL) ||
        !(many || length(next.at - all_.at) < MARK_WIDTH * max(scale, LEAST_SCALE * meter_at(all_.at)))) {
      over = head == k || j > k;
      if (over) continue;
      all_ = Glyph(next.at, next.towards, next.d, force);
      load = force + NO_FORCE;
      head = j;
      continue;
    }
    load += force + NO_FORCE;
    all_.at += (force + NO_FORCE) / load * (next.at - all_.at);
    all_.d = min(all_.d, next.d);
    all_.force += force;
  }
  return head == k;
}

double log_10(double x) {
  int power;
  double m = frexp(x, power);
  if (m < 0.70710678118654752lf) {
    m *= 2.0lf;
    --power;
  }
  const double s = (m - 1.0lf) / (m + 1.0lf), s2 = s * s;
  double sum = 0.0lf;
  for (int k = 21; k > 0; k -= 2) sum = sum * s2 + 1.0lf / double(k);
  return (double(power) * 0.69314718055994531lf + 2.0lf * s * sum) * 0.43429448190325183lf;
}

// Of six pieces, as add_contact() has them: discs, cylinders, cones, each its rim and itself.
Piece piece_of(Glyph g, uint piece) {
  const double s = scale;
  const dvec3 n = g.towards, away = normalize(g.at - eye);
  const bool rim = piece % 2u == 0u;
  if (piece < 2u) return rim ? Piece(g.at + 0.3lf * RIM * s * away, s + RIM * s, s + RIM * s) : Piece(g.at, s, s);
  const double length_ = s * min(LONGEST, 4.5lf * log_10(1.0lf + 9.0lf * loaded(g.force) / weight));
  if (length_ < SHORTEST * s) return Piece(g.at, 0.0lf, 0.0lf);
  const double wide = clamp(LEAST_SCALE * meter_at(g.at), s, MOST_GROWN * s), r = RIM * wide;
  const double head = min(HEAD_LENGTH * wide, 0.6lf * length_);
  const double half_ = min(HEAD * wide, HEAD / HEAD_LENGTH * head * min(wide / s, BLUNTEST));
  if (piece < 4u) {
    const dvec3 middle = g.at + 0.5lf * (length_ - head) * n;
    const double shaft = min(SHAFT * wide, 0.6lf * half_);
    return rim ? Piece(middle + 2.0lf * (shaft + r) * away, shaft + 0.6lf * r, 0.5lf * (length_ - head))
               : Piece(middle, shaft, 0.5lf * (length_ - head));
  }
  const dvec3 base = g.at + (length_ - head) * n;
  return rim ? Piece(base - 0.6lf * r * n + 2.0lf * (half_ + r) * away, half_ + 0.9lf * r, head + 1.6lf * r)
             : Piece(base, half_, head);
}

uint class_of(Piece p, uint piece) {
  const vec3 at = vec3(p.at);
  const float scale_ = float(max(p.across, p.along));
  if (!(scale_ > 0.0) || !in_sight(at, 1.0001 * length(vec2(p.across, p.along)))) return NO_CLASS;
  return piece / 2u * LEVELS_EACH + level_of(pixels_of(at, scale_));
}

#ifdef COUNT
void main() {
  const uint k = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  if (t < CLASSES) count_here[t] = 0u;
  barrier();
  const uint contacts = counter[OVERFLOW] == 0u ? min(counter[CONTACTS], uint(told.length())) : 0u;
  Glyph g;
  uint classes = NO_GLYPH;
  if (k < contacts && find_glyph(k, contacts, g)) {
    classes = 0u;
    for (uint piece = 0u; piece < 6u; ++piece) {
      const uint found = class_of(piece_of(g, piece), piece);
      classes |= found << (5u * piece);
      if (found != NO_CLASS) atomicAdd(count_here[found], 1u);
    }
  }
  if (k < told.length()) glyph_classes[k] = classes;
  barrier();
  if (t < CLASSES) group_first[t * work_groups + gl_WorkGroupID.x] = count_here[t];
}
#else
layout(std430, binding = DRAW_KNOTS) readonly buffer DrawKnots { dvec4 knot[]; };  // x of the contact map; its colour
layout(std430, binding = DRAW_BODIES) writeonly buffer DrawBodies { float marks_out[]; };

// contact_color().
vec3 color_at(double x) {
  uint above = 0u;
  while (above < KNOTS && knot[above].x < x) ++above;
  if (above == 0u || above == KNOTS) return vec3(knot[min(above, KNOTS - 1u)].yzw);
  const vec3 lo = vec3(knot[above - 1u].yzw), hi = vec3(knot[above].yzw);
  return lo + float((x - knot[above - 1u].x) / (knot[above].x - knot[above - 1u].x)) * (hi - lo);
}

// place_along().
void write(uint place, Piece p, dvec3 axis, vec3 color) {
  const dvec3 across = abs(axis.x) < 0.9lf ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
  const dvec3 z = normalize(cross(across, axis)), x = cross(axis, z);
  const vec3 columns[4] = vec3[4](vec3(p.across * x), vec3(p.along * axis), vec3(p.across * z), vec3(p.at));
  for (uint r = 0u; r < 3u; ++r) {
    for (uint k = 0u; k < 4u; ++k) marks_out[17u * place + 4u * r + k] = columns[k][r];
    marks_out[17u * place + 12u + r] = color[r];
  }
  marks_out[17u * place + 15u] = 1.0;
  marks_out[17u * place + 16u] = 0.0;  // flat colour
}

void main() {
  const uint k = gl_GlobalInvocationID.x, t = gl_LocalInvocationID.x;
  const uint classes = k < told.length() ? glyph_classes[k] : NO_GLYPH;
  here[t] = classes;
  barrier();
  if (classes == NO_GLYPH) return;
  Glyph g;
  find_glyph(k, counter[CONTACTS], g);
  const vec3 color = color_at(g.d / d_hat);
  for (uint piece = 0u; piece < 6u; ++piece) {
    const uint mine = classes >> (5u * piece) & 31u, rim = piece & ~1u;
    if (mine == NO_CLASS) continue;
    uint before = piece != rim && (classes >> (5u * rim) & 31u) == mine ? 1u : 0u;
    for (uint j = 0u; j < t; ++j)
      before += uint((here[j] >> (5u * rim) & 31u) == mine) + uint((here[j] >> (5u * rim + 5u) & 31u) == mine);
    write(group_first[mine * work_groups + gl_WorkGroupID.x] + before, piece_of(g, piece), g.towards,
          piece == rim ? RIM_INK : color);
  }
}
#endif
#endif
