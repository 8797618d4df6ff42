// SPDX-License-Identifier: MIT
// Dear ImGui's vertices, in pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
uniform vec2 scale;
uniform vec2 shift;
out vec2 at;
out vec4 tint;
void main() {
  at = uv;
  tint = color;
  gl_Position = vec4(position * scale + shift, 0.0, 1.0);
}
