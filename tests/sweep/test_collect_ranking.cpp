// SPDX-License-Identifier: MIT
// The ranking against a case computed by hand, the front against every pair of points.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "app/sweep/collect_plots.h"
#include "app/sweep/collect_ranking.h"
#include "sim/scene/random.h"
#include "tests/sweep/swept_folder.h"

namespace pabd::test_collect_ranking {

using namespace test;

TEST_CASE("the Pareto front is what no other point beats") {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    const std::size_t dimensions = 1 + static_cast<std::size_t>(round % 4),
                      n = 1 + static_cast<std::size_t>(round * 2);
    std::vector<double> points(n * dimensions);
    // Few values, so that many points are equal in something, and some in everything.
    for (double& x : points) x = std::floor(6 * random.uniform());
    const auto at = [&](std::size_t i, std::size_t d) { return points[i * dimensions + d]; };
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < n; ++i) {
      bool beaten = false;
      for (std::size_t j = 0; j < n; ++j) {
        bool all = true, any = false;
        for (std::size_t d = 0; d < dimensions; ++d) {
          all = all && at(j, d) <= at(i, d);
          any = any || at(j, d) < at(i, d);
        }
        beaten = beaten || (all && any);
      }
      if (!beaten) expected.push_back(i);
    }
    CAPTURE(dimensions, n);
    CHECK(pareto_front(points, dimensions) == expected);
  }
}

TEST_CASE("the ranking says which is best in what, and why") {
  // task   κ     penetration   time a step    ranks   sum
  //   0    10    0.004         1 ms           4, 1     5
  //   1    20    0.003         2 ms           3, 2     5   on the front
  //   2    30    0.001         3 ms           1, 3     4   on the front: the best
  //   3    40    0.002         4 ms           2, 4     6   beaten by 2
  //   4    50    diverged, does not count
  const SweptFolder folder;
  const double penetration[] = {0.004, 0.003, 0.001, -0.002, 0};
  for (int i = 0; i < 5; ++i) {
    folder.add({.index = i,
                .parameters = {{"contact.kappa", std::to_string(10 * (i + 1))}, {"contact.N", "2"}},
                .status = i == 4 ? "diverged" : "done",
                .metrics = {{"penetration", std::to_string(penetration[i])}},
                .step_time = i + 1.0});
  }
  const CollectedSweep sweep = collect_sweep(folder.path());
  const Ranking ranking = rank(sweep);
  REQUIRE(ranking.criteria.size() == 2);
  CHECK(ranking.compared == 4);
  REQUIRE(ranking.front.size() == 3);
  CHECK(ranking.front[0].task == 2);
  CHECK(ranking.front[0].ranks == std::vector<std::size_t>{1, 3});
  CHECK(ranking.front[0].sum == 4);
  CHECK(ranking.front[1].task == 0);
  CHECK(ranking.front[1].sum == 5);
  CHECK(ranking.front[2].task == 1);
  REQUIRE(ranking.sentences.size() == 3);
  CHECK(ranking.sentences[0] ==
        "Least penetration: task 2 (κ = 30 J) with 0.001 m; the median of 4 is 0.0025 m, the most is 0.004 m "
        "of task 0.");
  CHECK(ranking.sentences[1] ==
        "Least time a step: task 0 (κ = 10 J) with 1 ms; the median of 4 is 2.5 ms, the most is 4 ms of task "
        "3.");
  CHECK(ranking.sentences[2] ==
        "On the whole task 2 (κ = 30 J) is best: of the 4 compared, 3 are on the Pareto front (no other is "
        "at most as much in "
        "everything and less in something), and of these it has the least sum of ranks, 4: rank 1 in "
        "penetration (0.001 m), "
        "rank 3 in time a step (3 ms). Next comes task 0 (κ = 10 J) with a sum of 5.");

  const Figure figure = pareto_figure(sweep, ranking.criteria);
  REQUIRE(figure.plots.size() == 1);
  const Plot& plot = figure.plots[0];
  CHECK(plot.x.label == "time a step [ms]");
  CHECK(plot.y.label == "penetration [m]");
  CHECK(plot.series[0].x == std::vector<double>{1, 2, 3, 4});
  CHECK(plot.series[1].x == std::vector<double>{1, 2, 3});
  CHECK(plot.series[1].y == std::vector<double>{0.004, 0.003, 0.001});
}

TEST_CASE("what nobody would take is best in nothing, and noise decides nothing") {
  // task   penetration   time a step      the fastest and the one with least penetration are of no use
  //   0    1.22          0.001 ms
  //   1    0.002         0.0204 ms
  //   2    0.002         0.0201 ms        as fast as 1, but for noise
  //   3    0.0001        9 ms
  const double penetration[] = {1.22, 0.002, 0.002, 0.0001}, time[] = {0.001, 0.0204, 0.0201, 9};
  const auto add = [&](const SweptFolder& folder, int i, const std::string& faults) {
    folder.add({.index = i,
                .parameters = {{"contact.kappa", std::to_string(i + 1)}},
                .faults = faults,
                .metrics = {{"penetration", std::to_string(penetration[i])}},
                .step_time = time[i]});
  };
  const SweptFolder folder;
  add(folder, 0, "bodies overlap by 1.22 m");
  add(folder, 1, "");
  add(folder, 2, "");
  add(folder, 3, "7 of 60 steps end unsolved");
  const Ranking ranking = rank(collect_sweep(folder.path()));
  CHECK(ranking.compared == 2);
  CHECK(ranking.unacceptable == 2);
  REQUIRE(ranking.front.size() == 2);  // equal, so that both are on it
  CHECK(ranking.front[0].task == 1);
  CHECK(ranking.front[0].ranks == std::vector<std::size_t>{1, 1});
  CHECK(ranking.front[1].ranks == std::vector<std::size_t>{1, 1});
  CHECK(ranking.sentences[0] == "All 2 tasks have the same penetration, 0.002 m.");
  CHECK(ranking.sentences[1] ==
        "All 2 tasks have the same time a step within the noise, 0.0201 ms to 0.0204 ms.");
  CHECK_THAT(ranking.sentences.back(), Catch::StartsWith("On the whole task 1 (κ = 2 J) is best") &&
                                           Catch::EndsWith("2 are not compared: the column \"why\" says what "
                                                           "makes them unacceptable."));

  const SweptFolder hopeless;
  add(hopeless, 0, "bodies overlap by 1.22 m");
  add(hopeless, 3, "7 of 60 steps end unsolved");
  const Ranking none = rank(collect_sweep(hopeless.path()));
  CHECK(none.front.empty());
  CHECK(none.sentences[0] == "No acceptable task tells its penetration.");
  CHECK(none.sentences[1] == "No acceptable task tells its time a step.");
  CHECK(none.sentences.back() == "None is acceptable: of task 0 (κ = 1 J), bodies overlap by 1.22 m.");
}

