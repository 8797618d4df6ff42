// SPDX-License-Identifier: MIT
// Hulls: their faces, and mass properties against closed forms and against integration of another kind.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"
#include "tests/support/draws.h"

namespace pabd::test_hull {

namespace {

std::vector<Vec3> cube_points(const Vec3& half, const Vec3& centre, const Mat3& R = Mat3::Identity()) {
  std::vector<Vec3> out;
  for (int k = 0; k < 8; ++k) {
    const Vec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    out.push_back(centre + R * half.cwiseProduct(sign));
  }
  return out;
}

std::shared_ptr<const HullData> hull_of(const std::vector<Vec3>& points) {
  HullResult result = make_hull(points);
  INFO(result.problem);
  REQUIRE(result.hull);
  return result.hull;
}

Mat3 turn(double angle) { return Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix(); }

bool inside(const HullData& hull, const Vec3& x) {
  for (const HullFace& face : hull.faces) {
    if (face.normal.dot(x) > face.offset) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a cube has six square faces and the mass properties of a box") {
  const Vec3 half(0.3, 0.5, 0.9), centre(4, -3, 2);
  const auto hull = hull_of(cube_points(half, centre));
  CHECK(hull->vertices.size() == 8);
  CHECK(hull->faces.size() == 6);
  CHECK(hull->edges.size() == 12);
  for (const HullFace& face : hull->faces) CHECK(face.count == 4);
  CHECK((hull->centroid - centre).norm() < 1e-14);
  const MassProperties box = mass_properties(Box{half}, 700), mine = mass_properties(Hull{hull}, 700);
  CHECK(std::abs(mine.mass - box.mass) < 1e-12 * box.mass);
  CHECK((mine.J - box.J).norm() < 1e-12 * box.J.norm());
  CHECK(bounding_radius(Hull{hull}) == Approx(half.norm()).epsilon(1e-13));
  CHECK(inner_radius(Hull{hull}) == Approx(0.3).epsilon(1e-13));
}

TEST_CASE("a turned cube has the turned second moment, with products") {
  const Vec3 half(0.3, 0.5, 0.9);
  const Mat3 R = turn(0.7);
  const auto hull = hull_of(cube_points(half, Vec3(1, 2, 3), R));
  CHECK(hull->faces.size() == 6);
  const Mat3 J = R * mass_properties(Box{half}, 1).J * R.transpose();
  CHECK((hull->second_moment - J).norm() < 1e-12 * J.norm());
  CHECK(std::abs(J(0, 1)) > 0.01);
  const Aabb mine = bounds(Hull{hull}, Vec3(5, 6, 7), R.transpose());
  CHECK((mine.hi - (Vec3(5, 6, 7) + half)).norm() < 1e-13);
  CHECK((mine.lo - (Vec3(5, 6, 7) - half)).norm() < 1e-13);
}

TEST_CASE("a tetrahedron agrees with its closed form") {
  // The corner tetrahedron x, y, z ≥ 0, x + y + z ≤ a: V = a³/6, ∫x² dV = a⁵/60, ∫xy dV = a⁵/120.
  const double a = 1.7;
  const auto hull = hull_of({Vec3::Zero(), Vec3(a, 0, 0), Vec3(0, a, 0), Vec3(0, 0, a)});
  CHECK(hull->faces.size() == 4);
  CHECK(hull->volume == Approx(a * a * a / 6).epsilon(1e-13));
  CHECK((hull->centroid - Vec3::Constant(a / 4)).norm() < 1e-14);
  const double a5 = std::pow(a, 5), v = a * a * a / 6, shift = v * a * a / 16;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double about_corner = i == j ? a5 / 60 : a5 / 120;
      CHECK(hull->second_moment(i, j) == Approx(about_corner - shift).epsilon(1e-12));
    }
  }
}

TEST_CASE("random hulls are convex polyhedra that hold their points, with moments by Monte Carlo") {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec3> points;
    const int count = 4 + trial;
    for (int k = 0; k < count; ++k) {
      const Vec3 u = testing::draw_vector([&] { return normal(generator); });
      points.push_back(u.cwiseProduct(Vec3(1, 0.5, 2)));
    }
    const auto hull = hull_of(points);
    REQUIRE(hull->vertices.size() + hull->faces.size() == hull->edges.size() + 2);
    for (const Vec3& p : points) {
      for (const HullFace& face : hull->faces) {
        REQUIRE(face.normal.dot(p - hull->centroid) - face.offset < 1e-5);
      }
    }
    if (trial % 50 != 10) continue;
    // 400,000 points: three standard errors of the volume are below 1.5 % here, of the moments below 3 %.
    Vec3 lo = Vec3::Constant(1e9), hi = -lo;
    for (const Vec3& v : hull->vertices) {
      lo = lo.cwiseMin(v);
      hi = hi.cwiseMax(v);
    }
    std::uniform_real_distribution<double> unit(0, 1);
    constexpr int kSamples = 400000;
    int hits = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    for (int k = 0; k < kSamples; ++k) {
      const Vec3 u = testing::draw_vector([&] { return unit(generator); });
      const Vec3 x = lo + (hi - lo).cwiseProduct(u);
      if (!inside(*hull, x)) continue;
      ++hits;
      first += x;
      second += x * x.transpose();
    }
    const double box = (hi - lo).prod();
    CHECK(box * hits / kSamples == Approx(hull->volume).epsilon(0.015));
    CHECK((first / hits).norm() < 0.01 * hull->bounding_radius);
    CHECK((box / kSamples * second - hull->second_moment).norm() < 0.03 * hull->second_moment.norm());
  }
}

