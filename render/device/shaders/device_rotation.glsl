// SPDX-License-Identifier: MIT
// Quaternions (x, y, z, w), without sines: GLSL has none for double.

real norm(real3 v) {
  return sqrt(dot(v, v));
}
real norm(real4 v) {
  return sqrt(dot(v, v));
}
// Of a quaternion that is nearly one: without a root.
dvec4 unit_d(dvec4 q) {
  q *= 1.5lf - 0.5lf * dot(q, q);
  return q * (1.5lf - 0.5lf * dot(q, q));
}

real3 rotate(real4 q, real3 r) {
  return r + 2 * cross(q.xyz, cross(q.xyz, r) + q.w * r);
}
// (R − 1) r: keeps its digits however small the turn is.
real3 rotate_less(real4 q, real3 r) {
  return 2 * cross(q.xyz, cross(q.xyz, r) + q.w * r);
}
real4 product(real4 p, real4 q) {
  return real4(p.w * q.xyz + q.w * p.xyz + cross(p.xyz, q.xyz), p.w * q.w - dot(p.xyz, q.xyz));
}
real4 conjugate(real4 q) {
  return real4(-q.xyz, q.w);
}
dvec4 product_d(dvec4 p, dvec4 q) {
  return dvec4(p.w * q.xyz + q.w * p.xyz + cross(p.xyz, q.xyz), p.w * q.w - dot(p.xyz, q.xyz));
}
// Of a body that turned by q.
dvec4 turned_pose(dvec4 pose, real4 q) {
  return unit_d(product_d(unit_d(dvec4(q)), pose));
}
dmat3 matrix_of(dvec4 q) {
  const double x = q.x, y = q.y, z = q.z, w = q.w;
  return dmat3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),  //
               2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),  //
               2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y));
}
// R − 1 by columns.
mat_real3 matrix_less(real4 q) {
  const real x = q.x, y = q.y, z = q.z, w = q.w;
  return mat_real3(-2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),  //
                   2 * (x * y - z * w), -2 * (x * x + z * z), 2 * (y * z + x * w),  //
                   2 * (x * z + y * w), 2 * (y * z - x * w), -2 * (x * x + y * y));
}

// exp of a rotation vector of any length: the series for a part of it, squared.
real4 exp_turn(real3 w) {
  int halvings = 0;
  real a2 = dot(w, w) / 4;  // (angle/2)²
  while (a2 > real(0.0625lf) && halvings < 40) {
    a2 /= 4;
    ++halvings;
  }
  real scale = real(0.5lf);
  for (int k = 0; k < halvings; ++k) scale /= 2;
  // sin(a)/a and cos(a) to rounding for a ≤ 1/4.
  const real sine = 1 - a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42 * (1 - a2 / 72 * (1 - a2 / 110 * (1 - a2 / 156)))));
  const real cosine = 1 - a2 / 2 * (1 - a2 / 12 * (1 - a2 / 30 * (1 - a2 / 56 * (1 - a2 / 90 * (1 - a2 / 132)))));
  real4 q = real4(w * (scale * sine), cosine);
  for (int k = 0; k < halvings; ++k) q = product(q, q);
  return q / norm(q);
}

// The rotation vector of a quaternion, at most π long.
real3 log_turn(real4 q) {
  if (q.w < 0) q = -q;
  const real sine2 = dot(q.xyz, q.xyz);
  if (sine2 < real(1e-24lf)) return 2 * q.xyz;
  const real sine = sqrt(sine2);
  // atan(x) = 2 atan(x/(1 + √(1 + x²))), until the series is good to rounding.
  real x = sine, y = q.w;
  for (int k = 0; k < 4; ++k) {  // the angle of (y, x), halved
    y += sqrt(x * x + y * y);
  }
  const real t = x / y, t2 = t * t;
  const real series =
      1 - t2 * (real(1.0lf) / 3 - t2 * (real(1.0lf) / 5 - t2 * (real(1.0lf) / 7 - t2 * (real(1.0lf) / 9 - t2 * (real(1.0lf) / 11 - t2 / 13)))));
  return q.xyz * (32 * t * series / sine);
}

// The rotation by 2 atan(‖w‖/2) about w.
real4 cayley_turn(real3 w) {
  return real4(w / 2, 1) / sqrt(1 + dot(w, w) / 4);
}

// Of J = diag and off (xy, xz, yz).
real3 times_symmetric(real3 d, real3 o, real3 x) {
  return real3(d.x * x.x + o.x * x.y + o.y * x.z, o.x * x.x + d.y * x.y + o.z * x.z, o.y * x.x + o.z * x.y + d.z * x.z);
}
// A⁻¹ x for a symmetric regular A.
real3 solve_symmetric(real3 d, real3 o, real3 x) {
  const real c00 = d.y * d.z - o.z * o.z, c01 = o.y * o.z - o.x * d.z, c02 = o.x * o.z - o.y * d.y;
  const real c11 = d.x * d.z - o.y * o.y, c12 = o.x * o.y - d.x * o.z, c22 = d.x * d.y - o.x * o.x;
  const real det = d.x * c00 + o.x * c01 + o.y * c02;
  return times_symmetric(real3(c00, c11, c22), real3(c01, c02, c12), x) / det;
}
// M S Mᵀ of a symmetric S, M by columns: diagonal and off.
void turned_symmetric(mat_real3 M, real3 d, real3 o, out real3 diag, out real3 off) {
  const mat_real3 S = mat_real3(d.x, o.x, o.y, o.x, d.y, o.z, o.y, o.z, d.z);
  const mat_real3 T = M * S * transpose(M);
  diag = real3(T[0][0], T[1][1], T[2][2]);
  off = real3(T[1][0], T[2][0], T[2][1]);
}
dvec4 conjugate_d(dvec4 q) {
  return dvec4(-q.xyz, q.w);
}