TEST_CASE("times are equal within the noise of both, and no farther") {
  // task   time a step   noise     from the least of its equals        rank
  //   0    1 ms          0.3                                           1
  //   1    1.4 ms        0.4       0.4 < hypot(0.3, 0.4) = 0.5         1
  //   2    1.51 ms       0.4       0.51 > 0.5                          3
  //   3    1.6 ms        0.01      0.09 < 0.4, although 0.6 from 0     3
  //   4    3 ms                    1.4 > hypot(0.3, 0.4)               5
  //   5    3.4 ms                  0.4 < hypot(0.3, 0.34) = 0.45       5
  const double time[] = {1, 1.4, 1.51, 1.6, 3, 3.4};
  const std::optional<double> noise[] = {0.3, 0.4, 0.4, 0.01, {}, {}};
  const SweptFolder folder;
  for (int i = 0; i < 6; ++i)
    folder.add({.index = i,
                .parameters = {{"contact.kappa", std::to_string(i + 1)}},
                .metrics = {{"penetration", std::to_string(6 - i)}},
                .step_time = time[i],
                .noise = noise[i]});
  const Ranking ranking = rank(collect_sweep(folder.path()));
  std::map<std::size_t, std::size_t> rank_of;
  for (const Ranked& one : ranking.front) rank_of[one.task] = one.ranks[1];
  // Of equal times the one with less penetration is on the front.
  CHECK(rank_of == std::map<std::size_t, std::size_t>{{1, 1}, {3, 3}, {5, 5}});
  CHECK_THAT(
      ranking.sentences[1],
      Catch::StartsWith("Least time a step: tasks 0 and 1, which are equal within the noise, with 1 ms; "));
}

TEST_CASE("of two costs one counts") {
  // task   penetration   iterations   time a step    ranks of penetration and time
  //   0    0.001         30           3 ms           1, 3
  //   1    0.003         10           1 ms           3, 1
  //   2    0.002         20           2 ms           2, 2
  // All sums are 4, so that the first is named. With the iterations as another cost task 1 would be the best.
  const double penetration[] = {0.001, 0.003, 0.002};
  const int iterations[] = {30, 10, 20};
  for (const bool timed : {true, false}) {
    CAPTURE(timed);
    const SweptFolder folder;
    for (int i = 0; i < 3; ++i) {
      FakeTask task{.index = i,
                    .parameters = {{"contact.kappa", std::to_string(i + 1)}},
                    .metrics = {{"penetration", std::to_string(penetration[i])},
                                {"iterations", std::to_string(iterations[i])}}};
      if (timed) task.step_time = iterations[i] / 10.0;
      folder.add(task);
    }
    const Ranking ranking = rank(collect_sweep(folder.path()));
    REQUIRE(ranking.criteria.size() == (timed ? 3 : 2));
    CHECK(ranking.sentences.size() == ranking.criteria.size() + 1);
    REQUIRE(ranking.front.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(ranking.front[i].task == i);
      CHECK(ranking.front[i].sum == 4);
    }
    CHECK_THAT(ranking.sentences.back(),
               Catch::Contains(timed ? "rank 3 in time a step" : "rank 3 in iterations"));
    CHECK((ranking.sentences.back().find("iterations") == std::string::npos) == timed);
  }
}

TEST_CASE("equal tasks, a single one and none are ranked without nonsense") {
  const SweptFolder none;
  CHECK(rank(collect_sweep(none.path())).sentences ==
        std::vector<std::string>{"No task tells a metric, so that there is nothing to rank."});
  const SweptFolder folder;
  folder.add(
      {.index = 0, .parameters = {{"contact.N", "1"}}, .metrics = {{"drift", "0"}, {"penetration", "1"}}});
  const auto first = rank(collect_sweep(folder.path())).sentences;
  REQUIRE(first.size() == 3);
  CHECK(first[0] == "Least joint drift: task 0, the only one that tells it, with 0 m.");
  CHECK(first[2] == "Only task 0 is done and tells every metric: there is nothing to compare it with.");
  for (const int i : {1, 2})
    folder.add({.index = i,
                .parameters = {{"contact.N", std::to_string(i + 1)}},
                .metrics = {{"drift", "0"}, {"penetration", i == 1 ? "1" : "2"}}});
  const auto all = rank(collect_sweep(folder.path())).sentences;
  CHECK(all[0] == "All 3 tasks have the same joint drift, 0 m.");
  CHECK(all[1] ==
        "Least penetration: tasks 0 and 1, which are equal, with 1 m; the median of 3 is 1 m, the most is 2 "
        "m of task 2.");
}

}  // namespace pabd::test_collect_ranking
