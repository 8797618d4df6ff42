// SPDX-License-Identifier: MIT
// The grid finds exactly the pairs that comparing all with all finds.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/collision/reference.h"
#include "tests/support/draws.h"

namespace pabd::test_broad_phase {

using namespace reference;

namespace {

std::vector<IndexPair> all_pairs(const std::vector<Aabb>& boxes, const std::vector<std::uint8_t>& fixed) {
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (fixed[i] && fixed[j]) continue;
      bool meet = true;
      for (int k = 0; k < 3; ++k) {
        meet = meet && boxes[i].lo[k] <= boxes[j].hi[k] && boxes[j].lo[k] <= boxes[i].hi[k];
      }
      if (meet) pairs.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
    }
  return pairs;
}

struct Bodies {
  std::vector<Aabb> boxes;
  std::vector<std::uint8_t> fixed;
  void add(const Vec3& centre, const Vec3& half, bool is_fixed = false) {
    boxes.push_back({centre - half, centre + half});
    fixed.push_back(is_fixed);
  }
};

std::vector<IndexPair> found(const Bodies& bodies, int threads = 1) {
  BroadPhase broad_phase;
  Team team;
  std::vector<IndexPair> pairs;
  broad_phase.find({bodies.boxes, bodies.fixed, {}, {}}, threads, team, pairs);
  return pairs;
}

}  // namespace

TEST_CASE("random bodies of one size, of many sizes, spread flat and spread wide") {
  struct Spread {
    double smallest, largest;  // half edges
    Vec3 room;
  };
  const Spread spreads[] = {{0.5, 0.5, {8, 8, 8}},          {0.4, 0.9, {20, 0.1, 20}},
                            {0.001, 10, {15, 15, 15}},      {1e-6, 1e3, {100, 100, 100}},
                            {0.5, 0.5, {1e7, 1, 1}},        {0.5, 2, {0, 0, 60}},
                            {0.5, 0.5, {1e12, 1e12, 1e12}}, {0, 0, {0, 0, 0}}};
  Random random(17);
  for (const Spread& spread : spreads) {
    Bodies bodies;
    for (int i = 0; i < 500; ++i) {
      const auto side = [&] {
        if (spread.largest == 0) return 0.0;
        return std::exp(random.uniform(std::log(spread.smallest), std::log(spread.largest)));
      };
      const Vec3 where = random.within(-1, 1), half = testing::draw_vector(side);
      bodies.add(where.cwiseProduct(spread.room), half, i % 7 == 0);
    }
    const auto expected = all_pairs(bodies.boxes, bodies.fixed);
    INFO("half edges " << spread.smallest << " to " << spread.largest << ", pairs " << expected.size());
    CHECK(found(bodies) == expected);
    CHECK(found(bodies, 3) == expected);
  }
}

TEST_CASE("touching counts, on a lattice that lies on the cell borders") {
  Bodies bodies;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= 5; ++y)
      for (int z = -2; z <= 2; ++z) bodies.add(Vec3(x, y, z), Vec3::Constant(0.5));
  const auto expected = all_pairs(bodies.boxes, bodies.fixed);
  CHECK(expected.size() > 5000);  // 26 neighbours each
  CHECK(found(bodies) == expected);
}

TEST_CASE("one large body under many small ones") {
  Bodies bodies;
  bodies.add(Vec3(0, -10, 0), Vec3(100, 10, 100), true);
  Random random(2);
  for (int i = 0; i < 400; ++i) {
    const Vec3 where = random.within(-9, 9);
    bodies.add({where.x(), std::abs(where.y()) / 6, where.z()}, Vec3::Constant(0.4));
  }
  CHECK(found(bodies) == all_pairs(bodies.boxes, bodies.fixed));
}

TEST_CASE("unbounded and non-finite bodies take no part, and do no harm") {
  constexpr double inf = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN();
  Bodies bodies;
  bodies.add(Vec3::Zero(), Vec3::Constant(1));
  bodies.add(Vec3::Zero(), Vec3::Constant(inf));
  bodies.add(Vec3(nan, 0, 0), Vec3::Constant(1));
  bodies.add(Vec3(0.5, 0, 0), Vec3::Constant(1));
  bodies.add(Vec3(1e300, 0, 0), Vec3::Constant(1e299));
  CHECK(found(bodies) == std::vector<IndexPair>{{0, 3}});
  CHECK(found(Bodies{}).empty());
}

