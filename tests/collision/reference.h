// SPDX-License-Identifier: MIT
// Independent answers to compare the contact points with, and random placements.
#pragma once

#include <limits>
#include <random>
#include <vector>

#include "sim/collision/detect.h"

namespace reference {

using namespace pabd;

// Bodies where they stand, and what `detect` finds.
struct Setup {
  Model model;
  std::vector<Vec3> c;
  std::vector<Mat3> R;
  std::vector<double> reach;  // of each body

  Index add(const Shape& shape, const Vec3& centre, const Mat3& rotation = Mat3::Identity(),
            double reach_of = 0.05, bool fixed = false);
  std::vector<ContactPoint> contacts(int threads = 1, const std::vector<IndexPair>& skip = {}) const;
};

// A caller that draws twice does so in two statements (tests/support/draws.h says why).
class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(generator_); }
  Vec3 direction();
  Vec3 within(double lo, double hi);        // x, y and z from lo to hi
  Vec3 offset(double nearest, double far);  // any direction, that long
  Mat3 rotation();
  Mat3 turn(double most);  // about any direction, by up to that angle

 private:
  std::mt19937 generator_;
};

// A box as a hull, and a hull of random points of a sphere of that radius.
Shape hull_of_box(const Vec3& half);
Shape rock(int corners, double size, unsigned seed);
// Upright, over a regular polygon.
Shape prism(int sides, double radius, double half_height);

// Largest n·x over the shape at pose (c, R), by enumeration of corners and end points; of a solid that of
// its facets. Not for planes.
double support(const Shape& shape, const Vec3& c, const Mat3& R, const Vec3& n);

// Signed distance from the point x to the surface of the shape, negative inside. Not for planes.
double surface_distance(const Shape& shape, const Vec3& c, const Mat3& R, const Vec3& x);

// Signed distance of two convex bodies, max over unit n of (min over b of n·x − max over a of n·x): their gap
// when they are apart, minus the shortest way out when they overlap. The best n joins two features, corners,
// edges or faces, and all such directions are tried: exact to rounding. Tries no more once it is above `enough`.
double signed_distance(const Setup& setup, Index a, Index b,
                       double enough = std::numeric_limits<double>::infinity());

}  // namespace reference
