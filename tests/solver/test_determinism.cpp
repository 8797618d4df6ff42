// SPDX-License-Identifier: MIT
// The same bits for every number of threads: every loop that is shared runs on all of them here, also in
// scenes that are too small to be worth it.

#include <catch2/catch.hpp>

#include "sim/scene/scene.h"
#include "sim/solver/step_memory.h"
#include "sim/solver/time_step.h"
#include "sim/solver/workers.h"
#include "tests/solver/same_report.h"
#include "tests/support/places.h"

namespace pabd::test_determinism {

using test::require_same;

namespace {

constexpr Sharing kEveryLoop{1, 1, true};  // item by item, by every thread, from the last to the first

// What a run comes to: its end, and what every step said.
struct Outcome {
  State end;
  std::vector<StepReport> reports;
};

Outcome run(const Scene& scene, SolverMethod method, int threads, int steps) {
  Params params = scene.params;
  params.solver.method = method;
  params.solver.iterations = std::min(params.solver.iterations, 6);
  StepWorkspace workspace;
  workspace.memory().detection.collision.team = Team(kEveryLoop);
  const StepOptions options{true, true, threads, {}, true, true};
  Outcome out{scene.initial, {}};
  for (int k = 0; k < steps; ++k) {
    StepReport report;
    step(scene.model, params, options, out.end, workspace, report);
    out.reports.push_back(std::move(report));
  }
  return out;
}

}  // namespace

TEST_CASE("every solver gives the same bits on 1, 2, 3 and 8 threads, in scenes of every kind") {
  for (const char* name :
       {"two_boxes", "shapes", "meshes", "chairs", "stack", "ragdoll", "bridge", "card_house"}) {
    const Scene scene = load_scene(std::string(places::scenes() + "/") + name + ".json");
    for (const SolverMethod method :
         {SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm}) {
      constexpr int kSteps = 4;
      const Outcome alone = run(scene, method, 1, kSteps);
      for (const int threads : {2, 3, 8}) {
        INFO(name << ", " << to_string(method) << ", " << threads << " threads");
        const Outcome together = run(scene, method, threads, kSteps);
        CHECK(same_bits(together.end, alone.end));
        for (int k = 0; k < kSteps; ++k) require_same(together.reports[k], alone.reports[k]);
      }
    }
  }
}

TEST_CASE("sticking and sliding contacts: the same bits for every number of threads") {
  for (const double slope : {0.3, 0.9}) {  // tan of the angle; μ = 0.5
    const Scene scene = load_scene(places::scenes() + "/incline.json",
                                   {"gravity=[" + std::to_string(-9 * slope) + ",-9,0.5]"});
    for (const SolverMethod method : {SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm}) {
      const Outcome alone = run(scene, method, 1, 20);
      REQUIRE_FALSE(alone.end.contacts.empty());
      for (const int threads : {2, 3, 8}) CHECK(same_bits(run(scene, method, threads, 20).end, alone.end));
    }
  }
}

TEST_CASE("sums have the same bits for every number of threads, and every term once") {
  Team team(kEveryLoop);
  std::vector<double> blocks;
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, std::size_t{512}, std::size_t{513}, std::size_t{10000}}) {
    const auto sum = [&](int threads, const auto& term) {
      return Workers{team, threads, {}}.sum(count, 0.0, blocks, term);
    };
    const auto n = static_cast<double>(count);
    const auto reciprocal = [](std::size_t k) { return 1 / (1.0 + static_cast<double>(k)); };
    for (const int threads : {1, 2, 8}) {
      CHECK(sum(threads, [](std::size_t k) { return static_cast<double>(k); }) == 0.5 * n * (n - 1));
      CHECK(sum(threads, reciprocal) == sum(1, reciprocal));
    }
  }
}

}  // namespace pabd::test_determinism
