// SPDX-License-Identifier: MIT
// The transfer function of sRGB (IEC 61966-2-1), within a tenth of a byte. Needs mean(at).
out vec4 fragment;
void main() {
  vec3 x = mean(ivec2(gl_FragCoord.xy));
  // 1.055 x^(1/2.4) − 0.055 by roots, which are cheap where powers are not.
  vec3 root = sqrt(x);
  vec3 curve = -0.0769068 + 0.8337284 * root + 0.2981258 * sqrt(root) - 0.0553054 * x;
  fragment = vec4(mix(curve, 12.92 * x, lessThanEqual(x, vec3(0.0031308))), 1.0);
}
