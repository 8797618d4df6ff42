#include "sim/solver/free_flight.h"

#include <Eigen/Dense>

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"

namespace pabd {
namespace {

bool is_isotropic(const Mat3& J) { return J == Mat3(J(0, 0) * Mat3::Identity()); }

}  // namespace

void free_flight(const Mat3& J, const Vec3& gravity, double h, Pose& pose, Vec3& v, Vec3& omega) {
  v += h * gravity;
  pose.c += h * v;
  Mat3& R = pose.R;
  if (omega.isZero(0)) return;
  if (is_isotropic(J)) {  // ω is constant
    R = reorthonormalized(exp_so3(h * omega) * R);
    return;
  }
  const Mat3 I = inertia_tensor(J);
  const Mat3 inverse = I.inverse();
  const Vec3 L = R * (I * (R.transpose() * omega));
  // ω_m = R_m I⁻¹ R_mᵀ L at the midpoint R_m = exp(h ω_m / 2) R: a contraction for h ω < 1.
  Vec3 midpoint = omega;
  for (int i = 0; i < 8; ++i) {
    const Mat3 R_m = exp_so3(0.5 * h * midpoint) * R;
    const Vec3 next = R_m * (inverse * (R_m.transpose() * L));
    const bool done = (next - midpoint).squaredNorm() < 1e-28 * next.squaredNorm();
    midpoint = next;
    if (done) break;
  }
  R = reorthonormalized(exp_so3(h * midpoint) * R);
  omega = R * (inverse * (R.transpose() * L));
}

}  // namespace pabd
