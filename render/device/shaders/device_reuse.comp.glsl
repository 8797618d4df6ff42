// SPDX-License-Identifier: MIT
// Contacts of pairs that hardly moved since they were found: a thread a pair. Not of what rolls.

void main() {
  const uint p = gl_GlobalInvocationID.x;
  if (p >= counters.pairs || counters.overflow != 0u) return;
  const uint emitter = pairs[p].emitter, other = pairs[p].other;
  const BodyKind one = kinds[kind_number[emitter]], two = kinds[kind_number[other]];
  if (one.rolling > 0 || two.rolling > 0 || one.round_about_y != 0 || two.round_about_y != 0) return;
  const uint kept = kept_pair(emitter, other);
  if (kept == NO_PAIR || kept_pairs[kept].seen.w < 0) return;
  real3 x;
  real4 q;
  relative_pose(emitter, other, x, q);
  const Pair seen = kept_pairs[kept];
  const real4 turn = product(q, conjugate(seen.turned));
  const real size = real(max(one.bounding, two.bounding));
  const real moved = norm(x - seen.seen.xyz) + 2 * size * norm(turn.xyz), d_hat = real(params.d_hat);
  const real reach = flight[emitter].turn.w + flight[other].turn.w;
  if (!(moved < KEPT_WAY * d_hat) || reach + moved > seen.seen.w) return;

  const uint count = seen.count & 0xffffu;
  const uint at = count > 0u ? atomicAdd(counters.raw, count) : 0u;
  if (at + count > params.contact_room) atomicOr(counters.overflow, TOO_MANY_CONTACTS);
  pairs[p].first = at;
  pairs[p].count = count | KEPT_CONTACTS;
  pairs[p].seen = seen.seen;
  pairs[p].turned = seen.turned;
  contact_first[p] = count;
  atomicAdd(counters.kept, 1u);
  if (at + count > params.contact_room) return;
  for (uint k = 0u; k < count; ++k) {
    const uint feature = kept_feature[seen.first + k];
    const bool high_owns = (feature & 0x80000000u) != 0u;
    const uint a = high_owns ? max(emitter, other) : min(emitter, other), b = emitter + other - a;
    const ContactGeometry geometry = kept_geometry[seen.first + k];
    const dvec3 n = matrix_of(pose[a].q) * dvec3(geometry.plane.xyz);
    dvec3 r_b = matrix_of(pose[b].q) * dvec3(geometry.point.xyz);
    const dvec3 apart = pose[b].c.xyz - pose[a].c.xyz;
    const double start_d = dot(n, apart + r_b) - double(geometry.plane.w);
    r_b -= gap_beside_b(touching_gap(start_d), a, b) * n;
    Contact c;
    c.id = uvec4(a, b, feature, at + k);
    c.n = real4(real3(n), real(start_d));
    c.r_b = real4(real3(r_b), 0);
    c.apart = real4(real3(apart), 1);
    c.before = real4(0, 0, 0, 0);
#ifdef ROUND
    c.r_a = real4(real3(apart + r_b), 0);
    c.round_ = real4(0, 0, 0, 0);
#endif
    raw[at + k] = c;
    raw_geometry[at + k] = geometry;
  }
}
