// SPDX-License-Identifier: MIT
// The GPU as the maker of steps: the processor's motion, known states, any thread.
#include <catch2/catch.hpp>
#include <optional>
#include <thread>

#include "render/device/device_engine.h"
#include "render/device/pose_copies.h"
#include "render/gl/gl_objects.h"
#include "sim/math/so3.h"
#include "sim/solver/step_summary.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_engine {

namespace {

// A ball that skids on a floor, and one above it that falls on it.
TinyModel balls() {
  TinyModel tiny;
  tiny.add_fixed(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
  tiny.add(Sphere{0.5}, Vec3(0, 0.505, 0));
  tiny.add(Sphere{0.4}, Vec3(0.1, 1.45, 0));
  tiny.state.v[1] = Vec3(1, 0, 0.5);
  return tiny;
}

Params fine() {
  Params params;
  params.h = 0.005;
  return params;
}

std::shared_ptr<DeviceEngine> shared_engine() {
  static const auto engine = std::make_shared<DeviceEngine>(Backend::automatic);
  return engine;
}

// So many steps on from a state; the reports.
std::vector<StepReport> advance(StepEngine& engine, const Model& model, int steps, State& state) {
  std::vector<StepReport> reports;
  for (int k = 0; k < steps; ++k) {
    reports.emplace_back();
    engine.step(model, fine(), {}, state, reports.back());
  }
  return reports;
}

double energy(const StepSummary& s) { return s.kinetic + s.potential + s.elastic; }

}  // namespace

TEST_CASE("the engine's steps are those of the processor") {
  const TinyModel tiny = balls();
  State gpu = tiny.state, cpu = tiny.state;
  const auto reports = advance(*shared_engine(), tiny.model, 60, gpu);
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  for (const StepReport& of_gpu : reports) {
    step(tiny.model, fine(), options, cpu, workspace, report);
    CAPTURE(report.step, of_gpu.kinetic, report.kinetic);
    CHECK(of_gpu.step == report.step);
    CHECK(of_gpu.time == Approx(report.time));
    CHECK(of_gpu.kappa == report.kappa);
    CHECK(energy(of_gpu) == Approx(energy(report)).epsilon(1e-3));
    const PhaseTimes& t = of_gpu.times;
    CHECK(t.total > 0);
    CHECK(t.detect + t.set_up + t.solve + t.velocities == Approx(t.total));
  }
  CHECK(gpu.step == 60);
  CHECK(gpu.time == cpu.time);
  for (std::size_t i = 0; i < gpu.c.size(); ++i) CHECK((gpu.c[i] - cpu.c[i]).norm() < 1e-3);
  CHECK(kinetic_energy(tiny.model, gpu) == Approx(reports.back().kinetic).epsilon(1e-4));
}

TEST_CASE("bodies that stay on the GPU are the same ones once they are asked for, and so is what follows") {
  const TinyModel tiny = balls();
  const auto engine = shared_engine();
  State told = tiny.state, kept = tiny.state;
  const std::vector<StepReport> expected = advance(*engine, tiny.model, 20, told);
  engine->complete(told);
  StepOptions stay;
  stay.bodies_stay = true;
  StepReport report;
  for (int k = 0; k < 10; ++k) engine->step(tiny.model, fine(), stay, kept, report);
  CHECK(kept.step == 10);
  CHECK(kept.c[2] == tiny.state.c[2]);
  const bool copied = GENERATE(false, true);  // whoever asks has a copy, or the state itself
  State copy = kept;
  engine->complete(copied ? copy : kept);
  CHECK((copied ? copy : kept).c[2] != tiny.state.c[2]);
  for (int k = 10; k < 20; ++k) {
    engine->step(tiny.model, fine(), stay, kept, report);
    CHECK(report.kinetic == expected[static_cast<std::size_t>(k)].kinetic);
  }
  engine->complete(kept);
  CHECK(kept.step == told.step);
  CHECK(kept.time == told.time);
  for (std::size_t i = 0; i < told.c.size(); ++i) {
    CHECK(kept.c[i] == told.c[i]);
    CHECK(kept.R[i] == told.R[i]);
    CHECK(kept.v[i] == told.v[i]);
    CHECK(kept.omega[i] == told.omega[i]);
  }
  CHECK(kept.contacts.size() == told.contacts.size());
}

TEST_CASE("a state that is not the one it left is taken over: the same start gives the same bits") {
  const TinyModel tiny = balls();
  const auto engine = shared_engine();
  State first = tiny.state;
  advance(*engine, tiny.model, 8, first);
  const State at_8 = first;
  advance(*engine, tiny.model, 8, first);
  State again = tiny.state;  // another step
  advance(*engine, tiny.model, 16, again);
  CHECK(same_bits(first, again));
  State moved = tiny.state;
  advance(*engine, tiny.model, 8, moved);
  REQUIRE(same_bits(moved, at_8));
  moved.c[2].y() += 1;  // the same step, elsewhere
  advance(*engine, tiny.model, 1, moved);
  CHECK(moved.c[2].y() > at_8.c[2].y() + 0.9);
  State faster = tiny.state, spun = tiny.state, turned = tiny.state;
  advance(*engine, tiny.model, 8, faster);
  faster.v[2].x() += 10;
  advance(*engine, tiny.model, 1, faster);
  CHECK(faster.c[2].x() > at_8.c[2].x() + 0.04);
  advance(*engine, tiny.model, 8, spun);
  spun.omega[2].x() += 10;
  advance(*engine, tiny.model, 1, spun);
  CHECK(spun.omega[2].x() > at_8.omega[2].x() + 1);
  advance(*engine, tiny.model, 8, turned);
  turned.R[2] = exp_so3({0, 1, 0}) * turned.R[2];
  advance(*engine, tiny.model, 1, turned);
  CHECK((turned.R[2] - exp_so3({0, 1, 0}) * at_8.R[2]).norm() < 0.2);
}

TEST_CASE("the state has what contacts remember after complete()") {
  const TinyModel tiny = balls();
  State state = tiny.state;
  advance(*shared_engine(), tiny.model, 20, state);
  CHECK(state.contacts.empty());
  shared_engine()->complete(state);
  CHECK_FALSE(state.contacts.empty());
  const State whole = state;
  shared_engine()->complete(state);
  CHECK(same_bits(state, whole));
}

TEST_CASE("contacts are told of from when they are asked for, and the motion stays") {
  const TinyModel tiny = balls();
  DeviceEngine engine(Backend::automatic);
  StepOptions options;
  State plain = tiny.state, told = tiny.state, cpu = tiny.state;
  advance(*shared_engine(), tiny.model, 60, plain);
  std::vector<StepReport> reports(60);
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 60; ++k) {
    options.report_contacts = k >= 30;  // in the middle: what contacts remember goes along
    engine.step(tiny.model, fine(), options, told, reports[static_cast<std::size_t>(k)]);
    step(tiny.model, fine(), options, cpu, workspace, report);
  }
  CHECK(reports[29].contact_reports.empty());
  const auto& contacts = reports[59].contact_reports;
  REQUIRE(contacts.size() == report.contact_reports.size());
  REQUIRE(contacts.size() >= 1);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactReport &a = contacts[i], &b = report.contact_reports[i];
    CHECK(a.a == b.a);
    CHECK(a.b == b.b);
    CHECK((a.y_a - b.y_a).norm() < 1e-3);
    CHECK(a.normal_force == Approx(b.normal_force).epsilon(0.01));
    CHECK(a.sticking == b.sticking);
  }
  // But for the rounding of poses on their way there and back; without the memory it is several times as much.
  for (std::size_t i = 0; i < told.c.size(); ++i) {
    CHECK((told.c[i] - plain.c[i]).norm() < 1e-6);
    CHECK((told.omega[i] - plain.omega[i]).norm() < 1e-5 * (1 + plain.omega[i].norm()));
  }
}

