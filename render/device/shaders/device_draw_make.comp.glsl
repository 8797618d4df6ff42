// SPDX-License-Identifier: MIT
// Which parts of bodies are drawn in which lists and with which meshes, as render/gl/draw_list.cpp has it, without those
// that are out of sight. A thread a body.
//   (none)   counts each class of each list, without bodies and casters that were hidden in the frame before
//   EMIT     writes the instances, those of a class side by side, in any order
//   REVEAL   the same of one list: those that were left out and that its depths do not hide
// Both must find the same, whatever a compiler does to either: what decides is `precise`.
layout(std430, binding = DRAW_COUNTS) buffer DrawCounts { uint class_count[]; };  // list · CLASSES + class; EMIT: next
#ifdef EMIT
layout(std430, binding = DRAW_COLORS) readonly buffer DrawColors { vec4 body_color[]; };  // w: GpuInstance::shaded
layout(std430, binding = DRAW_VALUES) readonly buffer DrawValues { uint body_value[]; };  // bits of floats
layout(std430, binding = DRAW_VALUE_COLORS) readonly buffer DrawValueColors { vec4 value_color[]; };  // and of no value
layout(std430, binding = DRAW_BODIES) writeonly buffer DrawBodies { float bodies_out[]; };
layout(std430, binding = DRAW_CASTERS) writeonly buffer DrawCasters { float casters_out[]; };
layout(std430, binding = DRAW_FLOOR_CASTERS) writeonly buffer DrawFloorCasters { float floor_casters_out[]; };
#endif

shared uint here[LISTS * CLASSES];  // of this work group; EMIT: then where its next one goes

// Whether a ball meets a map whose sides go from 0 to 1; `room`: its radius there.
bool meets(vec4 row_x, vec4 row_y, vec3 at, float room) {
  precise vec2 q = vec2(dot(row_x, vec4(at, 1.0)), dot(row_y, vec4(at, 1.0)));
  return all(greaterThan(q, vec2(-room))) && all(lessThan(q, vec2(1.0 + room)));
}

// Of a cube: the three sides that face along `way`, a bit an axis. The others are hidden by them.
uint sides_along(vec3 way, dvec4 q, vec3 size) {
  precise dvec3 v = dvec3(way), t = 2.0lf * cross(v, q.xyz), in_body = v + q.w * t + cross(t, q.xyz);
  return uint(in_body.x * double(size.x) > 0.0lf) | uint(in_body.y * double(size.y) > 0.0lf) << 1u |
         uint(in_body.z * double(size.z) > 0.0lf) << 2u;
}

uvec3 with_sides(uvec3 found, Part p, vec3 at, dvec4 q) {
  if (p.sides == 0u) return found;
  const vec3 to_eye = view.eye.w != 0.0 ? view.eye.xyz - at : view.eye.xyz;
  if (found.x != NONE) found.x += sides_along(to_eye, q, p.size.xyz);
  if (found.y != NONE) found.y += sides_along(view.light[2].xyz, q, p.size.xyz);  // away from the sun
  if (found.z != NONE) found.z += sides_along(-view.floor_.xyz, q, p.size.xyz);
  return found;
}

// In each list: NONE where it is not in it.
uvec3 classes_of(Part p, vec3 at, dvec4 q) {
  uvec3 found = uvec3(NONE);
  const float scale = p.size.w, around = p.at.w;
  if (in_sight(at, around)) {
    found.x = p.first_class + min(p.levels - 1u, level_of(pixels_of(at, scale)));
  }
  precise float texels = 0.5 * scale / view.sizes.z;
  const uint coarse = level_of(texels);
  if (meets(view.shadow[0], view.shadow[1], at, around / view.sizes.w))
    found.y = p.first_class + min(p.levels - 1u, min(2u, coarse));
  precise float height = dot(view.floor_.xyz, at) - view.floor_.w;
  if (view.floor_size.y == 0.0 || height >= 3.0 * scale) return with_sides(found, p, at, q);
  if (meets(view.floor_map[0], view.floor_map[1], at, around / view.floor_size.x))
    found.z = p.first_class + min(p.levels - 1u, min(1u, coarse));
  return with_sides(found, p, at, q);
}

#if defined(REVEAL) && !defined(EMIT)
const float NOT_ROUNDING = 1e-6;  // of depths
const float SNAP = 0.1;           // pixels: corners of triangles are moved to parts of a pixel
const uint MOST_CELLS = 4u;       // along an axis, that are looked at

// Whether the depths hide all of a part: of a cube itself, else of a cube around its ball.
bool is_hidden(Part p, vec3 at, dvec4 q) {
  mat3 half_ = mat3(p.at.w);
  if (p.sides != 0u) {
    const dmat3 R = matrix_of(q);
    half_ = mat3(vec3(R[0] * double(p.size.x)), vec3(R[1] * double(p.size.y)), vec3(R[2] * double(p.size.z)));
  }
  vec2 low = vec2(1.0), high = vec2(-1.0);
  float nearest = 1.0;
  for (uint corner = 0u; corner < 8u; ++corner) {
    const vec3 way = vec3(corner & 1u, corner >> 1u & 1u, corner >> 2u) * 2.0 - 1.0;
    const vec4 x = vec4(at + half_ * way, 1.0);
    const float w = dot(to_clip[3], x);
    if (w <= 0.0) return false;  // beside or behind the eye
    const vec3 place = vec3(dot(to_clip[0], x), dot(to_clip[1], x), dot(to_clip[2], x)) / w;
    low = min(low, place.xy);
    high = max(high, place.xy);
    nearest = min(nearest, place.z);
  }
  const vec2 size = vec2(picture_size);
  const uvec2 last = cells - 1u;
  uvec2 from = min(uvec2(clamp((0.5 * low + 0.5) * size - SNAP, vec2(0.0), size)) / CELL, last),
        to = min(uvec2(clamp((0.5 * high + 0.5) * size + SNAP, vec2(0.0), size)) / CELL, last);
  uint level = 0u;
  while (any(greaterThanEqual(to - from, uvec2(MOST_CELLS)))) {
    from >>= 1u;
    to >>= 1u;
    ++level;
  }
  const uint first = first_of(level), row = cells_of(level).x;
  float depth = 0.0;
  for (uint y = from.y; y <= to.y; ++y) {
    for (uint x = from.x; x <= to.x; ++x) depth = max(depth, greatest[first + y * row + x]);
  }
  return 0.5 * nearest + 0.5 > depth + NOT_ROUNDING;
}
#endif

