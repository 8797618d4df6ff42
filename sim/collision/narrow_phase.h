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

inline double sign_of(double x) { return x < 0 ? -1.0 : 1.0; }

}  // namespace pabd::narrow
