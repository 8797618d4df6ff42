// SPDX-License-Identifier: MIT
// A session whose steps are made by somebody else: what it is given, what it is told, and who may have it.
#include <catch2/catch.hpp>

#include "app/session/run.h"
#include "tests/support/drift_device.h"
#include "tests/support/errors.h"

namespace pabd::test_step_engine {

using namespace test;

namespace {

// Free flight without gravity that leaves the memory of contacts out.
class Drift : public StepEngine {
 public:
  std::string name() const override { return "drift"; }
  void prepare(const Model& model, const Params&, const StepOptions&, const State& state) override {
    prepared.push_back(&model);
    REQUIRE(model.size() == state.size());
  }
  void step(const Model& model, const Params& params, const StepOptions& options, State& state,
            StepReport& report) override {
    if (!options.pulls.empty()) throw Error(ErrorKind::bad_input, "no hands");
    stepped.push_back(&model);
    drift(params, state, report);
  }
  void complete(State& state) override { state.contacts.assign(1, ContactMemory{7, 0, Vec3::Zero()}); }
  void forget() override { ++forgotten; }

  std::vector<const Model*> prepared, stepped;
  int forgotten = 0;
};

}  // namespace

TEST_CASE("the engine makes the steps, and the processor none of them") {
  const auto scene = thrown_balls(SolverDevice::cpu);
  const auto drift = std::make_shared<Drift>();
  Session session(scene);
  CHECK_FALSE(session.has_engine());
  session.solve_with(drift);
  CHECK(session.has_engine());
  session.prepare();
  CHECK(drift->prepared == std::vector<const Model*>{&session.model()});
  for (int k = 0; k < 10; ++k) CHECK(session.step().status == StepStatus::converged);
  CHECK(drift->stepped.size() == 10);
  CHECK(session.report().step == 10);
  CHECK((session.state().c[0] - Vec3(30 * session.params().h, 10, 0)).norm() < 1e-12);
  CHECK(session.state().contacts.empty());
  session.complete_state();
  CHECK(session.state().contacts.size() == 1);
  // Back on the processor there is gravity.
  session.solve_with(nullptr);
  session.step();
  CHECK(drift->stepped.size() == 10);
  CHECK(session.state().c[0].y() < 10);
}

TEST_CASE("what an engine left out of a state is there when the processor goes on") {
  const auto drift = std::make_shared<Drift>();
  Session session(thrown_balls(SolverDevice::cpu));
  session.solve_with(drift);
  session.step();
  CHECK(session.state().contacts.empty());
  session.solve_with(nullptr);
  CHECK(session.state().contacts.size() == 1);
}

TEST_CASE("the engine is told when the model changes, not when the state does") {
  const auto drift = std::make_shared<Drift>();
  Session session(thrown_balls(SolverDevice::cpu));
  session.solve_with(drift);
  session.step();
  session.set_state(session.scene().initial);
  session.reset();
  session.step();
  CHECK(drift->forgotten == 0);
  session.edit(RemoveBody{1});
  CHECK(drift->forgotten == 1);
  session.reset();
  CHECK(drift->forgotten == 2);
}

TEST_CASE("a step that the engine refuses leaves the state as it was") {
  Session session(thrown_balls(SolverDevice::cpu));
  session.solve_with(std::make_shared<Drift>());
  session.step();
  const State before = session.state();
  session.set_pulls({Pull{0, Vec3::Zero(), Vec3::Zero(), 1}});
  CHECK(caught([&] { session.step(); }).kind == bad_input);
  CHECK(same_bits(session.state(), before));
}

TEST_CASE("a run that can be wound back has no engine, one without a past may") {
  const auto drift = std::make_shared<Drift>();
  Run past(thrown_balls(SolverDevice::cpu), 1, 1000000);
  const Caught refused = caught([&] { past.solve_with(drift); });
  CHECK(refused.kind == bad_input);
  CHECK(refused.says("wound back"));
  CHECK(refused.says("leave out the device"));
  CHECK_NOTHROW(past.solve_with(nullptr));
  CHECK(past.advance());
  CHECK(drift->stepped.empty());

  Run run(thrown_balls(SolverDevice::cpu), 1, kNoPast);
  run.solve_with(drift);
  for (int k = 0; k < 5; ++k) REQUIRE(run.advance());
  CHECK(drift->stepped.size() == 5);
  CHECK(run.timeline().size() == 1);
  CHECK((run.state().c[0] - Vec3(15 * run.params().h, 10, 0)).norm() < 1e-12);
  // What would compute the past anew is refused, and nothing has happened.
  CHECK(caught([&] { run.fork(); }).says("wound back"));
  CHECK(caught([&] { run.seek(0); }).says("wound back"));
  CHECK(caught([&] { run.restart(); }).says("wound back"));
  CHECK(run.state().step == 5);
  // Until the processor has it, with all that the engine remembers.
  run.solve_with(nullptr);
  CHECK(run.state().contacts.size() == 1);
  CHECK_NOTHROW(run.fork());
}

TEST_CASE("an engine that keeps bodies to itself is told of states that did not come from it") {
  const auto scene = thrown_balls(SolverDevice::cpu);
  const auto drift = std::make_shared<Drift>();
  Session session(scene);
  session.solve_with(drift);
  session.step();
  session.reset();
  CHECK(drift->forgotten == 0);  // it looks at the state itself
  session.let_bodies_stay(true);
  session.step();
  session.reset();
  CHECK(drift->forgotten == 1);
  session.set_state(session.whole_state());
  CHECK(drift->forgotten == 2);
}

}  // namespace pabd::test_step_engine
