// SPDX-License-Identifier: MIT
// Rays against every shape in closed form, from outside and inside, and rays that hit nothing.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/collision/ray_cast.h"
#include "tests/collision/reference.h"

namespace pabd::test_ray_cast {

using namespace reference;

namespace {

constexpr double kTolerance = 1e-12;

Mat3 tilt() { return Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix(); }

struct Expected {
  double t;
  Vec3 normal;
};

// The ray is given in the frame of the shape; it is cast with the shape at two poses and directions of two
// lengths.
void check_hit(const Shape& shape, const Vec3& origin, const Vec3& direction, const Expected& expected) {
  for (const Mat3& R : {Mat3(Mat3::Identity()), tilt()}) {
    const Vec3 c = R.isIdentity() ? Vec3(Vec3::Zero()) : Vec3(3, -2, 5);
    for (const double length : {1.0, 0.25}) {
      const auto hit = ray_cast(shape, c, R, Ray{c + R * origin, length * (R * direction)});
      REQUIRE(hit.has_value());
      CHECK(std::abs(hit->t * length - expected.t) < kTolerance);
      CHECK((hit->normal - R * expected.normal).norm() < kTolerance);
    }
  }
}

bool misses(const Shape& shape, const Vec3& origin, const Vec3& direction) {
  const Vec3 c(3, -2, 5);
  return !ray_cast(shape, c, tilt(), {c + tilt() * origin, tilt() * direction}) &&
         !ray_cast(shape, Vec3::Zero(), Mat3::Identity(), {origin, direction});
}

const double kHalfRoot = std::sqrt(0.5);

}  // namespace

TEST_CASE("ray and box: faces, a slant, from inside, parallel outside, behind") {
  const Shape box = Box{{1, 2, 3}};
  check_hit(box, {-5, 0.5, 0.5}, Vec3::UnitX(), {4, -Vec3::UnitX()});
  check_hit(box, {0.5, 7, -0.5}, -Vec3::UnitY(), {5, Vec3::UnitY()});
  check_hit(box, {-2, 0, 0}, Vec3(1, 1, 0), {1, -Vec3::UnitX()});
  check_hit(box, {0, 0, 0}, Vec3::UnitZ(), {3, Vec3::UnitZ()});
  check_hit(box, {0.5, 1, 0}, Vec3(1, 1, 0), {0.5, Vec3::UnitX()});
  CHECK(misses(box, {-5, 2.5, 0}, Vec3::UnitX()));
  CHECK(misses(box, {-5, 0, 0}, -Vec3::UnitX()));
  CHECK(misses(box, {-5, 0, 0}, Vec3(1, 1, 0)));
}

TEST_CASE("ray and sphere: straight, off centre, from inside, far away") {
  const Shape ball = Sphere{2};
  check_hit(ball, {-5, 0, 0}, Vec3::UnitX(), {3, -Vec3::UnitX()});
  check_hit(ball, {1, 10, 0}, -Vec3::UnitY(), {10 - std::sqrt(3.0), Vec3(0.5, std::sqrt(0.75), 0)});
  check_hit(ball, {0, 1, 0}, Vec3::UnitY(), {1, Vec3::UnitY()});
  CHECK(misses(ball, {-5, 2.001, 0}, Vec3::UnitX()));
  CHECK(misses(ball, {-5, 0, 0}, -Vec3::UnitX()));
  // Half a kilometre away the quadratic formula would lose ten digits.
  const auto far = ray_cast(Shape(Sphere{1e-3}), Vec3::Zero(), Mat3::Identity(), {{-5e2, 0, 0}, {1, 0, 0}});
  REQUIRE(far.has_value());
  CHECK(far->t == Approx(500 - 1e-3).epsilon(1e-14));
}

TEST_CASE("ray and a shape off its centre of mass: as the shape alone, moved") {
  const Vec3 com(0.3, -0.2, 0.1);
  const Shape shape = with_centre_of_mass(Sphere{0.5}, com);
  check_hit(shape, Vec3(-3, 0.2, -0.1), Vec3::UnitX(), {3 - 0.5 - 0.3, -Vec3::UnitX()});
  const Aabb box = bounds(shape, Vec3::Zero(), Mat3::Identity());
  CHECK((box.lo - (Vec3::Constant(-0.5) - com)).norm() < kTolerance);
  CHECK((box.hi - (Vec3::Constant(0.5) - com)).norm() < kTolerance);
}

TEST_CASE("ray and capsule: side, caps, along the axis, from inside") {
  const Shape capsule = Capsule{1, 4};
  check_hit(capsule, {-5, 1.5, 0}, Vec3::UnitX(), {4, -Vec3::UnitX()});
  check_hit(capsule, {0, -9, 0}, Vec3::UnitY(), {6, -Vec3::UnitY()});
  check_hit(capsule, {0.6, 9, 0}, -Vec3::UnitY(), {9 - 2.8, Vec3(0.6, 0.8, 0)});
  check_hit(capsule, {-5, 2.6, 0}, Vec3::UnitX(), {5 - 0.8, Vec3(-0.8, 0.6, 0)});
  check_hit(capsule, {0, 0, 0}, Vec3::UnitZ(), {1, Vec3::UnitZ()});
  check_hit(capsule, {0, 0, 0}, Vec3::UnitY(), {3, Vec3::UnitY()});
  CHECK(misses(capsule, {-5, 3.01, 0}, Vec3::UnitX()));
  CHECK(misses(capsule, {1.01, 9, 0}, -Vec3::UnitY()));
  CHECK(misses(capsule, {-5, 0, 0}, Vec3::UnitY()));
}

TEST_CASE("ray and plane: a half space, whatever pose it has") {
  const Shape plane = Plane{Vec3(1, 1, 0).normalized(), kHalfRoot};
  const auto cast = [&](const Vec3& o, const Vec3& d) { return ray_cast(plane, {9, 9, 9}, tilt(), {o, d}); };
  const auto above = cast({4, 0, 0}, {-2, 0, 0});
  REQUIRE(above.has_value());
  CHECK(above->t == Approx(1.5).epsilon(1e-12));
  CHECK((above->normal - Vec3(kHalfRoot, kHalfRoot, 0)).norm() < kTolerance);
  const auto below = cast({0, 0, 0}, {0, 0.5, 0});
  REQUIRE(below.has_value());
  CHECK(below->t == Approx(2).epsilon(1e-12));
  CHECK_FALSE(cast({4, 0, 0}, {1, 0, 0}));
  CHECK_FALSE(cast({0, 0, 0}, {0, -1, 0}));
  CHECK_FALSE(cast({4, 0, 0}, {0, 0, 1}));  // parallel above
  CHECK_FALSE(cast({0, 0, 0}, {0, 0, 1}));  // parallel below
}

TEST_CASE("ray and hull: the box it was made of, in random poses") {
  Random random(7);
  const Vec3 half(0.4, 0.7, 1.1);
  const Shape hull = hull_of_box(half), box = Box{half};
  int hits = 0;
  for (int k = 0; k < 2000; ++k) {
    const Mat3 R = random.rotation();
    const Vec3 c = 2 * random.direction();
    const Vec3 origin = 3 * random.direction();
    const double speed = random.uniform(0.2, 4);
    const Ray ray{origin, speed * (c + random.direction() - origin)};
    const auto one = ray_cast(hull, c, R, ray), other = ray_cast(box, c, R, ray);
    REQUIRE(one.has_value() == other.has_value());
    if (!one) continue;
    ++hits;
    CHECK(one->t == Approx(other->t).epsilon(1e-9));
    CHECK((one->normal - other->normal).norm() < 1e-9);
    const Vec3 point = ray.origin + one->t * ray.direction;
    CHECK(std::abs(surface_distance(hull, c, R, point)) < 1e-9);
  }
  CHECK(hits > 200);
}

TEST_CASE("ray and compound: the first of its parts") {
  const auto cube = [](double x) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) corners.emplace_back(x + (k & 1), (k >> 1 & 1), (k >> 2 & 1));
    return Hull{make_hull(corners).hull};
  };
  const Shape pair = make_compound({cube(0), cube(3)});  // centre of mass at (2, ½, ½)
  check_hit(pair, {-5, 0, 0}, Vec3::UnitX(), {3, -Vec3::UnitX()});
  check_hit(pair, {5, 0, 0}, -Vec3::UnitX(), {3, Vec3::UnitX()});
  check_hit(pair, {0, 0, 0}, Vec3::UnitX(), {1, -Vec3::UnitX()});  // from the gap
  check_hit(pair, {-1.5, 0, 0}, Vec3::UnitX(), {0.5, Vec3::UnitX()});
  CHECK(misses(pair, {0, 5, 0}, -Vec3::UnitY()));
}

