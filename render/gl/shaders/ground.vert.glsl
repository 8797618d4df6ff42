// SPDX-License-Identifier: MIT
// A quad in the plane of a floor.
layout(location = 0) in vec3 position;
out vec3 world;
void main() {
  world = position;
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
}
