// SPDX-License-Identifier: MIT
// The transfer function of sRGB (IEC 61966-2-1). Needs mean(at).
out vec4 fragment;
void main() {
  vec3 x = mean(ivec2(gl_FragCoord.xy));
  vec3 curve = 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055;
  fragment = vec4(mix(curve, 12.92 * x, lessThanEqual(x, vec3(0.0031308))), 1.0);
}