TEST_CASE("another model is compiled anew") {
  const auto engine = shared_engine();
  std::optional<TinyModel> tiny = balls();
  State state = tiny->state;
  advance(*engine, tiny->model, 3, state);
  tiny->add(Sphere{0.2}, Vec3(5, 3, 0));  // where the old one was
  engine->forget();
  state = tiny->state;
  const auto reports = advance(*engine, tiny->model, 10, state);
  REQUIRE(state.size() == 4);
  const double t = 10 * fine().h;
  CHECK(state.c[3].y() == Approx(3 - 0.5 * 9.81 * t * t).epsilon(1e-5));
}

TEST_CASE("a step that is stopped before it begins is interrupted") {
  const TinyModel tiny = balls();
  State state = tiny.state;
  StepOptions options;
  options.stop = [] { return true; };
  StepReport report;
  shared_engine()->step(tiny.model, fine(), options, state, report);
  CHECK(report.status == StepStatus::interrupted);
  CHECK(report.step == 1);
  CHECK(same_bits(state, tiny.state));
}

TEST_CASE("a step that leaves the numbers says so, keeps the state, and is no hindrance") {
  const TinyModel tiny = balls();
  const auto engine = shared_engine();
  State good = tiny.state, fresh = tiny.state;
  advance(*engine, tiny.model, 5, fresh);
  State wild = tiny.state;
  wild.v[2] = Vec3(1e300, 0, 0);
  const State before = wild;
  for (int k = 0; k < 2; ++k) {  // the second time from the same state
    const StepReport report = advance(*engine, tiny.model, 1, wild).front();
    CHECK(report.status == StepStatus::non_finite);
    CHECK(report.step == 1);
    CHECK(std::isnan(report.kinetic));
    CHECK(same_bits(wild, before));
  }
  advance(*engine, tiny.model, 5, good);
  CHECK(same_bits(good, fresh));
}