TEST_CASE("of all bodies the nearest is hit; a ray that makes no sense hits nothing") {
  Model model;
  State state;
  const auto add = [&](const Shape& shape, const Vec3& c) {
    model.shape.push_back(shape);
    state.c.push_back(c);
    state.R.push_back(Mat3::Identity());
  };
  add(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
  add(Sphere{0.5}, {4, 1, 0});
  add(Box{Vec3::Constant(0.5)}, {2, 1, 0});
  add(Sphere{0.5}, {4, 1, 0});  // at the place of another
  const auto first = ray_cast(model, state, Ray{{0, 1, 0}, {0.5, 0, 0}});
  REQUIRE(first.has_value());
  CHECK(first->body == 2);
  CHECK(first->t == Approx(3).epsilon(1e-12));
  CHECK((first->point - Vec3(1.5, 1, 0)).norm() < kTolerance);
  CHECK((first->normal + Vec3::UnitX()).norm() < kTolerance);
  CHECK(ray_cast(model, state, Ray{{9, 1, 0}, {-1, 0, 0}})->body == 1);
  CHECK(ray_cast(model, state, Ray{{0, 1, 0}, {0, -3, 0}})->body == 0);
  CHECK_FALSE(ray_cast(model, state, Ray{{0, 1, 0}, {0, 1, 0}}));

  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(ray_cast(model, state, Ray{{nan, 1, 0}, {1, 0, 0}}));
  CHECK_FALSE(ray_cast(model, state, Ray{{0, 1, 0}, {infinity, 0, 0}}));
  CHECK_FALSE(ray_cast(model, state, Ray{{0, 1, 0}, {0, 0, 0}}));
  CHECK_FALSE(ray_cast(model.shape[1], state.c[1], state.R[1], Ray{{0, 1, 0}, {0, nan, 0}}));
}

}  // namespace pabd::test_ray_cast
