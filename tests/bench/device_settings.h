// SPDX-License-Identifier: MIT
// What the benchmarks of the GPU simulate, for any number of bodies.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/potential/barrier.h"
#include "sim/solver/params.h"

namespace pabd::bench {

using Clock = std::chrono::steady_clock;

inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Setting {
  Model model;
  State state;
  Params params;
  // Corners of the box in which all that is worth seeing happens; m.
  Vec3 lowest = Vec3::Zero(), highest = Vec3::Zero();
  int steps = 1;  // of a frame of 1/60 s
};

inline Setting plain_setting() {
  Setting out;
  out.params.solver.method = SolverMethod::descent;
  out.params.solver.iterations = 10;
  out.params.solver.tolerance = 0;
  out.params.solver.halvings = 0;
  return out;
}

// `density` 0: fixed. kg/m³.
inline void add(Setting& out, const Shape& shape, double density, const Vec3& c, const Mat3& R) {
  const bool fixed = is_plane(shape) || density == 0;
  const MassProperties mass = fixed ? MassProperties{0, Mat3::Zero()} : mass_properties(shape, density);
  out.model.name.push_back("");
  out.model.shape.push_back(shape);
  out.model.mass.push_back(mass.mass);
  out.model.J.push_back(mass.J);
  out.model.fixed.push_back(fixed);
  out.state.c.push_back(c);
  out.state.R.push_back(R);
  out.state.v.push_back(Vec3::Zero());
  out.state.omega.push_back(Vec3::Zero());
}

// −1 … 1, the same in every run.
class Draw {
 public:
  double operator()() { return 2.0 * random_() / 4294967296.0 - 1; }
  Mat3 orientation() {
    const double x = (*this)(), y = (*this)(), z = (*this)(), angle = 3 * (*this)();
    return Eigen::AngleAxisd(angle, Vec3(x, y, z).normalized()).toRotationMatrix();
  }

 private:
  std::mt19937 random_{1};
};

inline constexpr int kTowerHeight = 10;

inline int towers_side(int bodies) { return static_cast<int>(std::ceil(std::sqrt(bodies / kTowerHeight))); }

// Columns of ten boxes, each a little beside the one below, at rest; or a heap: boxes in any orientation that fall.
// `d_hat` in m.
inline Setting make_setting(bool heap, int bodies, double d_hat = 0.01) {
  Setting out = plain_setting();
  out.params.contact.d_hat = d_hat;
  add(out, Plane{{0, 1, 0}, 0}, 0, Vec3::Zero(), Mat3::Identity());
  const int side = towers_side(bodies);
  Draw draw;
  for (int k = 0; k < bodies; ++k) {
    const int column = k / kTowerHeight, floor = k % kTowerHeight;
    const double pitch = heap ? 0.8 : 1;
    Vec3 c(pitch * (column % side), 0.25 + 0.5 * floor + 0.98 * d_hat * (floor + 1), pitch * (column / side));
    Mat3 R = Mat3::Identity();
    if (!heap) c.x() += 0.02 * (floor % 2);
    if (heap) {
      c.y() += 0.5 + 0.4 * floor;
      R = draw.orientation();
    }
    add(out, Box{{0.25, 0.25, 0.25}}, 1000, c, R);
  }
  return out;
}

// The towers, and a ball of steel that rolls into them. Of a million its radius is 12 m, and less of fewer; its speed
// goes with the root of its radius, as does all that falls beside it.
//
// κ is what the floor carries the ball with at d = d̂/5. The default goes by what the heaviest body hits with, some hundred
// times as much: then few sweeps see boxes as walls, and the ball stops at the first ones. A sweep lets a heavy body push
// light ones by less than d̂: hence four steps a frame.
inline Setting towers_and_ball(int bodies) {
  Setting out = make_setting(false, bodies);
  const double side = towers_side(bodies), radius = std::max(1.5, 12 * side / 316);
  const double speed = 14 * std::sqrt(radius / 12), middle = 0.5 * side - 0.3;
  add(out, Sphere{radius}, 7850, {-radius - 1, radius + 0.019, middle}, Mat3::Identity());
  out.state.v.back() = Vec3(speed, 0, 0);
  out.state.omega.back() = Vec3(0, 0, -speed / radius);
  out.steps = 4;
  ContactParams& contact = out.params.contact;
  const Barrier unit{contact.barrier, contact.N, contact.d_hat, 1.0, contact.onset};
  const double weight = out.model.mass.back() * out.params.gravity.norm();
  contact.kappa = weight / -evaluate(unit, 0.2 * contact.d_hat).first;
  out.lowest = {-2 * radius - 1.5, 0, -0.5};
  out.highest = {side, std::max(2 * radius, 5.5), side};
  return out;
}

// Boxes, balls, capsules and hulls that slide down a slope of 38° between walls, onto a level floor.
inline Setting avalanche(int bodies) {
  Setting out = plain_setting();
  out.params.contact.mu_static = out.params.contact.mu_dynamic = 0.3;
  const double angle = 38 * kPi / 180, pitch = 0.85;
  const Vec3 down(std::cos(angle), -std::sin(angle), 0), across(0, 0, 1);
  const Vec3 up = across.cross(down).normalized();  // of the slope
  Mat3 on_slope;
  on_slope << down, up, across;
  add(out, Plane{up, 0}, 0, Vec3::Zero(), Mat3::Identity());
  add(out, Plane{{0, 1, 0}, 0}, 0, Vec3::Zero(), Mat3::Identity());

  const int layers = std::clamp(static_cast<int>(std::cbrt(bodies) / 4), 2, 10);
  const int wide = std::max(1, static_cast<int>(std::sqrt(bodies / (1.5 * layers))));
  const int each = wide * layers, rows = (bodies + each - 1) / each;
  const double width = pitch * wide, length = pitch * rows, run = 0.15 * length + 2;
  const double wall = 0.6 * pitch * layers, half_thickness = 0.25;
  for (const double z : {-0.5 * width - half_thickness, 0.5 * width + half_thickness}) {
    const double half = 0.5 * (length + run) + 2;
    add(out, Box{{half, wall, half_thickness}}, 0, -half * down + z * across, on_slope);
    add(out, Box{{half, wall, half_thickness}}, 0, {half, 0, z}, Mat3::Identity());
  }

  std::vector<Vec3> corners;
  for (int k = 0; k < 6; ++k) {
    const double a = k * kPi / 3;
    corners.emplace_back(0.3 * std::cos(a), -0.2, 0.3 * std::sin(a));
    corners.emplace_back(0.2 * std::cos(a), 0.25, 0.2 * std::sin(a));
  }
  const Shape shapes[] = {Box{{0.25, 0.2, 0.3}}, Sphere{0.25}, Capsule{0.15, 0.4},
                          Hull{make_hull(corners).hull}};
  Draw draw;
  for (int k = 0; k < bodies; ++k) {
    const int layer = k % layers, column = k / layers % wide, row = k / each;
    const Vec3 c = -(run + pitch * (row + 0.5)) * down + (0.5 + pitch * layer) * up +
                   pitch * (column + 0.5 - 0.5 * wide) * across;
    add(out, shapes[static_cast<int>(2 * (draw() + 1)) % 4], 1000, c, draw.orientation());
  }
  const Vec3 top = -(run + length) * down;
  out.lowest = {top.x(), 0, -0.5 * width};
  out.highest = {0.4 * (run + length), top.y() + pitch * layers, 0.5 * width};
  return out;
}

}  // namespace pabd::bench
