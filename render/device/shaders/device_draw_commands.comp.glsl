// SPDX-License-Identifier: MIT
// From how many there are of each class: where each begins, and the commands that draw them; of casters a second time, with
// the opposite sides of cubes. A thread a list; one work group.
//   REVEAL   of the one list that is revealed: its instances follow those that were drawn before
struct Command {
  uint indices, instances, first_index;
  int first_vertex;
  uint first_instance;
};
layout(std430, binding = DRAW_COUNTS) buffer DrawCounts { uint class_count[]; };  // becomes the first of each
layout(std430, binding = DRAW_MESHES) readonly buffer DrawMeshes { uvec2 mesh_range[]; };  // a class: indices, first; then opposite
layout(std430, binding = DRAW_COMMANDS) writeonly buffer DrawCommands { Command commands[]; };

void main() {
#ifdef REVEAL
  const uint which = drawn_list, to = LISTS + 1u + which, opposite = LISTS + 3u;
  if (gl_LocalInvocationID.x != 0u) return;
  uint first = drawn[which];
#else
  const uint which = gl_LocalInvocationID.x, to = which, opposite = LISTS;
  if (which >= LISTS) return;
  uint first = 0u;
#endif
  for (uint k = 0u; k < CLASSES; ++k) {
    const uint at = which * CLASSES + k, count = class_count[at];
    commands[to * CLASSES + k] = Command(mesh_range[k].x, count, mesh_range[k].y, 0, first);
    if (which == 1u)
      commands[opposite * CLASSES + k] = Command(mesh_range[CLASSES + k].x, count, mesh_range[CLASSES + k].y, 0, first);
    class_count[at] = first;
    first += count;
  }
#ifndef REVEAL
  drawn[which] = first;
#endif
}
