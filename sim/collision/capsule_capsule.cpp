// Capsule against capsule: the nearest points of the two axes, or, where the axes are parallel, the two ends
// of the stretch over which they run side by side.
//
//   u, v     axes of a and b                                         unit
//   s, t     places on the axes, |s| ≤ half_a, |t| ≤ half_b           m
//   w        c_a − c_b;  the squared distance is ‖w + s u − t v‖²      m
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {
namespace {

constexpr double kParallelSine = 0.01;  // below this angle two contacts, above it one

enum Feature : std::uint32_t { kLowEnd = 0, kHighEnd = 1, kCrossing = 2 };

}  // namespace

void capsule_capsule(const Placed<Capsule>& a, const Placed<Capsule>& b, double reach, Contacts& out) {
  const Vec3 u = a.R.col(1), v = b.R.col(1), w = a.c - b.c;
  const double half_a = 0.5 * a.shape.length, half_b = 0.5 * b.shape.length;
  const double uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const Vec3 across = u.cross(v);
  const double sine2 = across.squaredNorm();
  const bool parallel = sine2 < kParallelSine * kParallelSine;

  const auto nearest_on_b = [&](double s) { return std::clamp(uv * s + vw, -half_b, half_b); };
  const auto add = [&](double s, double t, std::uint32_t feature) {
    Vec3 fallback = parallel ? any_normal(u) : Vec3(across / std::sqrt(sine2));
    if (fallback.dot(w) > 0) fallback = -fallback;
    add_round_contact(out, a.number, b.number, a.c + s * u, a.shape.radius, b.c + t * v, b.shape.radius,
                      fallback, reach, feature);
  };

  if (parallel) {
    const double end_0 = -uv * half_b - uw, end_1 = uv * half_b - uw;  // ends of b, as places on a
    const double low = std::max(-half_a, std::min(end_0, end_1));
    const double high = std::min(half_a, std::max(end_0, end_1));
    if (high - low > 1e-3 * std::min(half_a, half_b)) {
      add(low, nearest_on_b(low), kLowEnd);
      add(high, nearest_on_b(high), kHighEnd);
      return;
    }
  }
  double s = sine2 > 1e-16 ? std::clamp((uv * vw - uw) / sine2, -half_a, half_a) : 0.0;
  const double t = nearest_on_b(s);
  s = std::clamp(uv * t - uw, -half_a, half_a);
  add(s, t, kCrossing);
}

}  // namespace pabd::narrow
