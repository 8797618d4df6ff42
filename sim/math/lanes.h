// SPDX-License-Identifier: MIT
// Four numbers side by side: the points of a contact manifold are evaluated together. GCC and Clang vector
// extensions, so that every machine gets its own instructions and the same results.
#pragma once

#include <cmath>

#include "sim/math/types.h"

namespace pabd {

inline constexpr int kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
using LaneMask = long long __attribute__((vector_size(kLanes * sizeof(double))));

inline Lanes lanes(double x) { return Lanes{x, x, x, x}; }
inline double sum(Lanes v) { return (v[0] + v[1]) + (v[2] + v[3]); }
// The four sums side by side: (sum(a), sum(b), sum(c), sum(d)), bit for bit.
inline Lanes sums(Lanes a, Lanes b, Lanes c, Lanes d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}
inline Lanes sqrt(Lanes v) {
  return Lanes{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}

inline Lanes select(LaneMask condition, Lanes yes, Lanes no) { return condition ? yes : no; }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
template <class T>
T larger(T a, T b) {
  return select(a > b, a, b);
}
template <class T>
T smaller(T a, T b) {
  return select(a < b, a, b);
}

// A vector of R³ in every lane.
struct Vec3x {
  Lanes x, y, z;
};

inline Vec3x spread(const Vec3& v) { return {lanes(v.x()), lanes(v.y()), lanes(v.z())}; }
inline Vec3 lane(const Vec3x& v, int k) { return {v.x[k], v.y[k], v.z[k]}; }
inline void set_lane(Vec3x& v, int k, const Vec3& value) {
  v.x[k] = value.x();
  v.y[k] = value.y();
  v.z[k] = value.z();
}

inline Vec3x operator+(const Vec3x& a, const Vec3x& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3x operator-(const Vec3x& a, const Vec3x& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3x operator*(Lanes s, const Vec3x& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Lanes dot(const Vec3x& a, const Vec3x& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3x cross(const Vec3x& a, const Vec3x& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// R v in every lane.
inline Vec3x rotate(const Mat3& R, const Vec3x& v) {
  return {R(0, 0) * v.x + R(0, 1) * v.y + R(0, 2) * v.z,  //
          R(1, 0) * v.x + R(1, 1) * v.y + R(1, 2) * v.z,  //
          R(2, 0) * v.x + R(2, 1) * v.y + R(2, 2) * v.z};
}
inline Vec3 sum(const Vec3x& v) { return {sum(v.x), sum(v.y), sum(v.z)}; }

}  // namespace pabd
