// SPDX-License-Identifier: MIT
// From how many there are of each class: where each begins, and the commands that draw them; of casters a second time, with
// the opposite sides of cubes. A thread a list; one work group.
struct Command {
  uint indices, instances, first_index;
  int first_vertex;
  uint first_instance;
};
layout(std430, binding = DRAW_COUNTS) buffer DrawCounts { uint class_count[]; };  // becomes the first of each
layout(std430, binding = DRAW_MESHES) readonly buffer DrawMeshes { uvec2 mesh_range[]; };  // a class: indices, first; then opposite
layout(std430, binding = DRAW_COMMANDS) writeonly buffer DrawCommands { Command commands[]; };

void main() {
  const uint list = gl_LocalInvocationID.x;
  if (list >= LISTS) return;
  uint first = 0u;
  for (uint k = 0u; k < CLASSES; ++k) {
    const uint at = list * CLASSES + k, count = class_count[at];
    commands[at] = Command(mesh_range[k].x, count, mesh_range[k].y, 0, first);
    if (list == 1u)
      commands[LISTS * CLASSES + k] = Command(mesh_range[CLASSES + k].x, count, mesh_range[CLASSES + k].y, 0, first);
    class_count[at] = first;
    first += count;
  }
}
