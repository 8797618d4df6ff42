// SPDX-License-Identifier: MIT
// The gradient behind everything.
out vec4 fragment;
void main() {
  float t = smoothstep(0.0, 1.0, gl_FragCoord.y / frame.viewport.y);
  fragment = vec4(mix(frame.background_bottom.rgb, frame.background_top.rgb, t), 0.0);
}