namespace {

// Balls of radius ½, as the broad phase sees them.
struct Balls : Bodies {
  std::vector<InnerBall> cores;
  CollisionGroups groups;
  std::int64_t left = 0;

  void add_ball(const Vec3& c) {
    add(c, Vec3::Constant(0.5));
    cores.push_back({c, 0.5});
  }
  void add_crowd(int n, double spread) {
    Random random(3);
    for (int i = 0; i < n; ++i) add_ball(spread * random.within(-1, 1));
  }
  std::vector<IndexPair> pairs(int threads = 1) {
    BroadPhase broad_phase;
    Team team;
    std::vector<IndexPair> out;
    const auto core_of = [this](Index i) { return cores[static_cast<std::size_t>(i)]; };
    broad_phase.find({boxes, fixed, core_of, groups}, threads, team, out);
    left = broad_phase.left;
    return out;
  }
};

}  // namespace

TEST_CASE("of bodies at one point each meets those that follow it, and all others are counted") {
  struct Crowd {
    std::int64_t bodies, met;
  };
  // Of 100,000 there are more pairs than 32 bits hold.
  for (const auto& [n, met] : {Crowd{10, 8}, {3000, 8}, {100'000, 2}}) {
    Balls balls;
    balls.add_crowd(static_cast<int>(n), 0);
    const auto pairs = balls.pairs();
    REQUIRE(static_cast<std::int64_t>(pairs.size()) == met * n - met * (met + 1) / 2);
    CHECK(balls.left == n * (n - 1) / 2 - static_cast<std::int64_t>(pairs.size()));
    CHECK(pairs.front() == IndexPair(0, 1));
    CHECK(pairs.back() == IndexPair(n - 2, n - 1));
  }
}

TEST_CASE("of a crowd that is spread out each meets a few, and a few meet it, for every number of threads") {
  for (const double spread : {0.01, 0.7, 2.0, 5.0}) {
    Balls balls;
    balls.add_crowd(20'000, spread);
    const auto pairs = balls.pairs();
    CAPTURE(spread, pairs.size(), balls.left);
    CHECK(pairs.size() <= 8u * 20'000);
    CHECK(pairs.size() > 4u * 20'000);
    CHECK(std::is_sorted(pairs.begin(), pairs.end()));
    CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
    std::vector<int> ends(20'000, 0);
    for (const auto& [a, b] : pairs) {
      ++ends[static_cast<std::size_t>(a)];
      ++ends[static_cast<std::size_t>(b)];
    }
    CHECK(*std::max_element(ends.begin(), ends.end()) < 100);
    CHECK(balls.pairs(3) == pairs);
  }
}

TEST_CASE("who is in no crowd meets all that it overlaps") {
  Balls balls;
  balls.add_crowd(500, 0.1);
  balls.add(Vec3(0, -5.4, 0), Vec3(20, 5, 20), true);
  balls.cores.push_back({Vec3(0, -5.4, 0), 5});
  balls.add(Vec3(0.9, 0, 0), Vec3::Constant(0.5));
  balls.cores.push_back({Vec3(2, 0, 0), 0.01});
  std::array<int, 502> met{};
  for (const auto& [a, b] : balls.pairs()) ++met[static_cast<std::size_t>(b)];
  CHECK(met[500] == 500);
  CHECK(met[501] == 501);
}

TEST_CASE("bodies that avoid each other are no crowd, in one cell or in several") {
  const double spread = GENERATE(0.1, 1.0);
  Balls balls;
  balls.add_crowd(300, spread);
  const auto all = all_pairs(balls.boxes, balls.fixed);
  balls.groups.apart = {1};
  balls.groups.of_body.assign(300, 1);
  find_avoided(balls.groups);
  CHECK(balls.pairs().empty());
  CHECK(balls.left == 0);
  // One of them meets all.
  balls.groups.of_body[7] = 0;
  find_avoided(balls.groups);
  const auto of_7 = std::count_if(all.begin(), all.end(),
                                  [](const IndexPair& pair) { return pair.first == 7 || pair.second == 7; });
  CHECK(balls.pairs().size() == static_cast<std::size_t>(of_7));
}

}  // namespace pabd::test_broad_phase
