// SPDX-License-Identifier: MIT
// Joints with the processor, contacts with the GPU, in one step: what belongs to whom, that each is what it would be
// alone, and that nothing couples the two unseen.
#include <catch2/catch.hpp>

#include "render/device/split_engine.h"
#include "sim/scene/scene.h"
#include "sim/solver/step_summary.h"
#include "tests/support/errors.h"

namespace pabd::test_split_engine {

namespace {

// A pendulum of two rods over a floor, a crate that the lower one rests on, and a tower beside them; a ball far off that
// comes in at `speed`.
Scene pendulum_and_tower(double speed = 0) {
  const std::string text = R"({"format": "pabd-scene", "version": 1, "solver": {"iterations": 200},
    "bodies": [
      {"name": "tower 0", "shape": {"type": "box", "size": [1, 1, 1]}, "position": [10, 0.505, 0]},
      {"name": "post", "shape": {"type": "box", "size": [0.2, 4, 0.2]}, "position": [0, 2, -2], "fixed": true},
      {"name": "rod", "shape": {"type": "box", "size": [0.2, 1, 0.2]}, "position": [0, 3.5, 0], "velocity": [1, 0, 0]},
      {"name": "bob", "shape": {"type": "sphere", "radius": 0.3}, "position": [0, 2.5, 0]},
      {"name": "tower 1", "shape": {"type": "box", "size": [1, 1, 1]}, "position": [10.1, 1.51, 0]},
      {"name": "ball", "shape": {"type": "sphere", "radius": 0.3}, "position": [6, 4.7, 0], "velocity": [)" +
                           std::to_string(-speed) + R"(, 0, 0]},
      {"name": "floor", "shape": {"type": "plane", "normal": [0, 1, 0], "offset": 0}, "fixed": true}],
    "joints": [
      {"type": "spherical", "bodies": [null, "rod"], "anchor": [0, 4, 0]},
      {"type": "spherical", "bodies": ["rod", "bob"], "anchor": [0, 3, 0]}]})";
  return parse_scene(text, "pendulum", {});
}

struct Both {
  State gpu, cpu;
  StepReport of_gpu, of_cpu;
};

}  // namespace

TEST_CASE("what hangs on joints and what is near it is the processor's, the rest the GPU's") {
  const Scene scene = pendulum_and_tower();
  const auto jointed = jointed_bodies(scene.model, scene.params, scene.initial);
  CHECK(jointed == std::vector<std::uint8_t>{0, 0, 1, 1, 0, 0, 0});
  const ModelParts parts = split_model(scene.model, jointed);
  CHECK(parts.jointed.bodies == std::vector<Index>{1, 2, 3, 6});
  CHECK(parts.free.bodies == std::vector<Index>{0, 1, 4, 5, 6});
  CHECK(parts.jointed.model.joints.size() == 2);
  CHECK(parts.jointed.model.joints[1].i == 1);
  CHECK(parts.jointed.model.joints[1].j == 2);
  CHECK(parts.free.model.joints.empty());
  CHECK_FALSE(coupling(scene.model, parts, scene.params, scene.initial));
  CHECK(SplitEngine::on_gpu(scene.model, scene.params, scene.initial) == 3);
  CHECK(SplitEngine::why_not(scene.model, scene.params, {}, scene.initial).empty());
  // One that rests on what hangs, and one that rests on that.
  State near = scene.initial;
  near.c[5] = Vec3(0, 1.89, 0);
  near.c[4] = Vec3(0, 1.08, 0);
  const auto more = jointed_bodies(scene.model, scene.params, near);
  CHECK(more == std::vector<std::uint8_t>{0, 0, 1, 1, 1, 1, 0});
  const auto pair = coupling(scene.model, parts, scene.params, near);
  REQUIRE(pair);
  CHECK(pair->first == 3);
  // Nothing is left for the GPU.
  near.c[0] = Vec3(0.2, 3.2, 0);
  near.c[5] = Vec3(0, 1.89, 0);
  CHECK(SplitEngine::why_not(scene.model, scene.params, {}, near).find("--device cpu") != std::string::npos);
}

TEST_CASE("parts of a state come together to the whole") {
  const Scene scene = pendulum_and_tower();
  State whole = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 5; ++k) step(scene.model, scene.params, {}, whole, workspace, report);
  REQUIRE_FALSE(whole.contacts.empty());
  const ModelParts parts = split_model(scene.model, jointed_bodies(scene.model, scene.params, whole));
  State jointed, free, again = whole;
  take_part(parts.jointed, whole, jointed);
  take_part(parts.free, whole, free);
  CHECK(jointed.size() == 4);
  CHECK(free.contacts.size() == whole.contacts.size());
  for (Vec3& c : again.c) c += Vec3(1, 2, 3);
  again.c[1] = whole.c[1];
  again.c[6] = whole.c[6];
  again.contacts.clear();
  put_part(parts.jointed, jointed, again);
  put_part(parts.free, free, again);
  CHECK(same_bits(again, whole));
}

