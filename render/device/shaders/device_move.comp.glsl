// SPDX-License-Identifier: MIT
// The step is made: bodies are where it ends. A thread a body. To be run when all else is known.
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.bodies || counters.overflow != 0u || kinds[kind_number[i]].fixed_ != 0) return;
  const Outcome o = outcome[i];
  pose[i].c.xyz += dvec3(o.u.xyz);
  pose[i].q = turned_pose(pose[i].q, o.q);
  motion[i] = Motion(o.v, o.omega);
}
