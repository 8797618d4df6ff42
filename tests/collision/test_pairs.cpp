// SPDX-License-Identifier: MIT
// Every pair of solid shapes in random poses: the contact points against a brute-force signed distance.
//
// Tolerances. Faces are preferred to edges within 0.02 |s| + 1e-3 · smallest half edge (`preference`), so a
// gap may be understated or a depth overstated by that much; the brute force itself is exact.
// Points lie on surfaces and along normals to 1e-12.
#include <catch2/catch.hpp>
#include <set>

#include "tests/collision/reference.h"
#include "tests/support/sanitized.h"

namespace pabd::test_pairs {

using namespace reference;

namespace {

struct PairCase {
  const char* name;
  Shape a, b;
};

const PairCase kCases[] = {
    {"sphere sphere", Sphere{0.4}, Sphere{0.3}},
    {"capsule sphere", Capsule{0.2, 0.8}, Sphere{0.3}},
    {"sphere capsule", Sphere{0.3}, Capsule{0.2, 0.8}},
    {"capsule capsule", Capsule{0.2, 0.8}, Capsule{0.3, 0.5}},
    {"box sphere", Box{{0.3, 0.5, 0.4}}, Sphere{0.3}},
    {"sphere box", Sphere{0.3}, Box{{0.3, 0.5, 0.4}}},
    {"box capsule", Box{{0.3, 0.5, 0.4}}, Capsule{0.15, 0.9}},
    {"capsule box", Capsule{0.15, 0.9}, Box{{0.3, 0.5, 0.4}}},
    {"cube cube", Box{{0.5, 0.5, 0.5}}, Box{{0.5, 0.5, 0.5}}},
    {"box box", Box{{0.3, 0.5, 0.4}}, Box{{0.7, 0.2, 0.3}}},
    {"hull sphere", rock(12, 0.5, 1), Sphere{0.3}},
    {"sphere hull", Sphere{0.3}, rock(14, 0.5, 2)},
    {"hull capsule", rock(12, 0.5, 3), Capsule{0.15, 0.9}},
    {"capsule hull", Capsule{0.15, 0.9}, hull_of_box({0.3, 0.5, 0.4})},
    {"hull box", rock(10, 0.5, 4), Box{{0.3, 0.5, 0.4}}},
    {"box hull", Box{{0.3, 0.5, 0.4}}, rock(14, 0.5, 5)},
    {"hull hull", rock(8, 0.5, 6), rock(12, 0.6, 7)},
    {"tetrahedra", rock(4, 0.8, 11), rock(4, 0.9, 12)},
    {"plate rod", Box{{0.6, 0.03, 0.5}}, Box{{0.05, 0.7, 0.08}}},
    {"plate capsule", Box{{0.6, 0.03, 0.5}}, Capsule{0.05, 0.9}},
    {"plate hull", Box{{0.6, 0.03, 0.5}}, rock(9, 0.5, 8)},
};

double smallest_half(const Shape& shape) {
  const auto* box = std::get_if<Box>(&shape);
  return box || std::holds_alternative<Hull>(shape) ? inner_radius(shape) : 1e300;
}

// Tolerance of the signed distance s for this pair.
double tolerance(const PairCase& pair, double s) {
  const double half = std::min(smallest_half(pair.a), smallest_half(pair.b));
  return 1e-9 + (half < 1e300 ? 0.021 * std::abs(s) + 1e-3 * half : 0);
}

// A random pose of both, near each other.
Setup place(const PairCase& pair, Random& random) {
  Setup setup;
  const double near = 0.7 * (inner_radius(pair.a) + inner_radius(pair.b));
  const double far = bounding_radius(pair.a) + bounding_radius(pair.b) + 0.1;
  const Vec3 centre = random.within(-2, 2), offset = random.offset(near, far);
  const Mat3 R_a = random.rotation(), R_b = random.rotation();
  setup.add(pair.a, centre, R_a);
  setup.add(pair.b, centre + offset, R_b);
  return setup;
}

void check_points(const Setup& setup, const std::vector<ContactPoint>& contacts, bool shallow) {
  std::set<std::uint32_t> features;
  for (const ContactPoint& p : contacts) {
    const auto i = static_cast<std::size_t>(p.a), j = static_cast<std::size_t>(p.b);
    REQUIRE(p.n.norm() == Approx(1).margin(1e-12));
    REQUIRE((p.y_b - p.y_a - p.d * p.n).norm() < 1e-12);
    REQUIRE(p.d < setup.reach[i] + setup.reach[j]);
    REQUIRE(std::abs(surface_distance(setup.model.shape[j], setup.c[j], setup.R[j], p.y_b)) < 1e-12);
    // Deep inside, a foot may lie in the plane of the face but beyond its rim.
    if (shallow)
      REQUIRE(std::abs(surface_distance(setup.model.shape[i], setup.c[i], setup.R[i], p.y_a)) < 1e-12);
    // Outward from a: nothing of a is further along n than y_a.
    REQUIRE(support(setup.model.shape[i], setup.c[i], setup.R[i], p.n) - p.n.dot(p.y_a) < 1e-12);
    REQUIRE(features.insert(p.feature).second);
  }
}

double smallest_d(const std::vector<ContactPoint>& contacts) {
  double d = 1e300;
  for (const ContactPoint& p : contacts) d = std::min(d, p.d);
  return d;
}

}  // namespace

TEST_CASE(
    "contact points of random pairs: on the surfaces, along unit outward normals, at the brute-force "
    "distance") {
  for (const PairCase& pair : kCases) {
    DYNAMIC_SECTION(pair.name) {
      // Many, for what one pair in a thousand does.
#ifdef PABD_SANITIZED
      constexpr int kPairs = 200;  // it is the memory that is looked at then
#else
      constexpr int kPairs = 3200;
#endif
      Random random(2024);
      int apart = 0, overlapping = 0;
      for (int trial = 0; apart + overlapping < kPairs; ++trial) {
        const Setup setup = place(pair, random);
        const double reach = setup.reach[0] + setup.reach[1], s = signed_distance(setup, 0, 1, reach + 1e-6);
        const auto contacts = setup.contacts();
        INFO("trial " << trial << ", signed distance " << s << ", contacts " << contacts.size());
        check_points(setup, contacts, s > -0.15);
        if (s > reach + 1e-9) {
          REQUIRE(contacts.empty());
          continue;
        }
        if (s > reach - tolerance(pair, s) || s < -0.15) continue;
        (s > 0 ? apart : overlapping)++;
        REQUIRE(!contacts.empty());
        REQUIRE(smallest_d(contacts) == Approx(s).margin(tolerance(pair, s)));
      }
      REQUIRE(apart > kPairs / 5);
      REQUIRE(overlapping > kPairs / 5);
    }
  }
}

TEST_CASE("contacts move along with a rigid motion of both bodies, and keep their features") {
  for (const PairCase& pair : kCases) {
    DYNAMIC_SECTION(pair.name) {
      Random random(7);
      int found = 0;
      for (int trial = 0; trial < 600; ++trial) {
        const Setup setup = place(pair, random);
        const auto before = setup.contacts();
        const Mat3 T = random.rotation();
        const Vec3 shift = random.within(-3, 3);
        Setup moved = setup;
        for (std::size_t i = 0; i < 2; ++i) {
          moved.c[i] = T * setup.c[i] + shift;
          moved.R[i] = T * setup.R[i];
        }
        const auto after = moved.contacts();
        INFO("trial " << trial);
        REQUIRE(after.size() == before.size());
        for (std::size_t k = 0; k < before.size(); ++k) {
          REQUIRE(after[k].a == before[k].a);
          REQUIRE(after[k].feature == before[k].feature);
          REQUIRE((after[k].y_a - T * before[k].y_a - shift).norm() < 1e-9);
          REQUIRE((after[k].y_b - T * before[k].y_b - shift).norm() < 1e-9);
          REQUIRE((after[k].n - T * before[k].n).norm() < 1e-9);
          REQUIRE(after[k].d == Approx(before[k].d).margin(1e-11));
        }
        found += static_cast<int>(before.size());
      }
      REQUIRE(found > 100);
    }
  }
}

TEST_CASE("a motion of a millionth keeps nearly every feature, and its point close") {
  for (const PairCase& pair : kCases) {
    DYNAMIC_SECTION(pair.name) {
      Random random(11);
      int kept = 0, total = 0;
      for (int trial = 0; trial < 600; ++trial) {
        const Setup setup = place(pair, random);
        Setup moved = setup;
        moved.c[1] += 1e-6 * random.direction();
        moved.R[1] = Eigen::AngleAxisd(1e-6, random.direction()) * setup.R[1];
        const auto before = setup.contacts(), after = moved.contacts();
        for (const ContactPoint& p : before) {
          ++total;
          for (const ContactPoint& q : after) {
            if (q.feature == p.feature && q.a == p.a && (q.y_b - p.y_b).norm() < 1e-3 &&
                (q.n - p.n).norm() < 1e-3) {
              ++kept;
              break;
            }
          }
        }
      }
      // The few that change sit at a true change of feature or on the rim of the reach.
      REQUIRE(total > 100);
      REQUIRE(kept >= 0.995 * total);
    }
  }
}

}  // namespace pabd::test_pairs
