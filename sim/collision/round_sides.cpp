// SPDX-License-Identifier: MIT
// Contacts at the side of a cylinder or cone, found on the facets that stand for it (solid.cpp), are put on the round
// side (Deviation D9): the same for whatever touches it.
//
//   u     axis, from the lower to the upper end              unit
//   r, k  radius where the contact is, and its change along u
//   ρ     from the surface along the normal to the axis      m
//
// The line of a contact at the side of a solid of revolution meets its axis, a distance ρ inside the surface. That point
// of the axis moves as the contact moves when the solid tips or goes, and stays when it spins.
#include "sim/body/compound.h"
#include "sim/body/frustum.h"
#include "sim/body/hull.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {
namespace {

// Sine of the angle between axis and normal, from which on it is the side that touches. What stands more upright touches
// with its end: with corners of the facets.
constexpr double kSide = 0.5;
constexpr double kNearly = 1e-6;  // beside the height: what is at an end, a tip or on the axis
// By which normals of facets and their edges lean along the axis.
constexpr double kLean = 1e-5, kLeanOfSlope = 0.01;
constexpr double kHalfFacet = kPi / kFacets;

struct RoundSide {
  const Placed<Shape>& body;
  const Frustum frustum;
  const Vec3 u;
  const double k;

  explicit RoundSide(const Placed<Shape>& solid)
      : body(solid),
        frustum(frustum_of(solid.shape)),
        u(solid.R.col(1)),
        k((frustum.r_high - frustum.r_low) / (frustum.high - frustum.low)) {}

  double cosine() const { return 1 / std::sqrt(1 + k * k); }
  double height() const { return frustum.high - frustum.low; }
  double radius(double t) const { return frustum.r_low + k * (t - frustum.low); }
  // Height above the centre, and away from the axis.
  std::pair<double, Vec3> from_axis(const Vec3& y) const {
    const double t = (y - body.c).dot(u);
    return {t, y - body.c - t * u};
  }
  Vec3 across(const Vec3& n) const { return n - n.dot(u) * u; }

  // The surface under x, a point of the other body that lies beside this one: how far it is, its normal there, and ρ.
  // False: there is no side beside x.
  struct Under {
    double d, rho;
    Vec3 n;
  };
  bool under(const Vec3& x, Under& at) const {
    const auto [t, out] = from_axis(x);
    const double far = out.norm();
    at.d = cosine() * (far - radius(t));
    const double foot = t + at.d * k * cosine(), beyond = std::max(frustum.low - foot, foot - frustum.high);
    if (beyond > kNearly * height() || !(far > kNearly * height()) || cosine() < kSide) return false;
    at.n = cosine() * (out / far - k * u);
    at.rho = far / cosine() - at.d;
    return true;
  }

  // Is n, out of this body, a normal of the side? That of a rim leans.
  bool is_of_side(const Vec3& n) const {
    return std::abs(n.dot(u) + k * cosine()) < kLean + kLeanOfSlope * std::abs(k);
  }

  // This body owns the normal: its plane is turned to the tangent plane under the other's point.
  void turn_plane(ContactPoint& p) const {
    Under at;
    if (!is_of_side(p.n) || !under(p.y_b + p.round_b * p.n, at)) return;
    p.d = at.d - p.round_b;
    p.y_b += p.round_b * (p.n - at.n);
    p.n = at.n;
    p.y_a = p.y_b - p.d * p.n;
    p.round_a = at.rho;
  }

  // The other one owns it and touches with an edge: the same from there.
  void turn_normal(ContactPoint& p) const {
    Under at;
    if (!is_of_side(-p.n) || !under(p.y_a, at)) return;
    p.d = at.d;
    p.n = -at.n;
    p.y_b = p.y_a + p.d * p.n;
    p.round_b = at.rho;
  }

  // The other one touches with a face, which stays: this one's point is moved along its circle to where it comes closest.
  // False: that is nearer to another corner.
  bool turn_point(ContactPoint& p) const {
    const Vec3 inward = across(p.n);
    const double sine = inward.norm();
    const auto [t, out] = from_axis(p.y_b);
    if (sine < kSide || !(radius(t) > kNearly * height())) return true;
    const Vec3 towards = -inward / sine;
    if (out.dot(towards) < std::cos(1.5 * kHalfFacet) * out.norm()) return false;
    const Vec3 y = body.c + t * u + radius(t) * towards;
    p.d += (y - p.y_b).dot(p.n);
    p.y_b = y;
    p.y_a = y - p.d * p.n;
    p.round_b = radius(t) / sine;
    return true;
  }
};

// Is n, in the frame of the shape, the normal of one of its faces?
struct HasFace {
  const Vec3 n;

