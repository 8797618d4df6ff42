// SPDX-License-Identifier: MIT
// A Gaussian along one axis: eleven taps over ±3 σ.
in vec2 uv;
uniform sampler2D map;
uniform vec2 step_size;  // 0.6 σ along one axis
out vec4 fragment;
void main() {
  float sum = 0.0, total = 0.0;
  for (int i = -5; i <= 5; ++i) {
    float t = 0.6 * float(i);
    float w = exp(-0.5 * t * t);
    sum += w * texture(map, uv + step_size * float(i)).r;
    total += w;
  }
  fragment = vec4(sum / total);
}