TEST_CASE("points of single precision still give flat faces") {
  for (int trial = 0; trial < 50; ++trial) {
    auto points = cube_points(Vec3(0.3, 0.5, 0.9), Vec3(0.1, 0.2, 0.3), turn(0.13 * trial));
    for (Vec3& p : points) p = p.cast<float>().cast<double>();
    const auto hull = hull_of(points);
    CHECK(hull->faces.size() == 6);
  }
}

TEST_CASE("points inside, on edges and on faces leave no trace") {
  auto points = cube_points(Vec3::Ones(), Vec3::Zero());
  for (double x = -1; x <= 1; x += 0.25) {
    for (double y = -1; y <= 1; y += 0.25) {
      points.emplace_back(x, y, 1);
      points.emplace_back(x, -1, y);
      points.emplace_back(0.9 * x, 0.9 * y, 0.3);
    }
  }
  const auto hull = hull_of(points);
  CHECK(hull->vertices.size() == 8);
  CHECK(hull->faces.size() == 6);
  CHECK(hull->volume == Approx(8).epsilon(1e-13));
}

TEST_CASE("what is not a solid is refused in words") {
  const auto problem = [](const std::vector<Vec3>& points) {
    const HullResult result = make_hull(points);
    CHECK_FALSE(result.hull);
    return result.problem;
  };
  CHECK_THAT(problem({}), Catch::Contains("four different points"));
  CHECK_THAT(problem(std::vector<Vec3>(50, Vec3(1, 2, 3))), Catch::Contains("four different points"));
  std::vector<Vec3> flat, line, ball;
  std::mt19937 generator(6);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 u = testing::draw_vector([&] { return normal(generator); });
    flat.push_back(u - u.dot(Vec3::Ones()) / 3 * Vec3::Ones());
    line.push_back(u.x() * Vec3(1, 2, 3));
    ball.push_back(u.normalized());
  }
  CHECK_THAT(problem(flat), Catch::Contains("one plane"));
  CHECK_THAT(problem(line), Catch::Contains("one plane"));
  CHECK_THAT(problem(ball), Catch::Contains("at most 256"));
  ball.resize(300);
  CHECK_THAT(problem(ball), Catch::Contains("has 300 corners"));
  ball.resize(256);
  CHECK(make_hull(ball).hull);
  ball[3].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(problem(ball), Catch::Contains("not finite"));
}

}  // namespace pabd::test_hull
