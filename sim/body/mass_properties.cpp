// Closed forms of mass and second moment J = ∫ ρ r rᵀ dV (supplement S(1); method notes §1).
//
//   box      half edges a, b, c:  m = 8ρabc,  J = m/3 diag(a², b², c²)
//   sphere   radius r:            m = 4/3 πρr³,  J = m r²/5 · 1
//   capsule  radius r, straight part L along y: a cylinder of mass m_c and two half balls of mass m_s
//   together
//            J_xx = J_zz = m_c r²/4 + m_s r²/5
//            J_yy = m_c L²/12 + m_s (L²/4 + 3Lr/8 + r²/5); the centroid of a half ball is 3r/8 off its flat
//            side
//   hull     summed over tetrahedra when it is made (hull_mass.cpp); J has products too
//   compound summed over its hulls when it is made (compound.cpp)
#include "sim/body/mass_properties.h"

#include "sim/body/compound.h"

namespace pabd {
namespace {

double ball_volume(double r) { return 4.0 / 3.0 * kPi * r * r * r; }
double cylinder_volume(double r, double length) { return kPi * r * r * length; }

struct Volume {
  double operator()(const Box& box) const { return 8.0 * box.half.prod(); }
  double operator()(const Sphere& sphere) const { return ball_volume(sphere.radius); }
  double operator()(const Capsule& capsule) const {
    return cylinder_volume(capsule.radius, capsule.length) + ball_volume(capsule.radius);
  }
  double operator()(const Plane&) const { return 0.0; }
  double operator()(const Hull& hull) const { return hull.data->volume; }
  double operator()(const Compound& compound) const { return compound.data->volume; }
};

// ∫ r_i² dV for the three axes; the products vanish by symmetry. Not asked of hulls and
// compounds.
struct SecondMoment {
  Vec3 operator()(const Box& box) const { return Volume{}(box) / 3.0 * box.half.cwiseAbs2(); }
  Vec3 operator()(const Sphere& sphere) const {
    return Vec3::Constant(ball_volume(sphere.radius) * sphere.radius * sphere.radius / 5.0);
  }
  Vec3 operator()(const Capsule& capsule) const {
    const double r = capsule.radius, length = capsule.length;
    const double cylinder = cylinder_volume(r, length), caps = ball_volume(r);
    const double across = cylinder * r * r / 4.0 + caps * r * r / 5.0;
    const double along = cylinder * length * length / 12.0 +
                         caps * (length * length / 4.0 + 3.0 * length * r / 8.0 + r * r / 5.0);
    return {across, along, across};
  }
  Vec3 operator()(const Plane&) const { return Vec3::Zero(); }
  Vec3 operator()(const Hull& hull) const { return hull.data->second_moment.diagonal(); }
  Vec3 operator()(const Compound& compound) const { return compound.data->second_moment.diagonal(); }
};

}  // namespace

double volume(const Shape& shape) { return std::visit(Volume{}, shape); }

MassProperties mass_properties(const Shape& shape, double density) {
  if (const auto* hull = std::get_if<Hull>(&shape)) {
    return {density * hull->data->volume, density * hull->data->second_moment};
  }
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    return {density * compound->data->volume, density * compound->data->second_moment};
  }
  const Vec3 moment = density * std::visit(SecondMoment{}, shape);
  return {density * volume(shape), moment.asDiagonal()};
}

}  // namespace pabd