  bool along(const Vec3& normal) const { return normal.dot(n) > 1 - 1e-9; }
  bool operator()(const HullData& hull) const {
    return std::any_of(hull.faces.begin(), hull.faces.end(),
                       [&](const HullFace& face) { return along(face.normal); });
  }
  bool operator()(const Box&) const { return n.cwiseAbs().maxCoeff() > 1 - 1e-9; }
  bool operator()(const Plane&) const { return true; }
  bool operator()(const Hull& hull) const { return (*this)(*hull.data); }
  bool operator()(const Compound& compound) const {
    return std::any_of(compound.data->parts.begin(), compound.data->parts.end(),
                       [&](const CompoundPart& part) { return (*this)(*part.hull().data); });
  }
  bool operator()(const Solid&) const { return std::abs(n.y()) > 1 - 1e-9; }
  bool operator()(const Sphere&) const { return false; }
  bool operator()(const Capsule&) const { return false; }
};

bool is_round(const Placed<Shape>& body) {
  const auto* solid = std::get_if<Solid>(&body.shape);
  return solid && solid->data->kind->round_about_y;
}

}  // namespace

bool side_on_plane(const Placed<Shape>& plane, const Placed<Shape>& solid, double reach, Contacts& out) {
  if (!is_plane(plane.shape) || !is_round(solid)) return false;
  const RoundSide side(solid);
  const auto& [n, offset] = as<Plane>(plane.shape);
  const Vec3 out_of_axis = side.across(n);
  if (out_of_axis.norm() < kSide) return false;
  const double ends[] = {side.frustum.low, side.frustum.high};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const Vec3 y = solid.c + ends[k] * side.u - side.radius(ends[k]) * out_of_axis.normalized();
    const double d = n.dot(y) - offset;
    if (!(d < reach)) continue;
    add_contact(out, plane.number, solid.number, y, n, d, k * kFacets);
    side.turn_point(out.back());
  }
  return true;
}

void round_off(const Placed<Shape>& a, const Placed<Shape>& b, std::size_t start, Contacts& out) {
  const bool both = is_round(a) && is_round(b);
  for (const Placed<Shape>* body : {&a, &b}) {
    if (!is_round(*body) || both) continue;
    const RoundSide side(*body);
    for (std::size_t k = start; k < out.size(); ++k)
      if (out[k].a == body->number) side.turn_plane(out[k]);
  }
  for (const Placed<Shape>* body : {&a, &b}) {
    if (!is_round(*body)) continue;
    const RoundSide side(*body);
    const Placed<Shape>& owner = body == &a ? b : a;
    const auto is_face = [&](const Vec3& n) {
      return std::visit(HasFace{owner.R.transpose() * n}, owner.shape) ||
             (both && RoundSide(owner).is_of_side(n));
    };
    const auto stays = [&](ContactPoint& p) {
      if (p.b != body->number) return true;
      if (is_face(p.n)) return side.turn_point(p);
      side.turn_normal(p);
      return true;
    };
    std::size_t others = start;
    bool touches = false;
    for (std::size_t k = start; k < out.size(); ++k) {
      if (!stays(out[k])) continue;
      touches = touches || out[k].b == body->number;
      std::swap(out[others++], out[k]);
    }
    // What comes closest stands for the other corners; without it they are left as they are.
    if (touches) out.resize(others);
  }
  if (!both) return;
  // Between two round sides: now that one axis is known, the other's plane, and its point again.
  const RoundSide sides[] = {RoundSide(a), RoundSide(b)};
  for (std::size_t k = start; k < out.size(); ++k) {
    ContactPoint& p = out[k];
    const bool second_owns = p.a == b.number;
    sides[second_owns ? 1 : 0].turn_plane(p);
    if (p.round_a > 0 && p.round_b > 0) sides[second_owns ? 0 : 1].turn_point(p);
  }
}

}  // namespace pabd::narrow
