// SPDX-License-Identifier: MIT
// A run that is wound back: the past is what it was, to the last bit, also where its states were dropped.
#include <catch2/catch.hpp>

#include "app/session/run.h"
#include "sim/scene/tuning.h"
#include "tests/workbench/workbench_helpers.h"

namespace pabd::test_run {

using test::kPlenty, test::two_boxes;

TEST_CASE("seeking gives the states and reports of the steps as they were made") {
  const auto scene = two_boxes();
  Run run(scene, 1, kPlenty);
  run.observe(true, true);
  Session plain(scene);
  plain.record_iterations(true);
  plain.report_contacts(true);
  std::vector<State> states{plain.state()};
  std::vector<StepReport> reports{plain.report()};
  for (int i = 0; i < 40; ++i) {
    REQUIRE(run.advance());
    plain.step();
    states.push_back(plain.state());
    reports.push_back(plain.report());
  }
  for (const std::size_t i : {7u, 40u, 0u, 39u, 8u, 9u, 10u}) {
    run.seek(i);
    CHECK(run.cursor() == i);
    CHECK(same_bits(run.state(), states[i]));
    CHECK(run.report().records.size() == reports[i].records.size());
    CHECK(run.report().contact_reports.size() == reports[i].contact_reports.size());
    CHECK(run.report().residual == reports[i].residual);
  }
  run.seek(20);
  for (int i = 0; i < 20; ++i) REQUIRE(run.advance());  // replays
  CHECK(run.at_end());
  CHECK(run.timeline().size() == 41);
  CHECK(same_bits(run.state(), states[40]));
}

TEST_CASE("a small budget drops states, not the past") {
  const auto scene = two_boxes();
  Session session(scene);
  for (int i = 0; i < 100; ++i) session.step();
  const std::size_t one = state_bytes(session.state());  // with what friction remembers
  Run tight(scene, 1, 200 * one), wide(scene, 1, kPlenty);
  for (int i = 0; i < 500; ++i) {
    REQUIRE(tight.advance());
    REQUIRE(wide.advance());
  }
  CHECK(tight.timeline().size() == 501);
  CHECK(tight.timeline().bytes() <= tight.timeline().budget());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tight.timeline().size(); ++i) kept += tight.timeline()[i].state ? 1 : 0;
  CHECK(kept < 260);
  for (std::size_t i = 0; i <= 500; i += 37) {
    CHECK(same_bits(*tight.timeline().state(i), *wide.timeline().state(i)));
  }
  Run tiny(scene, 1, 10 * one);
  for (int i = 0; i < 600; ++i) REQUIRE(tiny.advance());
  CHECK(tiny.timeline().forgotten() > 0);
  tiny.seek(0);
  CHECK(tiny.report().step == static_cast<std::int64_t>(tiny.timeline().forgotten()));
  CHECK(same_bits(tiny.state(), [&] {
    Session s(scene);
    while (s.state().step < tiny.report().step) s.step();
    return s.state();
  }()));
}

TEST_CASE("a change in the past is a branch that says where it parts from what it left") {
  Run run(two_boxes(), 1, kPlenty);
  for (int i = 0; i < 60; ++i) REQUIRE(run.advance());
  const State end = run.state();

  run.restart();  // nothing changed: the same run again
  for (int i = 0; i < 60; ++i) REQUIRE(run.advance());
  REQUIRE(run.parting());
  CHECK_FALSE(run.parting()->differs);
  CHECK(same_bits(run.state(), end));

  run.seek(30);
  const double branched = run.state().time;
  run.set_params(tuned(run.params(), {"gravity=[0,9.81,0]"}));
  CHECK(run.at_end());
  REQUIRE(run.left());
  CHECK(run.left()->size() == 30);
  for (int i = 0; i < 30; ++i) REQUIRE(run.advance());
  REQUIRE(run.parting());
  CHECK(run.parting()->time == branched);
  CHECK(*run.parting()->differs == Approx(branched + run.params().h));
  // Bodies part by |2 g| t²/2: more than d̂ = 10 mm after √(d̂/g) = 32 ms, two steps of 17 ms.
  REQUIRE(run.parting()->parted);
  CHECK(*run.parting()->parted > branched);
  CHECK(*run.parting()->parted < branched + 0.1);
  // The past has its own parameters.
  run.seek(10);
  CHECK(run.params().gravity.y() == -9.81);
  run.seek(40);
  CHECK(run.params().gravity.y() == 9.81);
}

TEST_CASE("parameters that no step was made with yet survive a look at the past") {
  Run run(two_boxes(), 1, kPlenty);
  for (int i = 0; i < 10; ++i) REQUIRE(run.advance());
  const int scene_N = run.params().contact.N;
  run.set_params(tuned(run.params(), {"contact.N=7"}));
  run.seek(5);
  CHECK(run.params().contact.N == scene_N);
  run.seek(10);
  CHECK(run.params().contact.N == 7);
  REQUIRE(run.advance());
  CHECK(run.timeline().back().params->contact.N == 7);
  CHECK(run.timeline()[10].params->contact.N == scene_N);
}

TEST_CASE("a step can be made again with another method, and nothing moves") {
  Run run(two_boxes(), 1, kPlenty);
  for (int i = 0; i < 24; ++i) REQUIRE(run.advance());
  const State before = run.state();
  run.observe(true, false);
  run.seek(run.cursor());
  CHECK(run.step_with(run.report().method).records.back().energy == run.report().records.back().energy);
  CHECK(run.step_with(SolverMethod::sissm).records.size() > 1);
  CHECK(same_bits(run.state(), before));
  Run other = run.fork();
  REQUIRE(other.advance());
  REQUIRE(run.advance());
  CHECK(same_bits(run.state(), other.state()));
}

TEST_CASE("the beginning says what it said, whatever was changed later") {
  Run run(two_boxes(), 1, kPlenty);
  const double potential = run.report().potential;
  for (int i = 0; i < 5; ++i) REQUIRE(run.advance());
  run.set_params(tuned(run.params(), {"gravity=[0,-1,0]", "solver.method=sissm"}));
  for (int i = 0; i < 5; ++i) REQUIRE(run.advance());
  run.seek(0);
  CHECK(run.report().potential == potential);
  CHECK(run.report().method == run.timeline()[0].report.method);
  CHECK(run.params().gravity.y() == -9.81);  // of the step that was made from there
  run.seek(5);
  CHECK(run.params().gravity.y() == -1);
  // A copy goes on with what was set, though no step was made with it yet.
  run.seek(10);
  run.set_params(tuned(run.params(), {"gravity=[0,-2,0]"}));
  Run copy = run.fork();
  CHECK(copy.params().gravity.y() == -2);
  copy.seek(3);
  copy.seek(10);
  CHECK(copy.params().gravity.y() == -2);
}

}  // namespace pabd::test_run
