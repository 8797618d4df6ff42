// SPDX-License-Identifier: MIT
// Mass of geoms and links. Moments of inertia of solids about their centres:
//
//   box, half lengths a b c       m/3 (b² + c²), …
//   ellipsoid                     m/5 (b² + c²), …
//   cylinder, radius r, half h    m (r²/4 + h²/3) across, m r²/2 along
//   capsule                       a cylinder and two half balls: M (2r²/5 + h² + 3hr/4) across, M 2r²/5 along
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/body/compound.h"
#include "sim/body/mass_properties.h"
#include "sim/import/geometry.h"

namespace pabd {
namespace {

// In the geom's frame, at a density of 1 kg/m³.
RobotInertia unit_solid(const RobotGeom& geom) {
  RobotInertia out;
  const Vec3 s = geom.size, q = s.cwiseAbs2();
  const Vec3 across(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
  const double r = s.x(), h = s.y();
  const double tube = kPi * r * r * 2 * h, ball = 4.0 / 3 * kPi * r * r * r;
  switch (geom.kind) {
    case GeomKind::box:
      out.mass = 8 * s.prod();
      out.I = (out.mass / 3 * across).asDiagonal();
      break;
    case GeomKind::ellipsoid:
      out.mass = 4.0 / 3 * kPi * s.prod();
      out.I = (out.mass / 5 * across).asDiagonal();
      break;
    case GeomKind::sphere:
      out.mass = ball;
      out.I = Mat3::Identity() * (0.4 * ball * r * r);
      break;
    case GeomKind::cylinder:
    case GeomKind::capsule: {
      const double caps = geom.kind == GeomKind::capsule ? ball : 0;
      out.mass = tube + caps;
      const double side = tube * (r * r / 4 + h * h / 3) + caps * (0.4 * r * r + h * h + 0.75 * h * r);
      out.I = Vec3(side, side, tube * r * r / 2 + caps * 0.4 * r * r).asDiagonal();
      break;
    }
    case GeomKind::mesh:
      return geom.solid;
    case GeomKind::plane:
      break;
  }
  return out;
}

// About another point, `d` from the centre of mass.
Mat3 about(const RobotInertia& inertia, const Vec3& d) {
  return inertia.I + inertia.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
}

}  // namespace

RobotInertia solid_of(const RobotGeom& geom, double density) {
  RobotInertia out = moved(unit_solid(geom), geom.at);
  out.mass *= density;
  out.I *= density;
  return out;
}

RobotInertia inertia_of(const RobotGeom& geom) {
  if (!geom.mass) return solid_of(geom, geom.density);
  const double volume = unit_solid(geom).mass;
  return solid_of(geom, volume > 0 ? *geom.mass / volume : 0);
}

RobotInertia moved(const RobotInertia& inertia, const LinkPose& pose) {
  return {inertia.mass, pose * inertia.com, pose.R * inertia.I * pose.R.transpose(), inertia.lifted};
}

RobotInertia together(const RobotInertia& a, const RobotInertia& b) {
  if (!(a.mass > 0)) return b;
  if (!(b.mass > 0)) return a;
  RobotInertia out;
  out.mass = a.mass + b.mass;
  out.lifted = a.lifted + b.lifted;
  out.com = (a.mass * a.com + b.mass * b.com) / out.mass;
  out.I = about(a, a.com - out.com) + about(b, b.com - out.com);
  return out;
}

namespace {

constexpr double kThinnest = 1e-6;  // least part of the trace that each second moment has

}  // namespace

bool is_physical(const Mat3& I) {
  const Mat3 J = second_moment_of(I);
  const Eigen::SelfAdjointEigenSolver<Mat3> parts(J, Eigen::EigenvaluesOnly);
  return J.trace() > 0 && parts.eigenvalues()[0] > kThinnest * J.trace() / 2;
}

Mat3 made_physical(const Mat3& I) {
  const Eigen::SelfAdjointEigenSolver<Mat3> parts(second_moment_of(I));
  const double least = kThinnest * std::max(parts.eigenvalues().cwiseAbs().sum(), 1e-15);
  const Vec3 raised = parts.eigenvalues().cwiseMax(least);
  return inertia_tensor(parts.eigenvectors() * raised.asDiagonal() * parts.eigenvectors().transpose());
}

}  // namespace pabd
