// SPDX-License-Identifier: MIT
// Trails: where the points were, for as long as was asked for, also when time is wound back.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/session/trails.h"
#include "sim/base/error.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_trails {

TEST_CASE("a trail is read, and its words are read as the same") {
  CHECK(parse_trail("com", "--trail").body.empty());
  CHECK(parse_trail("left hand", "--trail").body == "left hand");
  const TrailPoint point = parse_trail("a@b@0.1,-2,3e-1", "--trail");
  CHECK(point.body == "a@b");
  CHECK(point.at == Vec3(0.1, -2, 0.3));
  for (const TrailPoint& p : {point, TrailPoint{}, TrailPoint{"arm", Vec3::Zero()}})
    CHECK(parse_trail(trail_words(p), "--trail") == p);
  for (const char* wrong : {"", "@1,2,3", "a@", "a@1,2", "a@1,2,3,4", "a@1,2,x", "a@1,2,1e9"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_trail(wrong, "--trail"), Error);
  }
  TinyModel tiny;
  tiny.add(Sphere{1}, Vec3::Zero());
  CHECK_NOTHROW(check_trail({}, tiny.model, "--trail"));
  CHECK_NOTHROW(check_trail({"body 0"}, tiny.model, "--trail"));
  CHECK_THROWS_AS(check_trail({"body 1"}, tiny.model, "--trail"), Error);
}

TEST_CASE("trails follow a point of a body and the centre of mass, for the time that was asked for") {
  TinyModel tiny;
  tiny.add(Box{{1, 1, 1}}, Vec3::Zero());
  tiny.add(Box{{1, 1, 1}}, Vec3(4, 0, 0));
  tiny.add_fixed(Sphere{9}, Vec3(0, 90, 0));
  TrailRecorder recorder({{"body 0", Vec3(1, 0, 0)}, {}, {"nobody", Vec3::Zero()}}, 1);
  const auto go = [&](double from, double to) {
    for (double t = from; t < to + 1e-9; t += 0.01) {
      tiny.state.time = t;
      tiny.state.R[0] = Eigen::AngleAxisd(t, Vec3::UnitZ()).toRotationMatrix();
      tiny.state.c[1] = Vec3(4, 2 * t, 0);
      recorder.add(tiny.model, tiny.state);
    }
  };
  go(0, 3);
  const std::vector<Trail> trails = recorder.trails();
  REQUIRE(trails.size() == 3);
  CHECK(trails[0].path.size() == 101);
  CHECK((trails[0].path.back() - Vec3(std::cos(3), std::sin(3), 0)).norm() < 1e-9);
  CHECK((trails[0].path.front() - Vec3(std::cos(2), std::sin(2), 0)).norm() < 0.011);
  CHECK((trails[1].path.back() - Vec3(2, 3, 0)).norm() < 1e-9);
  CHECK_FALSE(trails[2].path.back().allFinite());
  // Wound back: what came later is gone.
  go(2.5, 2.5);
  CHECK((recorder.trails()[0].path.back() - Vec3(std::cos(2.5), std::sin(2.5), 0)).norm() < 1e-9);
  CHECK(recorder.trails()[0].path.size() < 60);
}

TEST_CASE("a trail is broken where the way was not seen, and whole again where it was gone back to") {
  TinyModel tiny;
  tiny.add(Box{{1, 1, 1}}, Vec3::Zero());
  TrailRecorder recorder({{"body 0", Vec3::Zero()}}, 2);
  const auto at = [&](double t, bool unseen = false) {
    tiny.state.time = t;
    tiny.state.c[0] = Vec3(t, 0, 0);
    recorder.add(tiny.model, tiny.state, unseen);
  };
  // Lengths of the pieces that are drawn; a chord over the gap would be 0.5.
  const auto longest = [&] {
    double most = 0;
    const std::vector<Vec3> path = recorder.trails()[0].path;
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      if (path[k].allFinite() && path[k + 1].allFinite())
        most = std::max(most, (path[k + 1] - path[k]).norm());
    return most;
  };
  for (int k = 0; k <= 50; ++k) at(0.01 * k);
  at(1, true);
  at(1);  // shown again, as a window at rest does
  CHECK(longest() < 0.011);
  for (int k = 1; k <= 50; ++k) at(1 + 0.001 * k);  // in pieces that are put together
  CHECK(longest() < 0.011);
  CHECK(recorder.trails()[0].path.back().x() == Approx(1.05));
  at(1.02);  // back on the way that was seen
  CHECK(longest() < 0.011);
  at(0.7);  // and into the gap: nothing leads there
  CHECK(longest() < 0.011);
  at(0.3);
  at(0.31);
  CHECK(longest() < 0.011);
  const std::vector<Vec3> path = recorder.trails()[0].path;
  for (const Vec3& p : path) CHECK(p.allFinite());
}

}  // namespace pabd::test_trails
