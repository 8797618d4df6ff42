// SPDX-License-Identifier: MIT
// compound_contacts.cpp: bodies of several hulls, each part as a hull of its own.
#define PARTS
const uint MOST_PARTS = 64u;

double part_radius(uint shape) {
  dvec4 size = shapes[shape].size;
  uint kind = shapes[shape].kind;
  return kind == uint(BOX)       ? sqrt(dot(size.xyz, size.xyz))
         : kind == uint(CAPSULE) ? size.x + 0.5lf * size.y
                                 : size.x;
}

// Of parts, or of what is no compound.
bool parts_may_meet(uint shape_a, dvec3 c_a, uint shape_b, dvec3 c_b, double reach) {
  if (shapes[shape_a].kind == uint(PLANE) || shapes[shape_b].kind == uint(PLANE)) return true;
  double near = part_radius(shape_a) + part_radius(shape_b) + reach;
  dvec3 way = c_b - c_a;
  return dot(way, way) <= near * near;
}

// 64-bit numbers: low half, high half.
uvec2 times_64(uvec2 x, uvec2 y) {
  uint high, low;
  umulExtended(x.x, y.x, high, low);
  return uvec2(low, high + x.x * y.y + x.y * y.x);
}
uvec2 shifted_right(uvec2 x, int by) { return uvec2(x.x >> by | x.y << (32 - by), x.y >> by); }
uvec2 mixed_64(uvec2 x) {
  x = times_64(x ^ shifted_right(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
  x = times_64(x ^ shifted_right(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
  return x ^ shifted_right(x, 31);
}

// Of a contact between parts k_a and k_b of the two bodies, the first of which may be a compound or not.
uint part_name(uint shape_a, uint k_a, uint k_b, uint feature) {
  uint part = shapes[shape_a].kind == uint(COMPOUND) ? MOST_PARTS * k_b + k_a : k_b;
  uint carry, low = uaddCarry(feature, 0x7f4a7c15u, carry);
  return mixed_64(uvec2(low, part + 0x9e3779b9u + carry)).x & 0x3fffffffu;
}
