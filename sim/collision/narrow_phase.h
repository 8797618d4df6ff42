// SPDX-License-Identifier: MIT
// Contact points of one pair of shapes: one function and one file a pair of shapes.
//
//   y_b      a material point on the surface of the incident body b        m, world
//   n        outward normal of the reference body a, from a towards b      unit
//   d        (y_b − y_a)·n, with y_a = y_b − d n                            m
//   reach    points with d ≥ reach are not reported                        m
//
// Every function appends to `out`; feature numbers are unique within a pair. Finite input gives finite
// output: where a normal is undefined (coincident centres) a fixed direction is taken.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/collision/detect.h"

namespace pabd::narrow {

using Contacts = std::vector<ContactPoint>;

// A shape where it stands. A plane ignores its pose.
template <class ShapeType>
struct Placed {
  const ShapeType& shape;
  const Vec3& c;
  const Mat3& R;
  Index number;
  bool first = false;  // of its pair, see goes_first
};

// Which of two bodies owns what neither has by its shape, such as the normal between two faces that are equally good? The
// larger one; of two as large the one that has the other ahead along a direction fixed in both (of two that lie alike on top
// of each other the lower one); the lower number only where that decides nothing either.
bool goes_first(const Placed<Shape>& a, const Placed<Shape>& b);

// Symmetric pairs: `a` goes first. Mixed pairs: the first one owns the normal.
void sphere_sphere(const Placed<Sphere>& a, const Placed<Sphere>& b, double reach, Contacts& out);
void capsule_sphere(const Placed<Capsule>& capsule, const Placed<Sphere>& sphere, double reach,
                    Contacts& out);
void capsule_capsule(const Placed<Capsule>& a, const Placed<Capsule>& b, double reach, Contacts& out);
void sphere_plane(const Placed<Plane>& plane, const Placed<Sphere>& sphere, double reach, Contacts& out);
void capsule_plane(const Placed<Plane>& plane, const Placed<Capsule>& capsule, double reach, Contacts& out);
void box_plane(const Placed<Plane>& plane, const Placed<Box>& box, double reach, Contacts& out);
void box_sphere(const Placed<Box>& box, const Placed<Sphere>& sphere, double reach, Contacts& out);
void box_capsule(const Placed<Box>& box, const Placed<Capsule>& capsule, double reach, Contacts& out);
void box_box(const Placed<Box>& a, const Placed<Box>& b, double reach, Contacts& out);
void hull_plane(const Placed<Plane>& plane, const Placed<Hull>& hull, double reach, Contacts& out);
void hull_sphere(const Placed<Hull>& hull, const Placed<Sphere>& sphere, double reach, Contacts& out);
void hull_capsule(const Placed<Hull>& hull, const Placed<Capsule>& capsule, double reach, Contacts& out);
void hull_box(const Placed<Hull>& hull, const Placed<Box>& box, double reach, Contacts& out);
void hull_hull(const Placed<Hull>& a, const Placed<Hull>& b, double reach, Contacts& out);
// A compound and anything else, another compound included.
void compound_shape(const Placed<Compound>& compound, const Placed<Shape>& other, double reach,
                    Contacts& out);

// The rotation with which the facets of a solid stand for it against `other`; that of any other body as it is.
Mat3 facing(const Placed<Shape>& body, const Placed<Shape>& other);

// How far inside the round surface of a solid its facets lie, at most; 0 of any other shape; m.
double facet_depth(const Shape& shape);

// The side of a round solid on a plane: its two ends, named after the corners of the facets there. False, and nothing is
// added: it is no such solid, or it stands.
bool side_on_plane(const Placed<Shape>& plane, const Placed<Shape>& solid, double reach, Contacts& out);

// Of two bodies, contacts from `start` on that were found on the facets of solids: those at the side of a round one are
// put there, in no order. Sets ContactPoint::round_a, round_b.
void round_off(const Placed<Shape>& a, const Placed<Shape>& b, std::size_t start, Contacts& out);

inline void add_contact(Contacts& out, Index a, Index b, const Vec3& y_b, const Vec3& n, double d,
                        std::uint32_t feature) {
  out.push_back({a, b, y_b - d * n, y_b, n, d, feature});
}

// What came from `middle` on replaces what came from `start` on.
inline void replace(Contacts& out, std::size_t start, std::size_t middle) {
  out.erase(out.begin() + static_cast<std::ptrdiff_t>(start),
            out.begin() + static_cast<std::ptrdiff_t>(middle));
}

// Two round things: spheres of radius r_a and r_b about p_a and p_b. `fallback` is the unit normal for p_a =
// p_b.
inline void add_round_contact(Contacts& out, Index a, Index b, const Vec3& p_a, double r_a, const Vec3& p_b,
                              double r_b, const Vec3& fallback, double reach, std::uint32_t feature) {
  const Vec3 between = p_b - p_a;
  const double distance = between.norm();
  const double d = distance - r_a - r_b;
  if (!(d < reach)) return;
  const bool defined = distance > 1e-12 * (r_a + r_b) && distance > 0;
  const Vec3 n = defined ? Vec3(between / distance) : fallback;
  add_contact(out, a, b, p_b - r_b * n, n, d, feature);
}

// A face is preferred to an edge, and the face of the first body to the other one, unless the rival's
// separation is better by this much: otherwise resting stacks would change their reference face at every
// rounding error.
inline double preference(double separation, double smallest_half) {
  return 0.02 * std::abs(separation) + 1e-3 * smallest_half;
}

// Is the normal n of an edge pair nearly that of a face, w (unit)? If the face comes as near, its contacts are taken: they
// have all places that are about as near, where the edges have one.
inline bool is_nearly_along(const Vec3& n, const Vec3& w) {
  constexpr double kSine = 0.1;
  return n.cross(w).squaredNorm() <= kSine * kSine * n.squaredNorm();
}

inline bool is_nearly(double separation, double other, double smallest_half) {
  return std::abs(separation - other) <= preference(other, smallest_half);
}

inline constexpr double kNone = std::numeric_limits<double>::infinity();  // d where there is no contact

// A unit vector normal to the unit vector u: +y where u allows it.
inline Vec3 any_normal(const Vec3& u) {
  const Vec3 seed = std::abs(u.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX();
  return (seed - seed.dot(u) * u).normalized();
}

// Point on the surface of a capsule towards −n, beside the point p of its axis (direction u): straight below
// p where p is an end and its cap looks that way, else on the side of the cylinder. `cap` is +1 at the end
// towards u, −1 at the other end, 0 between. False when neither exists (a capsule standing on its other end).
inline bool below_axis(const Vec3& p, const Vec3& u, int cap, double radius, const Vec3& n, Vec3& y) {
  const double slope = n.dot(u);
  if (cap * slope < 0 || slope == 0) {
    y = p - radius * n;
    return true;
  }
  const Vec3 side = n - slope * u;
  const double size = side.norm();
  if (!(size > 1e-6)) return false;
  y = p - (radius / size) * side;
  return true;
}

inline double sign_of(double x) { return x < 0 ? -1.0 : 1.0; }

}  // namespace pabd::narrow
