// SPDX-License-Identifier: MIT
// A camera that goes through key frames: a monotone cubic in time for each of its numbers.
//
//   v      t (3), ln ‖e − t‖, α, ε, fov                       what is interpolated; see camera_control.cpp
//   Δ_k    (v_{k+1} − v_k) / (τ_{k+1} − τ_k)                  slope between keys k and k+1
//   w      slope at a key: the harmonic mean of the two Δ, weighted by the lengths of their intervals
//          (Fritsch and Butland 1984); 0 where they differ in sign, the one Δ at the ends
//   H      cubic Hermite between keys; for equal Δ it is the straight line
#include "render/visual/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pabd {
namespace {

using Numbers = Eigen::Matrix<double, 7, 1>;
constexpr int kAzimuth = 4;

Numbers numbers_of(const CameraPose& pose) {
  const CameraAngles angles = angles_of(pose);
  Numbers v;
  v << pose.target, std::log(std::max(pose.distance(), 1e-9)), angles.azimuth, angles.elevation, pose.fov;
  return v;
}

CameraPose pose_of(const Numbers& v) {
  CameraPose pose;
  pose.target = v.head<3>();
  pose.fov = v[6];
  return at_angles(pose, {v[kAzimuth], v[5]}, std::exp(v[3]));
}

// The numbers of `key` with the azimuth nearest to that of `before`.
Numbers unwrapped(const CameraKey& key, const Numbers& before) {
  Numbers v = numbers_of(key.pose);
  v[kAzimuth] = before[kAzimuth] + std::remainder(v[kAzimuth] - before[kAzimuth], 2 * kPi);
  return v;
}

Numbers slope_at(const Numbers& left, double left_time, const Numbers& right, double right_time) {
  Numbers w;
  for (int i = 0; i < w.size(); ++i) {
    const double a = left[i], b = right[i];
    const double total = 3 * (left_time + right_time);
    w[i] = a * b > 0 ? total / ((2 * right_time + left_time) / a + (right_time + 2 * left_time) / b) : 0;
  }
  return w;
}

}  // namespace

CameraPose camera_at(std::span<const CameraKey> all, double time) {
  if (all.empty()) return {};
  std::vector<CameraKey> keys;  // one a time
  for (const CameraKey& key : all) {
    if (!keys.empty() && keys.back().time >= key.time) keys.pop_back();
    keys.push_back(key);
  }
  if (!(time > keys.front().time)) return keys.front().pose;
  if (time >= keys.back().time) return keys.back().pose;

  std::size_t k = 0;  // between keys k and k + 1
  while (keys[k + 1].time <= time) ++k;
  const CameraKey &from = keys[k], &to = keys[k + 1];
  const Numbers v0 = numbers_of(from.pose), v1 = unwrapped(to, v0);
  const double span = to.time - from.time;
  const Numbers delta = (v1 - v0) / span;
  Numbers w0 = delta, w1 = delta;
  if (k > 0) {
    const double d = from.time - keys[k - 1].time;
    w0 = slope_at((v0 - unwrapped(keys[k - 1], v0)) / d, d, delta, span);
  }
  if (k + 2 < keys.size()) {
    const double d = keys[k + 2].time - to.time;
    w1 = slope_at(delta, span, (unwrapped(keys[k + 2], v1) - v1) / d, d);
  }
  const double s = (time - from.time) / span, s2 = s * s, s3 = s2 * s;
  CameraPose pose = pose_of((2 * s3 - 3 * s2 + 1) * v0 + (s3 - 2 * s2 + s) * span * w0 +
                            (3 * s2 - 2 * s3) * v1 + (s3 - s2) * span * w1);
  pose.orthographic = from.pose.orthographic;
  return pose;
}

}  // namespace pabd
