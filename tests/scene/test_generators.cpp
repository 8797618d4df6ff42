// SPDX-License-Identifier: MIT
// Generators: how many bodies, where, and that nothing overlaps at the start.
#include <algorithm>
#include <set>
#include <variant>

#include "tests/scene/scene_helpers.h"

namespace pabd::test_generators {

using namespace test;

namespace {

constexpr double kDHat = 0.02;

Scene generate(const std::string& generator) {
  return parse(scene_text(R"("contact": { "d_hat": 0.02 }, "generate": [ )" + generator + " ]"));
}

Vec3 half(const Scene& s, Index i) { return std::get<Box>(s.model.shape[static_cast<std::size_t>(i)]).half; }

// Gap between two boxes that are not turned: the largest over the axes; negative when they overlap.
double box_gap(const Scene& s, Index i, Index j) {
  const Vec3 centre =
      (s.initial.c[static_cast<std::size_t>(i)] - s.initial.c[static_cast<std::size_t>(j)]).cwiseAbs();
  return (centre - half(s, i) - half(s, j)).maxCoeff();
}

double smallest_gap(const Scene& s) {
  double gap = 1e300;
  for (Index i = 0; i < s.model.size(); ++i) {
    for (Index j = 0; j < i; ++j) gap = std::min(gap, box_gap(s, i, j));
  }
  return gap;
}

}  // namespace

TEST_CASE("stack: count, heights, gaps, masses, turn", "[scene]") {
  const Scene s = generate(R"({ "type": "stack", "count": 5, "size": [1, 2, 3], "position": [4, 5, 6],
                               "masses": [1, 100], "rotate": 90 })");
  REQUIRE(s.model.size() == 5);
  CHECK(s.model.name[0] == "stack 0");
  CHECK(s.model.name[4] == "stack 4");
  for (std::size_t i = 0; i < 5; ++i) {
    const double level = static_cast<double>(i);
    CHECK((s.initial.c[i] - Vec3(4, 5 + 2 * level + 1 + 0.95 * kDHat * (level + 1), 6)).norm() < 1e-12);
    CHECK(s.model.mass[i] == (i % 2 == 0 ? 1 : 100));
    CHECK(s.model.fixed[i] == 0);
  }
  CHECK((s.initial.R[1] * Vec3::UnitX() - Vec3(0, 0, -1)).norm() < 1e-15);  // +90° about y
  CHECK((s.initial.R[4] - Mat3::Identity()).norm() < 1e-15);
  CHECK(smallest_gap(s) == Approx(0.95 * kDHat).epsilon(1e-9));

  const Scene wide = generate(R"({ "type": "stack", "count": 2, "gap": 0.5, "density": 10, "name": "x" })");
  CHECK(wide.initial.c[0].y() == Approx(1.0).epsilon(1e-14));
  CHECK(wide.initial.c[1].y() == Approx(2.5).epsilon(1e-14));
  CHECK(wide.model.mass[0] == Approx(10).epsilon(1e-14));
  CHECK(wide.model.name[1] == "x 1");
}

TEST_CASE("pyramid: a base of 10 gives 55 bricks, of 20 gives 210", "[scene]") {
  const Scene s =
      generate(R"({ "type": "pyramid", "base": 10, "size": [1, 0.5, 0.5], "position": [5, 0, 0] })");
  REQUIRE(s.model.size() == 55);
  CHECK(generate(R"({ "type": "pyramid", "base": 20 })").model.size() == 210);
  CHECK(s.model.name[0] == "pyramid 0.0");
  CHECK(s.model.name[13] == "pyramid 1.3");
  CHECK(s.model.name[54] == "pyramid 9.0");
  CHECK(s.initial.c[54].x() == Approx(5).margin(1e-12));
  CHECK(s.initial.c[1].x() - s.initial.c[0].x() == Approx(1 + kDHat).epsilon(1e-12));
  CHECK(s.initial.c[10].x() - s.initial.c[0].x() == Approx((1 + kDHat) / 2).epsilon(1e-12));
  CHECK(s.initial.c[10].y() - s.initial.c[0].y() == Approx(0.5 + 0.95 * kDHat).epsilon(1e-12));
  CHECK(smallest_gap(s) == Approx(0.95 * kDHat).epsilon(1e-9));
}

