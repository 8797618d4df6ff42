// SPDX-License-Identifier: MIT
// Edges and axes that run side by side: contacts at both ends of what they share, and nothing jumps while the
// angle between them goes through zero.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "sim/body/convex_hull.h"
#include "tests/collision/reference.h"

namespace pabd::test_side_by_side {

using namespace reference;

namespace {

struct Pair {
  const char* name;
  Shape lower, upper;  // the edge or axis that matters runs along z
};

// Extent across the edge that points up, when the shape stands on the opposite one, and the turn that does
// it.
double reach_up(const Shape& shape) {
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return support(shape, Vec3::Zero(), Mat3::Identity(), Vec3(3, 4, 0) / 5);
}
Mat3 stand(const Shape& shape) {
  if (std::holds_alternative<Capsule>(shape))
    return Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()).toRotationMatrix();
  return Eigen::AngleAxisd(kPi / 2 - std::atan2(4, 3), Vec3::UnitZ()).toRotationMatrix();
}

const Vec3 kLower(0.3, 0.4, 0.5), kUpper(0.15, 0.2, 0.4);  // half edges; (3, 4, 0) points to an edge
const Pair kPairs[] = {
    {"box box", Box{kLower}, Box{kUpper}},
    {"hull hull", hull_of_box(kLower), hull_of_box(kUpper)},
    {"hull box", hull_of_box(kLower), Box{kUpper}},
    {"box hull", Box{kLower}, hull_of_box(kUpper)},
    {"box capsule", Box{kLower}, Capsule{0.1, 0.8}},
    {"capsule box", Capsule{0.1, 1.0}, Box{kUpper}},
    {"hull capsule", hull_of_box(kLower), Capsule{0.1, 0.8}},
    {"capsule capsule", Capsule{0.1, 1.0}, Capsule{0.2, 0.8}},
};

// One above the other with a gap, shifted along z; the upper one turned by Q about the middle between them.
Setup stacked(const Pair& pair, double gap, double shift, const Mat3& Q = Mat3::Identity(),
              const Vec3& aside = Vec3::Zero()) {
  Setup setup;
  const double low = reach_up(pair.lower), high = reach_up(pair.upper);
  setup.add(pair.lower, Vec3(0, -low, 0), stand(pair.lower), 0.01);
  setup.add(pair.upper, Q * Vec3(0, gap + high, shift) + aside, Q * stand(pair.upper), 0.01);
  return setup;
}

Mat3 turn(double radians, const Vec3& axis) {
  return Eigen::AngleAxisd(radians, axis.normalized()).toRotationMatrix();
}

std::set<std::uint32_t> names(const std::vector<ContactPoint>& contacts) {
  std::set<std::uint32_t> out;
  for (const ContactPoint& p : contacts) out.insert(p.feature);
  return out;
}

double smallest_d(const std::vector<ContactPoint>& contacts) {
  double d = 1e300;
  for (const ContactPoint& p : contacts) d = std::min(d, p.d);
  return d;
}

}  // namespace

TEST_CASE("edges side by side touch at both ends of the stretch they share") {
  for (const Pair& pair : kPairs) {
    for (const double shift : {0.0, 0.1, 0.25, -0.6}) {
      const auto contacts = stacked(pair, 0.004, shift).contacts();
      INFO(pair.name << ", shift " << shift);
      REQUIRE(contacts.size() == 2);
      const double low = std::max(-0.5, shift - 0.4), high = std::min(0.5, shift + 0.4);
      const double z_0 = contacts[0].y_b.z(), z_1 = contacts[1].y_b.z();
      CHECK(std::min(z_0, z_1) == Approx(low).margin(1e-12));
      CHECK(std::max(z_0, z_1) == Approx(high).margin(1e-12));
      for (const ContactPoint& p : contacts) {
        CHECK(p.d == Approx(0.004).margin(1e-12));
        CHECK(std::abs(p.n.y()) == Approx(1).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a rounding error of a turn neither moves nor renames the ends") {
  Random random(3);
  for (const Pair& pair : kPairs) {
    const auto expected = stacked(pair, 0.004, 0.05).contacts();
    for (int trial = 0; trial < 200; ++trial) {
      const double size = std::pow(10.0, random.uniform(-16, -4));
      const auto contacts = stacked(pair, 0.004, 0.05, turn(size, random.direction())).contacts();
      INFO(pair.name << ", turned by " << size);
      REQUIRE(names(contacts) == names(expected));
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        REQUIRE(contacts[k].a == expected[k].a);
        REQUIRE((contacts[k].y_b - expected[k].y_b).norm() < 10 * size + 1e-12);
        REQUIRE(std::abs(contacts[k].d - expected[k].d) < 2 * size + 1e-12);
      }
    }
  }
}

TEST_CASE("points move continuously while the angle goes through zero") {
  constexpr double kStep = 2e-6, kMost = 0.01;
  for (const Pair& pair : kPairs) {
    for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0.2, 1, 0), Vec3(1, 0.3, 0)}) {
      std::map<std::uint32_t, Vec3> last;
      double last_d = 0;
      int renamed = 0;
      INFO(pair.name << ", about " << axis.transpose());
      for (double angle = -kMost; angle < kMost; angle += kStep) {
        const auto contacts = stacked(pair, 0.004, 0.05, turn(angle, axis)).contacts();
        const double d = smallest_d(contacts);
        std::map<std::uint32_t, Vec3> now;
        for (const ContactPoint& p : contacts) now[p.feature] = p.y_b;
        REQUIRE(contacts.size() <= 3);
        REQUIRE(now.size() == contacts.size());
        if (!last.empty()) {
          renamed += now.size() != last.size() ? 1 : 0;
          for (const auto& [name, point] : now) {
            if (last.count(name) > 0) REQUIRE((point - last[name]).norm() < 1e-3);
          }
          REQUIRE(std::abs(d - last_d) < 2e-4);
        }
        last = now;
        last_d = d;
      }
      CHECK(renamed <=
            4);  // a place between comes once and goes once, an end leaves the reach and comes back
    }
  }
}

