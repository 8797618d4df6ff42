// SPDX-License-Identifier: MIT
// The whole map.
out vec2 uv;
void main() {
  uv = 0.5 * corner() + 0.5;
  gl_Position = vec4(corner(), 0.0, 1.0);
}
