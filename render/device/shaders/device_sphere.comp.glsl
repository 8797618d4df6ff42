// SPDX-License-Identifier: MIT
// What moving bodies span along the axes of the world, or with RADIUS how far from a centre: a thread a body. Floats are
// kept as bits in their order, lowest ones negated, so that all are maxima of what is 0 at first. Needs device_draw_pose.
layout(local_size_x = GROUP) in;

// A piece of a body, in the body frame (render/visual/body_parts.h); m.
struct Piece {
  vec4 at;
  vec4 size;
  uint form, first, count, pad_;  // form: Primitive; of a mesh: its corners
};
layout(std430, binding = DRAW_PARTS) readonly buffer DrawPieces { Piece pieces[]; };
layout(std430, binding = DRAW_RANGES) readonly buffer DrawRanges { uint piece_range[]; };  // a body: first · 256 + count
layout(std430, binding = DRAW_REACHES) readonly buffer DrawReaches { float reach[]; };     // 0: does not count
layout(std430, binding = DRAW_MESHES) readonly buffer DrawCorners { vec4 corners[]; };
layout(std430, binding = DRAW_BOUNDS) buffer DrawSpan {
  dvec4 centre;
  uint bodies, radius;  // largest, as the bits of a float
  uint edge[6];         // -lowest, highest
};
shared uint edge_here[6], radius_here;

// Along the axis with that row of the body's matrix: the lowest and the highest from the piece's own place.
dvec2 span(Piece p, dvec3 row) {
  const dvec3 scaled = row * dvec3(p.size.xyz);
  if (p.form == CUBE) {
    const double all = abs(scaled.x) + abs(scaled.y) + abs(scaled.z);
    return dvec2(-all, all);
  }
  if (p.form == SPHERE || p.form == HEMISPHERE) {  // two halves of a capsule are two balls
    const double all = sqrt(dot(scaled, scaled));
    return dvec2(-all, all);
  }
  if (p.form == MESH) {
    double lowest = 0.0lf, highest = 0.0lf;  // the centre of mass is inside
    for (uint k = p.first; k < p.first + p.count; ++k) {
      const double at = dot(scaled, dvec3(corners[k].xyz));
      lowest = min(lowest, at);
      highest = max(highest, at);
    }
    return dvec2(lowest, highest);
  }
  const double rim = sqrt(scaled.x * scaled.x + scaled.z * scaled.z), up = scaled.y;
  if (p.form == CONE) return dvec2(min(-rim, up), max(rim, up));
  return dvec2(-rim - abs(up), rim + abs(up));  // a cylinder
}

void main() {
  const uint t = gl_LocalInvocationID.x, body = gl_GlobalInvocationID.x;
  if (t < 6u) edge_here[t] = 0u;
  if (t == 0u) radius_here = 0u;
  barrier();
  const bool counts = body < bodies && reach[min(body, bodies - 1u)] > 0.0 && is_finite(pose[body].c) && is_finite(pose[body].q);
  if (counts) {
#ifdef RADIUS
    const dvec3 way = pose[body].c.xyz - centre.xyz;
    atomicMax(radius_here, floatBitsToUint(float(sqrt(dot(way, way)) + double(reach[body]))));
#else
    const dmat3 R = matrix_of(pose[body].q);
    const uint range = piece_range[body], first = range >> 8u, end = first + (range & 255u);
    for (uint k = first; k < end; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        const dvec3 row = dvec3(R[0][axis], R[1][axis], R[2][axis]);
        const double at = pose[body].c[axis] + dot(row, dvec3(pieces[k].at.xyz));
        const dvec2 wide = span(pieces[k], row);
        atomicMax(edge_here[2 * axis], ordered_bits(float(-at - wide.x)));
        atomicMax(edge_here[2 * axis + 1], ordered_bits(float(at + wide.y)));
      }
    }
#endif
  }
  barrier();
  if (t < 6u && edge_here[t] != 0u) atomicMax(edge[t], edge_here[t]);
  if (t == 0u && radius_here != 0u) atomicMax(radius, radius_here);
}