TEST_CASE("wall: running bond with and without half blocks", "[scene]") {
  const Scene s = generate(
      R"({ "type": "wall", "columns": 4, "rows": 3, "size": [1, 0.5, 0.5], "position": [0, 1, 2] })");
  REQUIRE(s.model.size() == 4 + 5 + 4);
  CHECK(s.model.name[4] == "wall 1.0");
  CHECK(half(s, 4).x() == Approx((1 - kDHat) / 4).epsilon(1e-12));  // half of half a brick less the joint
  CHECK(half(s, 5).x() == 0.5);
  // Rows end flush.
  const double end_even = s.initial.c[3].x() + half(s, 3).x(), end_odd = s.initial.c[8].x() + half(s, 8).x();
  CHECK(end_even == Approx(end_odd).epsilon(1e-12));
  CHECK(s.initial.c[5].x() == Approx(0.5 * (s.initial.c[0].x() + s.initial.c[1].x())).epsilon(1e-12));
  CHECK(smallest_gap(s) == Approx(0.95 * kDHat).epsilon(1e-9));
  // Sideways no contact: neighbours of a row are d̂ apart.
  for (Index i : {0, 1, 2, 4, 5, 6, 7, 9, 10, 11}) CHECK(box_gap(s, i, i + 1) == Approx(kDHat).epsilon(1e-9));

  CHECK(generate(R"({ "type": "wall", "columns": 4, "rows": 3, "half_blocks": false })").model.size() ==
        4 + 3 + 4);
}

TEST_CASE("pile: no overlap however the bodies are turned, none below the ground", "[scene]") {
  const Scene s =
      generate(R"({ "type": "pile", "count": 200, "shape": "mixed", "size": [1, 0.5, 0.7], "vary": 0.3,
                               "position": [1, 2, 3] })");
  REQUIRE(s.model.size() == 200);
  std::set<std::size_t> kinds;
  Vec3 mean = Vec3::Zero();
  for (Index i = 0; i < s.model.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    kinds.insert(s.model.shape[k].index());
    mean += s.initial.c[k] / 200;
    const double r = bounding_radius(s.model.shape[k]);
    CHECK(s.initial.c[k].y() - r >= 2 + kDHat * (1 - 1e-9));
    CHECK((s.initial.R[k].transpose() * s.initial.R[k] - Mat3::Identity()).norm() < 1e-14);
    CHECK(s.initial.R[k].determinant() == Approx(1).epsilon(1e-14));
    for (std::size_t j = 0; j < k; ++j) {
      const double gap = (s.initial.c[k] - s.initial.c[j]).norm() - r - bounding_radius(s.model.shape[j]);
      REQUIRE(gap >= kDHat * (1 - 1e-9));
    }
  }
  CHECK(kinds.size() == 3);
  CHECK(std::abs(mean.x() - 1) < 0.5);
  CHECK(std::abs(mean.z() - 3) < 0.5);
}

TEST_CASE("pile: the same seed gives the same bodies everywhere", "[scene]") {
  const char* text = R"({ "type": "pile", "count": 2, "seed": 1 })";
  const Scene a = generate(text), b = generate(text);
  const Scene c = generate(R"({ "type": "pile", "count": 2, "seed": 2 })");
  CHECK(a.initial.c[1] == b.initial.c[1]);
  CHECK(a.initial.R[1] == b.initial.R[1]);
  CHECK(a.initial.c[1] != c.initial.c[1]);
  CHECK(a.hash != c.hash);
}

TEST_CASE("generators of one type get names of their own, after the listed bodies", "[scene]") {
  const Scene s =
      parse(with_body(R"("generate": [ { "type": "stack", "count": 2 }, { "type": "stack", "count": 1,
                                     "position": [5, 0, 0] }, { "type": "pile", "count": 1, "position": [9, 0, 0] } ])"));
  CHECK(s.model.name == std::vector<std::string>{"ball", "stack 0", "stack 1", "stack2 0", "pile 0"});
}

TEST_CASE("a large pile is a few lines", "[scene]") {
  const Scene s =
      generate(R"({ "type": "pile", "count": 100000, "shape": "mixed", "size": [0.5, 0.5, 0.5] })");
  CHECK(s.model.size() == 100000);
  CHECK(s.model.name[99999] == "pile 99999");
}

}  // namespace pabd::test_generators
