// SPDX-License-Identifier: MIT
// Short names for the fixed-size matrices of the method, and the one index type.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>

namespace pabd {

static_assert(EIGEN_MAX_STATIC_ALIGN_BYTES == 16,
              "compile with -DEIGEN_MAX_ALIGN_BYTES=16, as pabd was: types would have another layout");

using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Mat34 = Eigen::Matrix<double, 3, 4>;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Quat = Eigen::Quaterniond;

using Index = std::int32_t;  // body, bond and contact numbers

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180;  // rad

}  // namespace pabd