// The classes of those that are drawn now.
#ifdef REVEAL
uvec3 drawn_of(uint body, Part p, vec3 at, dvec4 q) {
  uvec3 found = uvec3(NONE);
  found[drawn_list] = classes_of(p, at, q)[drawn_list];
  return found;
}
#else
uvec3 drawn_of(uint body, Part p, vec3 at, dvec4 q) {
  uvec3 found = classes_of(p, at, q);
  if ((seen[body] & 1u) == 0u) found.x = NONE;
  if ((seen[body] & 2u) == 0u) found.y = NONE;
  return found;
}
#endif

#ifdef EMIT
// As ValueRange has it (render/visual/value_map.h), or the body's own where it has no place on the map: -infinity.
vec3 color_by_value(uint body, vec3 own) {
  const uint bits = body_value[body];
  if (bits == 0xff800000u) return own;
  if ((bits & 0x7f800000u) == 0x7f800000u) return value_color[VALUE_COLORS].rgb;
  const float x = clamp(uintBitsToFloat(bits), view.values.x, view.values.y);
  const float part = view.values.w != 0.0 ? log2(x / view.values.x) : x - view.values.x;
  const float at = clamp(part * view.values.z, 0.0, 1.0) * float(VALUE_COLORS - 1u);
  const uint k = min(uint(at), VALUE_COLORS - 2u);
  return mix(value_color[k].rgb, value_color[k + 1u].rgb, at - float(k));
}

#define WRITE(out_)                                                            \
  {                                                                            \
    const uint to = 17u * place;                                               \
    for (uint r = 0u; r < 3u; ++r) {                                           \
      out_[to + 4u * r] = columns[0][r];                                        \
      out_[to + 4u * r + 1u] = columns[1][r];                                   \
      out_[to + 4u * r + 2u] = columns[2][r];                                   \
      out_[to + 4u * r + 3u] = at[r];                                          \
    }                                                                          \
    for (uint k = 0u; k < 4u; ++k) out_[to + 12u + k] = k < 3u ? color[k] : 1.0; \
    out_[to + 16u] = color.w;                                                  \
  }
#endif

void main() {
  const uint t = gl_LocalInvocationID.x, body = gl_GlobalInvocationID.x;
  for (uint k = t; k < LISTS * CLASSES; k += GROUP) here[k] = 0u;
  barrier();
  const uint range = range_of(body), first = range >> 8u;
  uint end = first + (range & 255u);
#ifdef REVEAL
  const uint before = 1u << drawn_list, now = 4u << drawn_list;
  if (body < view.counts.x) {
#ifndef EMIT
    bool shows = false;
    for (uint k = first; k < end && !shows; ++k) {
      const vec3 at = place_of(parts[k], pose[body]);
      shows = classes_of(parts[k], at, pose[body].q)[drawn_list] != NONE && !is_hidden(parts[k], at, pose[body].q);
    }
    seen[body] = shows ? seen[body] | now : seen[body] & ~now;
#endif
    if ((seen[body] & (before | now)) != now) end = first;
  }
#endif
  for (uint k = first; k < end; ++k) {
    const uvec3 found = drawn_of(body, parts[k], place_of(parts[k], pose[body]), pose[body].q);
    for (uint list = 0u; list < LISTS; ++list) {
      if (found[list] != NONE) atomicAdd(here[list * CLASSES + found[list]], 1u);
    }
  }
  barrier();
  for (uint k = t; k < LISTS * CLASSES; k += GROUP) {
    if (here[k] != 0u) here[k] = atomicAdd(class_count[k], here[k]);
  }
#ifdef EMIT
  barrier();
  for (uint k = first; k < end; ++k) {
    const Part p = parts[k];
    const Pose q = pose[body];
    const vec3 at = place_of(p, q);
    const uvec3 found = drawn_of(body, p, at, q.q);
    if (found == uvec3(NONE)) continue;
    const dmat3 R = matrix_of(q.q);
    const vec3 columns[3] = vec3[3](vec3(R[0] * double(p.size.x)), vec3(R[1] * double(p.size.y)),
                                 vec3(R[2] * double(p.size.z)));
    vec4 color = body_color[body];
    if (view.counts.y != 0u) color.rgb = color_by_value(body, color.rgb);
    for (uint list = 0u; list < LISTS; ++list) {
      if (found[list] == NONE) continue;
      const uint place = atomicAdd(here[list * CLASSES + found[list]], 1u);
      if (list == 0u) WRITE(bodies_out)
      if (list == 1u) WRITE(casters_out)
      if (list == 2u) WRITE(floor_casters_out)
    }
  }
#ifdef REVEAL
  if (body < view.counts.x) seen[body] = (seen[body] & ~before) | ((seen[body] & now) != 0u ? before : 0u);
#endif
#endif
}
