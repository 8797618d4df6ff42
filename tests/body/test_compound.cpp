// SPDX-License-Identifier: MIT
// Several hulls as one body: mass properties against the closed forms of boxes, bounds, radii.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"

namespace pabd::test_compound {

namespace {

// An upright box between two corners.
Hull box(const Vec3& lo, const Vec3& hi) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k) {
    points.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
  }
  const HullResult result = make_hull(points);
  REQUIRE(result.hull);
  return Hull{result.hull};
}

// Closed form: ∫ r rᵀ dV of a box of half edges h about a point at distance d from its centre.
Mat3 moment(const Vec3& h, const Vec3& d) {
  const double v = 8 * h.prod();
  return Mat3((v / 3 * h.cwiseAbs2()).asDiagonal()) + v * d * d.transpose();
}

}  // namespace

TEST_CASE("an L of two boxes has the mass properties of theory") {
  const Vec3 place(7, -3, 2);  // wherever the files have their origin
  const Compound L = make_compound({box(place + Vec3(0, 0, -0.2), place + Vec3(1, 0.2, 0.2)),
                                    box(place + Vec3(0, 0.2, -0.2), place + Vec3(0.2, 1, 0.2))});
  const Vec3 h1(0.5, 0.1, 0.2), h2(0.1, 0.4, 0.2), c1(0.5, 0.1, 0), c2(0.1, 0.6, 0);
  const double v1 = 0.08, v2 = 0.064;
  const Vec3 c = (v1 * c1 + v2 * c2) / (v1 + v2);
  CHECK((L.data->centroid - place - c).norm() < 1e-14);
  const MassProperties mass = mass_properties(L, 500);
  CHECK(mass.mass == Approx(500 * 0.144).epsilon(1e-13));
  const Mat3 J = 500 * (moment(h1, c1 - c) + moment(h2, c2 - c));
  CHECK((mass.J - J).norm() < 1e-12 * J.norm());
  CHECK(std::abs(J(0, 1)) > 0.01 * J.trace());  // an L has products
  CHECK((L.data->parts[0].offset - (c1 - c)).norm() < 1e-14);
  CHECK((L.data->parts[1].offset - (c2 - c)).norm() < 1e-14);
  CHECK(inner_radius(L) == Approx(0.1).epsilon(1e-12));
  CHECK(bounding_radius(L) == Approx((Vec3(1, 0, 0.2) - c).norm()).epsilon(1e-12));
}

TEST_CASE("a box in three pieces is the box") {
  const Vec3 half(0.6, 0.3, 0.2);
  const Compound pieces =
      make_compound({box({-0.6, -0.3, -0.2}, {-0.1, 0.3, 0.2}), box({-0.1, -0.3, -0.2}, {0.6, 0.1, 0.2}),
                     box({-0.1, 0.1, -0.2}, {0.6, 0.3, 0.2})});
  const MassProperties mine = mass_properties(pieces, 800), whole = mass_properties(Box{half}, 800);
  CHECK(mine.mass == Approx(whole.mass).epsilon(1e-13));
  CHECK((mine.J - whole.J).norm() < 1e-12 * whole.J.norm());
  CHECK(pieces.data->centroid.norm() < 1e-14);
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Aabb a = bounds(pieces, Vec3(1, 2, 3), R), b = bounds(Box{half}, Vec3(1, 2, 3), R);
  CHECK((a.lo - b.lo).norm() < 1e-13);
  CHECK((a.hi - b.hi).norm() < 1e-13);
}

TEST_CASE("matter that parts share counts once for each, as documented") {
  const Hull cube = box(-Vec3::Ones(), Vec3::Ones());
  const Compound twice = make_compound({cube, cube});
  CHECK(mass_properties(twice, 1).mass == Approx(16).epsilon(1e-13));
}

}  // namespace pabd::test_compound
