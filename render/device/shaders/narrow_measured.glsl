// SPDX-License-Identifier: MIT
// Contacts that were found, in double: measured again where they were found in float, and those at the side of a cylinder
// or cone put on the round side (sim/collision/round_sides.cpp, which says how).
struct Measured {
  dvec3 y_b, n;
  double d, round_a, round_b;  // round: see ContactPoint
  bool stays;                  // false: at another corner of a solid than the one that comes closest
};

#ifdef SOLIDS
const double NEARLY_AT = 1e-6lf, LEAN = 1e-5lf, LEAN_OF_SLOPE = 0.01lf, COS_NEXT_CORNER = 0.989176509964781lf;  // cos(1.5 π/32)

struct RoundSide {
  dvec4 ends;
  dvec3 c, axis;
  double slope;
};
RoundSide side_of(uint shape, dvec3 c, dmat3 R) {
  const dvec4 ends = ends_of(shape);
  return RoundSide(ends, c, R[1], (ends.w - ends.y) / (ends.z - ends.x));
}
double radius_at(RoundSide side, double t) { return side.ends.y + side.slope * (t - side.ends.x); }
bool is_of_side(RoundSide side, dvec3 n) {
  const double cosine = 1 / sqrt(1 + side.slope * side.slope);
  return abs(dot(n, side.axis) + side.slope * cosine) < LEAN + LEAN_OF_SLOPE * abs(side.slope);
}

// The surface under x: its distance and ρ. False: there is no side beside x.
bool under_side(RoundSide side, dvec3 x, out dvec3 n, out double d, out double rho) {
  const double t = dot(x - side.c, side.axis);
  const dvec3 out_ = x - side.c - t * side.axis;
  const double away = sqrt(dot(out_, out_)), cosine = 1 / sqrt(1 + side.slope * side.slope);
  d = cosine * (away - radius_at(side, t));
  rho = away / cosine - d;
  n = cosine * (out_ / max(away, 1e-300lf) - side.slope * side.axis);
  const double foot = t + d * side.slope * cosine, beyond = max(side.ends.x - foot, foot - side.ends.z);
  return beyond <= NEARLY_AT * (side.ends.z - side.ends.x) && away > NEARLY_AT * (side.ends.z - side.ends.x) && cosine >= ROUND_SIDE;
}

// Is n the normal of a face?
bool has_face(uint shape, dmat3 R, dvec3 n) {
  const double NEARLY = 1 - 1e-9lf;
  const ShapeRecord record = shapes[shape];
  const dvec3 own = n * R;
  if (record.kind == uint(PLANE)) return true;
  if (record.kind == uint(BOX)) return max(max(abs(own.x), abs(own.y)), abs(own.z)) > NEARLY;
  if (is_solid(shape)) return abs(own.y) > NEARLY;
  if (record.kind != uint(HULL)) return false;
  for (uint f = 0u; f < record.faces; ++f) {
    const uint word = record.first + 3u * record.vertices + 5u * f;
    if (dot(dvec3(hull_words[word], hull_words[word + 1u], hull_words[word + 2u]), own) > NEARLY) return true;
  }
  return false;
}

void turn_plane(RoundSide side, inout Measured m) {
  dvec3 n;
  double d, rho;
  if (!is_of_side(side, m.n) || !under_side(side, m.y_b + m.round_b * m.n, n, d, rho)) return;
  m.d = d - m.round_b;
  m.y_b += m.round_b * (m.n - n);
  m.n = n;
  m.round_a = rho;
}

void turn_normal(RoundSide side, inout Measured m) {
  dvec3 n;
  double d, rho;
  const dvec3 y_a = m.y_b - m.d * m.n;
  if (!is_of_side(side, -m.n) || !under_side(side, y_a, n, d, rho)) return;
  m.d = d;
  m.n = -n;
  m.y_b = y_a + d * m.n;
  m.round_b = rho;
}

void turn_point(RoundSide side, inout Measured m) {
  const dvec3 inward = m.n - dot(m.n, side.axis) * side.axis;
  const double sine = sqrt(dot(inward, inward)), t = dot(m.y_b - side.c, side.axis), r = radius_at(side, t);
  if (sine < ROUND_SIDE || !(r > NEARLY_AT * (side.ends.z - side.ends.x))) return;
  const dvec3 out_ = m.y_b - side.c - t * side.axis, towards = -inward / sine;
  m.stays = !(dot(out_, towards) < COS_NEXT_CORNER * sqrt(dot(out_, out_)));
  if (!m.stays) return;
  const dvec3 y = side.c + t * side.axis + r * towards;
  m.d += dot(y - m.y_b, m.n);
  m.y_b = y;
  m.round_b = r / sine;
}
#endif

// Within which contacts of two shapes are looked for so that all that are measured within `reach` are found.
wide reach_of_facets(double reach, uint shape_a, uint shape_b) {
#ifdef SOLIDS
  reach += facet_depth(shape_a) + facet_depth(shape_b);
#endif
  return wide(reach);
}

double rolling_of(uint shape) {
  const uint kind = shapes[shape].kind;
  return kind == uint(SPHERE) || kind == uint(CAPSULE) ? shapes[shape].size.x : 0;
}

// Shapes and poses of the owner a and the other body b, from the origin that y_b has.
Measured measured(FoundContact f, uint shape_a, dvec3 c_a, dmat3 R_a, uint shape_b, dvec3 c_b, dmat3 R_b) {
  Measured m;
  m.y_b = dvec3(f.y_b);
  m.n = dvec3(f.n);
  m.d = double(f.d);
#ifdef WIDE_IS_FLOAT
  m.d = measured_again(f, shape_a, c_a, R_a, shape_b, c_b, R_b, m.y_b, m.n);
#endif
  m.round_a = rolling_of(shape_a);
  m.round_b = rolling_of(shape_b);
  m.stays = true;
#ifdef SOLIDS
  const bool both = is_solid(shape_a) && is_solid(shape_b);
  if (is_solid(shape_a) && !both) turn_plane(side_of(shape_a, c_a, R_a), m);
  if (is_solid(shape_b)) {
    const RoundSide side = side_of(shape_b, c_b, R_b);
    if (has_face(shape_a, R_a, m.n) || (both && is_of_side(side_of(shape_a, c_a, R_a), m.n))) turn_point(side, m);
    else turn_normal(side, m);
  }
  if (both) {
    const bool stayed = m.stays;
    turn_plane(side_of(shape_a, c_a, R_a), m);
    if (m.round_a > 0 && m.round_b > 0) turn_point(side_of(shape_b, c_b, R_b), m);
    m.stays = stayed;
  }
#endif
  return m;
}
