// SPDX-License-Identifier: MIT
// The inertia part of E for one body: sim/solver/inertia.h. With E = R R*ᵀ and W = R* J R*ᵀ, X = R* J Rᵀ = W Eᵀ; all
// is said with E − 1, which keeps its digits.

// (E − 1) W of a body at a place.
mat_real3 turned_inertia(Flight f, Place at) {
  const real3 d = f.W_diag.xyz, o = f.W_off.xyz;
  const mat_real3 W = mat_real3(d.x, o.x, o.y, o.x, d.y, o.z, o.y, o.z, d.z);
  return matrix_less(product(at.q, conjugate(f.q))) * W;
}
// (X₃₂ − X₂₃, X₁₃ − X₃₁, X₂₁ − X₁₂) of X = W + Gᵀ, G = (E − 1) W.
real3 axial_of(mat_real3 G) {
  return real3(G[2][1] - G[1][2], G[0][2] - G[2][0], G[1][0] - G[0][1]);
}
real inertia_energy(Flight f, Place at, real inv_h2) {
  const real3 away = at.u.xyz - f.u.xyz;
  const mat_real3 G = turned_inertia(f, at);
  return inv_h2 * (f.W_diag.w * dot(away, away) / 2 - (G[0][0] + G[1][1] + G[2][2]));
}