TEST_CASE("each part goes as it would alone, to the bit, with what joints remember") {
  Scene scene = pendulum_and_tower();
  scene.params.solver.integrator = Integrator::bdf2;
  SplitEngine engine(Backend::automatic);
  Both s{scene.initial, scene.initial, {}, {}};
  StepOptions options;
  options.report_contacts = options.report_joints = true;
  StepWorkspace workspace;
  engine.prepare(scene.model, scene.params, options, s.gpu);
  // The GPU's part alone, with the stiffness of the whole.
  const ModelParts parts = split_model(scene.model, jointed_bodies(scene.model, scene.params, scene.initial));
  Params whole = scene.params;
  whole.contact.kappa = resolve_kappa(scene.model, scene.params);
  DeviceEngine device(Backend::automatic);
  State alone;
  StepReport of_alone;
  take_part(parts.free, scene.initial, alone);
  for (int k = 0; k < 60; ++k) {
    engine.step(scene.model, scene.params, options, s.gpu, s.of_gpu);
    step(scene.model, scene.params, options, s.cpu, workspace, s.of_cpu);
    CAPTURE(k);
    REQUIRE(s.gpu.step == s.cpu.step);
    for (const std::size_t i : {2u, 3u}) {
      CHECK(s.gpu.c[i] == s.cpu.c[i]);
      CHECK(s.gpu.omega[i] == s.cpu.omega[i]);
    }
    device.step(parts.free.model, whole, {.report_contacts = true}, alone, of_alone);
    for (const Index i : {0, 4, 5}) CHECK(s.gpu.c[i] == alone.c[parts.free.place[i]]);
    CHECK(s.of_gpu.kinetic == Approx(kinetic_energy(scene.model, s.gpu)).epsilon(1e-5));
    CHECK(s.of_gpu.potential == Approx(potential_energy(scene.model, whole, s.gpu)).epsilon(1e-9));
    CHECK(s.of_gpu.elastic >= of_alone.elastic);
    CHECK(s.of_gpu.iterations >= of_alone.iterations);
    CHECK(s.of_gpu.kappa == s.of_cpu.kappa);
    CHECK(s.of_gpu.max_joint_error == s.of_cpu.max_joint_error);
    REQUIRE(s.of_gpu.joint_reports.size() == 2);
    CHECK((s.of_gpu.joint_reports[0].force - s.of_cpu.joint_reports[0].force).norm() == 0);
  }
  CHECK(s.of_gpu.contacts == s.of_cpu.contacts);
  CHECK(s.of_gpu.elastic == Approx(s.of_cpu.elastic).epsilon(1e-3));
  REQUIRE(s.of_gpu.contact_reports.size() == s.of_cpu.contact_reports.size());
  for (std::size_t k = 0; k < s.of_gpu.contact_reports.size(); ++k) {
    CHECK(s.of_gpu.contact_reports[k].a == s.of_cpu.contact_reports[k].a);
    CHECK(s.of_gpu.contact_reports[k].b == s.of_cpu.contact_reports[k].b);
  }
  engine.complete(s.gpu);
  CHECK(s.gpu.contacts.size() == s.cpu.contacts.size());
  CHECK(s.gpu.joint_force.size() == 2);
}

TEST_CASE("a step that is stopped in either part can be made again, and nothing is lost") {
  const Scene scene = pendulum_and_tower();
  const StepOptions plain;
  for (const int at : {1, 2, 3}) {  // which of its looks is told to stop
    CAPTURE(at);
    SplitEngine engine(Backend::automatic), whole_engine(Backend::automatic);
    State state = scene.initial, whole = scene.initial;
    StepReport report;
    for (int k = 0; k < 40; ++k) {  // until the tower rests on its friction
      engine.step(scene.model, scene.params, plain, state, report);
      whole_engine.step(scene.model, scene.params, plain, whole, report);
    }
    const State before = state;
    int looks = 0;
    StepOptions stopping;
    stopping.stop = [&] { return ++looks >= at; };
    engine.step(scene.model, scene.params, stopping, state, report);
    REQUIRE(looks >= at);
    CHECK(report.status == StepStatus::interrupted);
    CHECK(same_bits(state, before));
    for (int k = 0; k < 5; ++k) {
      engine.step(scene.model, scene.params, plain, state, report);
      whole_engine.step(scene.model, scene.params, plain, whole, report);
    }
    engine.complete(state);
    whole_engine.complete(whole);
    REQUIRE_FALSE(whole.contacts.empty());
    CHECK(same_bits(state, whole));
  }
}

TEST_CASE("where the parts would meet the step is refused before they do, and the state is whole") {
  const Scene scene = pendulum_and_tower(8);
  SplitEngine engine(Backend::automatic);
  State state = scene.initial, cpu = scene.initial;
  StepReport report, of_cpu;
  StepOptions options;
  options.report_contacts = true;
  StepWorkspace workspace;
  Caught caught_at;
  State before = state;
  for (int k = 0; k < 120 && !caught_at.kind; ++k) {
    step(scene.model, scene.params, options, cpu, workspace, of_cpu);
    before = state;
    caught_at = caught([&] { engine.step(scene.model, scene.params, options, state, report); });
    if (caught_at.kind) break;
    // Whatever the processor finds between the two must have been refused.
    for (const ContactReport& contact : of_cpu.contact_reports)
      CHECK_FALSE((std::min(contact.a, contact.b) == 3 && std::max(contact.a, contact.b) == 5));
  }
  REQUIRE(caught_at.kind == bad_input);
  CHECK(caught_at.says("comes near ball"));
  CHECK(caught_at.says("--device cpu, or --device auto"));
  CHECK(state.step > 10);
  CHECK(same_bits(state, before));
  engine.complete(state);
  for (int k = 0; k < 40; ++k) step(scene.model, scene.params, options, state, workspace, report);
  CHECK(state.v[5].x() > -6);  // it hit the bob
  // Back at the beginning, and where all are together: taken, or refused as a whole.
  State start = scene.initial;
  CHECK_NOTHROW(engine.step(scene.model, scene.params, options, start, report));
  State near = scene.initial;
  near.time = 3;
  near.c[5] = Vec3(0, 1.89, 0);
  near.v[5] = Vec3::Zero();
  CHECK_NOTHROW(
      engine.step(scene.model, scene.params, options, near, report));  // the ball is the processor's now
  CHECK(near.step == 1);
}

}  // namespace pabd::test_split_engine
