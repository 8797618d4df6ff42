// SPDX-License-Identifier: MIT
// Contacts in the order of their pairs, with what their pair remembers (sim/solver/friction.cpp, recovery.cpp): a
// thread a pair.

// Of two bodies: friction_between of sim/solver/friction.cpp.
double friction_of(uint i, uint j, bool slides) {
  const double usual = slides ? params.mu_dynamic : params.mu_static;
  if (params.friction_rule < 0) return usual;
  const double of_i = slides ? kinds[kind_number[i]].mu_dynamic : kinds[kind_number[i]].mu_static;
  const double of_j = slides ? kinds[kind_number[j]].mu_dynamic : kinds[kind_number[j]].mu_static;
  if (of_i < 0 && of_j < 0) return usual;
  const double a = of_i < 0 ? usual : of_i, b = of_j < 0 ? usual : of_j;
  if (params.friction_rule == GEOMETRIC_MEAN) return sqrt(a * b);
  if (params.friction_rule == AVERAGE) return (a + b) / 2;
  if (params.friction_rule == MIN) return min(a, b);
  return params.friction_rule == MAX ? max(a, b) : a * b;
}

void main() {
  const uint p = gl_GlobalInvocationID.x;
  if (p == 0u) counters.contacts = contact_first[params.pair_room];
  if (p >= counters.pairs || counters.overflow != 0u) return;
  const uint from = pairs[p].first, count = pairs[p].count & 0xffffu, to = contact_first[p];
  const uint emitter = pairs[p].emitter, other = pairs[p].other;
  uint flags = 0u, kept_at = 0u, kept_count = 0u;
  uint kept = kept_pair(emitter, other);
  if (kept == NO_PAIR) kept = kept_pair(other, emitter);
  if (kept != NO_PAIR) {
    kept_at = kept_pairs[kept].first;
    kept_count = kept_pairs[kept].count & 0xffffu;
    flags = kept_pairs[kept].count >> 16;
  }
  const real d_hat = real(params.d_hat);
  real closest = real(1e30);
  for (uint k = 0u; k < count; ++k) closest = min(closest, raw[from + k].n.w);
  const bool starts = params.first_step != 0;
  bool recovers = (flags & RECOVERS) != 0u || closest < -2 * d_hat ||
                  (starts && closest >= -d_hat / 1000 && closest < d_hat / 2);
  recovers = recovers && params.recovery_speed > 0;
  flags = (flags & SLIDES) | (recovers ? RECOVERS : 0u);
  const real mu = real(friction_of(emitter, other, (flags & SLIDES) != 0u));
  for (uint k = 0u; k < count; ++k) {
    Contact c = raw[from + k];
    c.before.w = mu;
    for (uint m = kept_at; m < kept_at + kept_count; ++m) {
      if (kept_feature[m] != c.id.z || kept_stretch[m].w == 0) continue;
      real3 stretch = kept_stretch[m].xyz;
#ifdef ROUND
      if (c.round_.x == 0)
#endif
        stretch = real3(matrix_of(pose[c.id.x].q) * dvec3(stretch));
      c.before.xyz += stretch - c.n.xyz * dot(c.n.xyz, stretch);
    }
    const real d = c.n.w, end = d_hat - way(d);
    if (recovers && d < end) {
      c.r_b.w = end - d;
      c.apart.w = normal_push(d).first / normal_push(end).first;
    }
    contacts[to + k] = c;
  }
  if (count > 0u) {
    if (kinds[kind_number[emitter]].fixed_ == 0) atomicAdd(end_first[emitter], count);
    if (kinds[kind_number[other]].fixed_ == 0) atomicAdd(end_first[other], count);
  }
  if (closest < d_hat) flight[emitter].v.w = flight[other].v.w = 1;
  pairs[p].first = to;
  pairs[p].count = count | flags << 16;
}
