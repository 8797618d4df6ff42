// SPDX-License-Identifier: MIT
// Between sweeps, one thread: how much the last one moved, and whether there is more to do.
uniform vec4 tolerance;  // of the residual; of friction
uniform int last_;  // no sweep follows
void main() {
  if (counters.done != 0u || counters.overflow != 0u) return;
  ++counters.sweeps;
  const float residual = uintBitsToFloat(counters.residual);
  if (residual < tolerance.x && uintBitsToFloat(counters.unsettled) < tolerance.y) {
    counters.done = 1u;
    for (uint list = 0u; list < SWEEP_LISTS; ++list) arguments[list].x = 0u;
  } else if (last_ == 0) {
    counters.residual = counters.unsettled = 0u;
  }
}