TEST_CASE("threads that are all there take turns") {
  const TinyModel tiny = balls();
  DeviceEngine engine(Backend::automatic);
  State here = tiny.state, turns = tiny.state;
  engine.prepare(tiny.model, fine(), {}, turns);
  for (int k = 0; k < 3; ++k) {
    std::exception_ptr failure;
    std::thread([&] {
      try {
        advance(engine, tiny.model, 1, turns);
      } catch (...) {
        failure = std::current_exception();
      }
    }).join();
    if (failure) std::rethrow_exception(failure);
    advance(engine, tiny.model, 1, turns);
    engine.complete(turns);
  }
  advance(*shared_engine(), tiny.model, 6, here);
  CHECK(same_bits(here, turns));
}

TEST_CASE("steps come from any thread, and who draws in another keeps his context, also at the end") {
  const TinyModel tiny = balls();
  std::vector<ContextAttempt> attempts;
  auto engine = std::make_unique<DeviceEngine>(Backend::automatic);
  const auto drawing = create_headless_context(Backend::automatic, attempts);
  const GlFunctions gl(*drawing);
  std::optional<GlBuffer> buffer(gl);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer->id());
  gl.BufferData(GL_ARRAY_BUFFER, 16, nullptr, GL_STATIC_DRAW);
  State here = tiny.state, there = tiny.state;
  std::thread([&] { advance(*engine, tiny.model, 3, there); }).join();
  std::thread([&] { advance(*engine, tiny.model, 3, there); }).join();
  engine.reset();
  CHECK(gl.integer(GL_ARRAY_BUFFER_BINDING) == static_cast<GLint>(buffer->id()));
  gl.check("drawing on");
  buffer.reset();
  drawing->release();
  advance(*shared_engine(), tiny.model, 6, here);
  CHECK(same_bits(here, there));
}

