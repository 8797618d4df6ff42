// SPDX-License-Identifier: MIT
// solid.cpp: the facets of cylinders and cones, turned about their axis towards what they touch. In double, as poses are.
#define SOLIDS
const double UPRIGHT = 0.05lf, AXES_MEET = 1e-9lf;
const double ROUND_SIDE = 0.5lf;
const uint FACETS = 32u;
const double COS_FACET = 0.9951847266721969lf, SIN_FACET = 0.0980171403295606lf;  // of π/32

bool is_solid(uint shape) { return shapes[shape].ends != 0u; }

// Height and radius of the lower end, then of the upper one.
dvec4 ends_of(uint shape) {
  uint at = shapes[shape].ends;
  return dvec4(hull_words[at], hull_words[at + 1u], hull_words[at + 2u], hull_words[at + 3u]);
}

// Largest u·x of the solid, in its frame.
double solid_support(dvec4 ends, dvec3 u) {
  double across = sqrt(u.x * u.x + u.z * u.z);
  return max(ends.x * u.y + ends.y * across, ends.z * u.y + ends.w * across);
}

// How far inside the round surface the facets lie, at most.
double facet_depth(uint shape) {
  if (!is_solid(shape)) return 0;
  dvec4 ends = ends_of(shape);
  return max(ends.y, ends.w) * (1 - COS_FACET);
}

struct Axis {
  dvec3 middle, along;
  double half_length;
};

// Of a solid, a capsule or a ball.
Axis axis_of(uint shape, dvec3 c, dmat3 R) {
  if (is_solid(shape)) {
    dvec4 ends = ends_of(shape);
    return Axis(c + 0.5lf * (ends.x + ends.z) * R[1], R[1], 0.5lf * (ends.z - ends.x));
  }
  bool is_capsule = shapes[shape].kind == uint(CAPSULE);
  return Axis(c, R[1], is_capsule ? 0.5lf * shapes[shape].size.y : 0.0lf);
}

// Between the nearest points of two axes; zero where they meet.
dvec3 between_axes(Axis a, Axis b) {
  dvec3 w = a.middle - b.middle;
  double uv = dot(a.along, b.along), uw = dot(a.along, w), vw = dot(b.along, w);
  double sine2 = 1.0lf - uv * uv;
  double s = sine2 > 1e-6lf ? clamp((uv * vw - uw) / sine2, -a.half_length, a.half_length) : 0.0lf;
  double t = clamp(uv * s + vw, -b.half_length, b.half_length);
  s = clamp(uv * t - uw, -a.half_length, a.half_length);
  dvec3 way = t * b.along - s * a.along - w;
  bool meet = !(sqrt(dot(way, way)) > AXES_MEET * (a.half_length + b.half_length + sqrt(dot(w, w))));
  return meet ? dvec3(0) : way;
}

// Against the normal of that face of a polyhedron which is farthest from the solid, or least deep in it; w: how far.
dvec4 towards_face(uint solid, dvec3 c, dmat3 R, uint other, dvec3 c_other, dmat3 R_other) {
  ShapeRecord record = shapes[other];
  dvec4 ends = ends_of(solid);
  bool is_box = record.kind == uint(BOX);
  uint face = record.first + 3u * record.vertices;
  dvec4 towards = dvec4(0, -1, 0, -1e300lf);
  for (uint f = 0u; f < record.faces; ++f) {
    uint word = face + 5u * f;
    dvec3 own = dvec3(hull_words[word], hull_words[word + 1u], hull_words[word + 2u]), n = R_other * own;
    double offset = is_box ? dot(abs(own), record.size.xyz) : hull_words[word + 3u];
    double apart = dot(n, c - c_other) - offset - solid_support(ends, -(n * R));
    if (apart > towards.w) towards = dvec4(-n, apart);
  }
  return towards;
}

// The same of that part of a compound, or of a box or a hull, which is nearest.
dvec3 towards_nearest_part(uint solid, dvec3 c, dmat3 R, uint other, dvec3 c_other, dmat3 R_other) {
  dvec4 nearest = dvec4(0, -1, 0, 1e300lf);
  for (uint k = 0u; k < parts_of(other); ++k) {
    dvec3 c_part = c_other;
    uint part = part_of(other, k, c_part, R_other);
    dvec4 face = towards_face(solid, c, R, part, c_part, R_other);
    if (face.w < nearest.w) nearest = face;
  }
  return nearest.xyz;
}

// Turns R of each of the two that is a solid to where its facets stand.
void turn_facets(uint shape_a, dvec3 c_a, inout dmat3 R_a, uint shape_b, dvec3 c_b, inout dmat3 R_b) {
  dmat3 turned_a = R_a;
  for (int side = 0; side < 2; ++side) {
    bool second = side == 1;
    uint solid = second ? shape_b : shape_a, other = second ? shape_a : shape_b;
    dvec3 c = second ? c_b : c_a, c_other = second ? c_a : c_b;
    dmat3 R = second ? R_b : R_a, R_other = second ? R_a : R_b;
    if (!is_solid(solid)) continue;
    uint kind = shapes[other].kind;
    dvec3 towards;
    if (kind == uint(PLANE)) {
      towards = -shapes[other].size.xyz;
    } else if (kind == uint(SPHERE) || kind == uint(CAPSULE) || is_solid(other)) {
      towards = between_axes(axis_of(solid, c, R), axis_of(other, c_other, R_other));
    } else {
      towards = towards_nearest_part(solid, c, R, other, c_other, R_other);
    }
    dvec3 u = towards * R;
    double across = sqrt(u.x * u.x + u.z * u.z);
    if (!(across > UPRIGHT * sqrt(dot(u, u)))) continue;
    double cosine = is_solid(other) ? COS_FACET : 1.0lf, sine = is_solid(other) ? SIN_FACET : 0.0lf;
    double x = (u.x * cosine - u.z * sine) / across, z = (u.z * cosine + u.x * sine) / across;
    dmat3 turned = dmat3(x * R[0] + z * R[2], R[1], x * R[2] - z * R[0]);
    if (second) R_b = turned;
    else turned_a = turned;
  }
  R_a = turned_a;
}
