// SPDX-License-Identifier: MIT
// See rotation.h.
#include "sim/scene/rotation.h"

#include <cmath>

namespace pabd {
namespace {

// The sine and cosine of whole quarters are exact.
Mat3 turn_about(const Vec3& axis, double degrees) {
  const double turn = std::remainder(degrees, 360), quarters = std::round(turn / 90);
  const double rest = (turn - 90 * quarters) * (kPi / 180);
  double s = std::sin(rest), c = std::cos(rest);
  for (int k = static_cast<int>(quarters); k != 0; k += k < 0 ? 1 : -1) {
    const double before = s;
    s = quarters < 0 ? -c : c;
    c = quarters < 0 ? before : -before;
  }
  Mat3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return c * Mat3::Identity() + s * cross + (1 - c) * (axis * axis.transpose());
}

Mat3 rotation_of(const std::array<double, 4>& q) {
  return Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

Mat3 rotation_of(const spec::AxisAngle& turn) { return turn_about(turn.axis, turn.angle); }

Mat3 rotation_of(const spec::Euler& turns) {
  Mat3 R = Mat3::Identity();
  for (int k = 0; k < 3; ++k)
    R = R * turn_about(Vec3::Unit(turns.order[static_cast<std::size_t>(k)] - 'x'), turns.angles[k]);
  return R;
}

}  // namespace

Mat3 rotation_of(const spec::Orientation& orientation) {
  return std::visit([](const auto& way) { return rotation_of(way); }, orientation);
}

}  // namespace pabd