TEST_CASE("there is room for as many bodies as buffers and memory have") {
  constexpr std::int64_t kMiB = 1024 * 1024;
  CHECK(bodies_in(128 * kMiB, 0) == 128 * 1024);
  CHECK(bodies_in(4096 * kMiB, 35 * 1024 * kMiB) == 4096 * 1024);
  CHECK(bodies_in(4096 * kMiB, 4200 * kMiB) == kMiB);
  const DeviceCapacity here = DeviceEngine::capacity(Backend::automatic);
  CHECK(here.why_not.empty());
  CHECK(here.renderer == shared_engine()->name());
  CHECK(here.bodies == bodies_in(here.largest_buffer, here.memory));
  CHECK(here.bodies > 1000);
}

namespace {

// c of each body, as a copy has it.
std::vector<Vec3> places(const ComputeFunctions& gl, const GlPoses& poses, std::size_t bodies) {
  std::vector<double> numbers(8 * bodies);
  gl.BindBuffer(GL_COPY_READ_BUFFER, poses.begin(gl));
  gl.GetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(numbers.size() * sizeof(double)),
                      numbers.data());
  poses.end(gl);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < bodies; ++i)
    out.emplace_back(numbers[8 * i], numbers[8 * i + 1], numbers[8 * i + 2]);
  return out;
}

}  // namespace

TEST_CASE("who lends a context draws from copies of the poses, which stay as they are while steps go on") {
  const TinyModel tiny = balls();
  std::vector<ContextAttempt> attempts;
  const auto drawer = create_headless_context(Backend::automatic, attempts);
  SharedContext shared;
  shared.put_beside(*drawer);
  auto engine = std::make_unique<DeviceEngine>(Backend::automatic, &shared);
  REQUIRE(engine->keeps_bodies(tiny.model));
  CHECK_FALSE(shared_engine()->keeps_bodies(tiny.model));  // nobody lent it one
  // What is lent is lent once.
  CHECK_FALSE(DeviceEngine(Backend::automatic, &shared).keeps_bodies(tiny.model));

  State told = tiny.state, kept = tiny.state;
  std::vector<State> expected;
  for (int k = 0; k < 6; ++k) {
    advance(*shared_engine(), tiny.model, 1, told);
    expected.push_back(told);
  }
  drawer->make_current();
  const ComputeFunctions gl(*drawer);
  StepOptions stay;
  stay.bodies_stay = true;
  StepReport report;
  std::vector<std::shared_ptr<const PoseCopy>> copies;
  const auto check_all = [&] {
    drawer->make_current();
    for (std::size_t k = 0; k < copies.size(); ++k) {
      CAPTURE(k, copies.size());
      CHECK(places(gl, dynamic_cast<const GlPoses&>(*copies[k]), told.c.size()) == expected[k].c);
    }
  };
  for (int k = 0; k < 6; ++k) {
    std::thread([&] {
      engine->step(tiny.model, fine(), stay, kept, report);
      copies.push_back(engine->copy_poses());
    }).join();
    check_all();
  }
  // A copy that is let go is used again; what others hold stays, also after the engine.
  const GLuint first = dynamic_cast<const GlPoses&>(*copies[0]).begin(gl);
  copies.erase(copies.begin(), copies.begin() + 2);
  expected.erase(expected.begin(), expected.begin() + 2);
  const auto again = engine->copy_poses();
  const GLuint used = dynamic_cast<const GlPoses&>(*again).begin(gl);
  CHECK((used == first || used == first + 1));
  engine->complete(kept);
  CHECK(kept.c == expected.back().c);
  engine.reset();
  check_all();
  engine = std::make_unique<DeviceEngine>(Backend::automatic, &shared);
  CHECK(engine->keeps_bodies(tiny.model));
  engine.reset();
  shared.drop();
  CHECK_FALSE(DeviceEngine(Backend::automatic, &shared).keeps_bodies(tiny.model));
}

}  // namespace pabd::test_device_engine
