// SPDX-License-Identifier: MIT
// Where bodies are, for all passes that draw or measure them. std430.
struct Pose {
  dvec4 c;  // centre of mass, world; m
  dvec4 q;  // body to world: x, y, z, w
};
layout(std430, binding = DRAW_POSES) readonly buffer DrawPoses { Pose pose[]; };

// By the bits: compilers need not keep comparisons of what is no number. What floats cannot tell is none either.
bool is_finite(dvec4 v) {
  for (int k = 0; k < 4; ++k) {
    if ((unpackDouble2x32(v[k]).y & 0x7ff00000u) >= 0x46000000u) return false;  // 2^97
  }
  return true;
}

dmat3 matrix_of(dvec4 q) {
  const dvec3 t = q.xyz + q.xyz, w = q.w * t, x = q.x * t;
  const double yy = q.y * t.y, yz = q.y * t.z, zz = q.z * t.z;
  return dmat3(1.0lf - (yy + zz), x.y + w.z, x.z - w.y,  // a column
               x.y - w.z, 1.0lf - (x.x + zz), yz + w.x,  //
               x.z + w.y, yz - w.x, 1.0lf - (x.x + yy));
}

// In the order of the floats; 0 is none of them.
uint ordered_bits(float x) {
  const uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