TEST_CASE("edges nearly side by side: on the surfaces, outward, at the brute-force distance") {
  Random random(17);
  for (const Pair& pair : kPairs) {
    int two = 0;
    for (int trial = 0; trial < 150; ++trial) {
      const double gap = random.uniform(0.001, 0.01), most = trial % 2 == 0 ? 0.3 : 0.01;
      const double along = random.uniform(-0.3, 0.3);
      const Mat3 turned = random.turn(most);
      const Setup setup = stacked(pair, gap, along, turned, 0.5 * gap * random.direction());
      const double s = signed_distance(setup, 0, 1);
      const auto contacts = setup.contacts();
      INFO(pair.name << ", trial " << trial << ", signed distance " << s);
      if (s > 0.019 || s < 0) continue;
      REQUIRE(!contacts.empty());
      two += contacts.size() > 1 ? 1 : 0;
      REQUIRE(contacts.size() <= 4);
      REQUIRE(smallest_d(contacts) == Approx(s).margin(0.021 * s + 2e-4));
      for (const ContactPoint& p : contacts) {
        const auto i = static_cast<std::size_t>(p.a), j = static_cast<std::size_t>(p.b);
        REQUIRE((p.y_b - p.y_a - p.d * p.n).norm() < 1e-12);
        REQUIRE(std::abs(surface_distance(setup.model.shape[j], setup.c[j], setup.R[j], p.y_b)) < 1e-12);
        REQUIRE(std::abs(surface_distance(setup.model.shape[i], setup.c[i], setup.R[i], p.y_a)) < 1e-12);
        REQUIRE(support(setup.model.shape[i], setup.c[i], setup.R[i], p.n) - p.n.dot(p.y_a) < 1e-12);
      }
    }
    CHECK(two > 40);
  }
}

TEST_CASE("prisms of many sides, one beside the other, touch at both ends wherever they are rolled") {
  const auto prism = [](int sides) {
    std::vector<Vec3> points;
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * kPi * k / sides;
      for (const double z : {-0.3, 0.3}) points.emplace_back(0.1 * std::cos(a), 0.1 * std::sin(a), z);
    }
    return Shape(Hull{make_hull(points).hull});
  };
  Random random(23);
  for (const int sides : {7, 24, 64}) {
    const Shape shape = prism(sides);
    for (int trial = 0; trial < 100; ++trial) {
      const double around = random.uniform(0, 2 * kPi), shift = random.uniform(0.05, 0.2);
      const Vec3 beside(std::cos(around), std::sin(around), 0);
      const Mat3 R_a = turn(random.uniform(0, 1), Vec3::UnitZ()),
                 R_b = turn(random.uniform(0, 1), Vec3::UnitZ());
      const auto contacts_at = [&](double apart, double reach) {
        Setup setup;
        setup.add(shape, Vec3::Zero(), R_a, reach);
        setup.add(shape, apart * beside + shift * Vec3::UnitZ(), R_b, reach);
        return setup.contacts();
      };
      double apart = 0.2;
      for (int k = 0; k < 20; ++k) apart += 0.001 - smallest_d(contacts_at(apart, 0.05));
      const auto contacts = contacts_at(apart, 0.002);
      double low = 1, high = -1;
      for (const ContactPoint& p : contacts) {
        low = std::min(low, p.y_b.z());
        high = std::max(high, p.y_b.z());
      }
      INFO(sides << " sides, trial " << trial);
      REQUIRE(contacts.size() >= 2);
      CHECK(low == Approx(shift - 0.3).margin(1e-9));
      CHECK(high == Approx(0.3).margin(1e-9));
      CHECK(smallest_d(contacts) == Approx(0.001).margin(1e-4));
    }
  }
}

}  // namespace pabd::test_side_by_side
