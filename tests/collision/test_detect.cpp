// SPDX-License-Identifier: MIT
// Whole scenes: order, threads, fixed bodies, skipped pairs.
#include <catch2/catch.hpp>
#include <cstring>
#include <set>

#include "tests/collision/heap.h"

namespace pabd::test_detect {

using namespace reference;

namespace {

bool same(const std::vector<ContactPoint>& p, const std::vector<ContactPoint>& q) {
  if (p.size() != q.size()) return false;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k].a != q[k].a || p[k].b != q[k].b || p[k].feature != q[k].feature || p[k].y_a != q[k].y_a ||
        p[k].y_b != q[k].y_b || p[k].n != q[k].n || p[k].d != q[k].d) {
      return false;
    }
  }
  return true;
}

IndexPair ordered(const ContactPoint& p) { return {std::min(p.a, p.b), std::max(p.a, p.b)}; }

}  // namespace

TEST_CASE("the result is sorted and the same for every number of threads") {
  const Setup setup = heap(400, 1);
  const auto contacts = setup.contacts(1);
  REQUIRE(contacts.size() > 1000);
  for (std::size_t k = 1; k < contacts.size(); ++k) {
    const auto before = std::make_pair(ordered(contacts[k - 1]), contacts[k - 1].feature);
    REQUIRE(before <
            std::make_pair(ordered(contacts[k]), contacts[k].feature));  // strictly: no feature twice
  }
  for (const int threads : {2, 3, 8}) CHECK(same(contacts, setup.contacts(threads)));
}

TEST_CASE("the pairs of a scene are those of its bodies taken two by two") {
  const Setup setup = heap(120, 4);
  const auto contacts = setup.contacts();
  std::vector<ContactPoint> one_by_one;
  const Index n = setup.model.size();
  for (Index i = 0; i < n; ++i)
    for (Index j = i + 1; j < n; ++j) {
      Setup two;
      for (const Index body : {i, j}) {
        const auto k = static_cast<std::size_t>(body);
        two.add(setup.model.shape[k], setup.c[k], setup.R[k], setup.reach[k], setup.model.fixed[k] != 0);
      }
      for (ContactPoint p : two.contacts()) {
        p.a = p.a == 0 ? i : j;
        p.b = p.b == 0 ? i : j;
        one_by_one.push_back(p);
      }
    }
  CHECK(same(contacts, one_by_one));
}

TEST_CASE("fixed bodies never meet each other, skipped pairs never meet at all") {
  const Setup setup = heap(300, 9);
  const auto contacts = setup.contacts();
  std::set<IndexPair> pairs;
  for (const auto& p : contacts) {
    CHECK_FALSE((setup.model.fixed[static_cast<std::size_t>(p.a)] &&
                 setup.model.fixed[static_cast<std::size_t>(p.b)]));
    pairs.insert(ordered(p));
  }
  std::vector<IndexPair> skip;
  int k = 0;
  for (const auto& pair : pairs) {
    if (k++ % 3 == 0) skip.push_back(pair);
  }
  skip.emplace_back(Index{0}, Index{1});  // may not touch: does no harm
  std::sort(skip.begin(), skip.end());
  skip.erase(std::unique(skip.begin(), skip.end()), skip.end());

  std::vector<ContactPoint> expected;
  for (const auto& p : contacts) {
    if (!std::binary_search(skip.begin(), skip.end(), ordered(p))) expected.push_back(p);
  }
  CHECK(same(setup.contacts(1, skip), expected));
  CHECK(same(setup.contacts(4, skip), expected));
}

TEST_CASE("a larger reach adds contacts and changes none") {
  Setup setup = heap(200, 21);
  const auto near = setup.contacts();
  for (double& reach : setup.reach) reach += 0.05;
  const auto far = setup.contacts();
  CHECK(far.size() > near.size());
  std::size_t k = 0;
  for (const auto& p : near) {
    while (k < far.size() && !(ordered(far[k]) == ordered(p) && far[k].feature == p.feature)) ++k;
    REQUIRE(k < far.size());
    REQUIRE(far[k].d == p.d);
    REQUIRE(far[k].y_b == p.y_b);
  }
}

TEST_CASE("an empty scene, a lone body and non-finite poses give no contacts") {
  Setup setup;
  CHECK(setup.contacts().empty());
  setup.add(Sphere{1}, Vec3::Zero());
  CHECK(setup.contacts().empty());
  setup.add(Sphere{1}, Vec3::Constant(std::nan("")));
  setup.add(Plane{Vec3::UnitY(), -10}, Vec3::Zero());
  CHECK(setup.contacts(2).empty());
}

}  // namespace pabd::test_detect
