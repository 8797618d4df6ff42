// SPDX-License-Identifier: MIT
// The gradient behind everything.
out vec4 fragment;
void main() {
  float t = smoothstep(0.0, 1.0, gl_FragCoord.y / frame.viewport.y);
  vec4 far = mix(frame.background_bottom, frame.background_top, t);
  fragment = vec4(far.rgb + far.a * part_of_level(), 0.0);
}
