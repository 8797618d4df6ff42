// SPDX-License-Identifier: MIT
// The inertia part of E for one body: sim/solver/inertia.h. With W = R* J R*ᵀ, I* = tr(W) 1 − W and E = R R*ᵀ, which is the
// quaternion (v, w), all that is small is said in v: it keeps its digits. (As a sum over the entries of (E − 1) W, whose
// terms of first order cancel, one driver makes something else of it.)
//   tr[(E − 1) W] = −2 v·I* v,   axial(X) = −2 (w I* v + v × I* v)   of X = R* J Rᵀ = W Eᵀ

real4 turn_since_flight(Flight f, Place at) { return product(at.q, conjugate(f.q)); }

real3 inertia_times(Flight f, real3 v) {
  const real3 d = f.W_diag.xyz;
  return times_symmetric(d.x + d.y + d.z - d, -f.W_off.xyz, v);
}

real3 axial_inertia(Flight f, Place at) {
  const real4 e = turn_since_flight(f, at);
  const real3 Iv = inertia_times(f, e.xyz);
  return -2 * (e.w * Iv + cross(e.xyz, Iv));
}

real inertia_energy(Flight f, Place at, real inv_h2) {
  const real3 away = at.u.xyz - f.u.xyz, v = turn_since_flight(f, at).xyz;
  return inv_h2 * (f.W_diag.w * dot(away, away) / 2 + 2 * dot(v, inertia_times(f, v)));
}
