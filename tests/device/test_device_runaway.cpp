// SPDX-License-Identifier: MIT
// States beyond any sense (sim/solver/runaway.h): the GPU notices what the processor does.
#include <catch2/catch.hpp>

#include "render/device/device_engine.h"
#include "sim/solver/step_summary.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_runaway {

namespace {

// Two balls deep in each other, which part, and one far from them that flies.
TinyModel overlapping() {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, Vec3(0, 1, 0));
  tiny.add(Sphere{0.3}, Vec3(0.2, 1.5, 0.1));
  tiny.add(Sphere{0.5}, Vec3(50, 0, 0));
  tiny.state.v[2] = Vec3(40, 0, 0);
  tiny.state.omega[1] = Vec3(1, 2, 3);
  return tiny;
}

Params weightless() {
  Params params;
  params.gravity = Vec3::Zero();
  params.contact.recovery_speed = 0;
  return params;
}

}  // namespace

TEST_CASE("what tells of running away is of the bodies in touch") {
  const TinyModel tiny = overlapping();
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  for (const auto precision : {DevicePrecision::single, DevicePrecision::twofold}) {
    DeviceSolver solver(*context, tiny.model, tiny.state, {.precision = precision});
    const double before = kinetic_energy(tiny.model, tiny.state);
    const StepSummary& summary = solver.step(weightless());
    CHECK(summary.status != StepStatus::non_finite);
    State end;
    solver.read_state(end);
    const DeviceGain gain = solver.gain();
    // Free flight keeps the energy where there is no gravity.
    const double gained = kinetic_energy(tiny.model, end) - before;
    REQUIRE(gained > 1e-3 * before);
    CHECK(gain.gained == Approx(gained).epsilon(1e-4));
    const Vec3 lo(-0.5, 0.5, -0.5), hi(0.5, 1.8, 0.5);
    const double opening = 0.8 - Vec3(0.2, 0.5, 0.1).norm();
    CHECK(gain.width == Approx((hi - lo).norm() + opening).epsilon(1e-5));
    double fastest = 0;
    for (const std::size_t i : {0u, 1u}) {
      State alone = end;
      for (std::size_t k = 0; k < 3; ++k)
        if (k != i) alone.v[k] = alone.omega[k] = Vec3::Zero();
      fastest = std::max(fastest, std::sqrt(2 * kinetic_energy(tiny.model, alone) / tiny.model.mass[i]));
    }
    CHECK(gain.fastest == Approx(fastest).epsilon(1e-5));
    // A hundred times as far as anything asks for.
    Params once = weightless();
    once.solver.halvings = 0;
    for (const double part : {0.99, 1.01}) {
      TinyModel both = overlapping();
      both.state.v[0] = both.state.v[1] = Vec3(0, 0, part * 100 * gain.width / once.h);
      solver.set_state(both.state);
      CHECK((solver.step(once).status == StepStatus::non_finite) == (part > 1));
    }
  }
  TinyModel apart = overlapping();
  apart.state.c[1].y() = 5;
  DeviceSolver solver(*context, apart.model, apart.state);
  solver.step(weightless());
  CHECK(solver.gain().width == 0);
  CHECK(solver.finish().status == StepStatus::converged);
}

TEST_CASE("bodies in touch where a double no longer resolves the contact are no result of a step") {
  DeviceEngine engine(Backend::automatic);
  for (const double x : {1e9, 4e13, 6e13}) {  // d̂/ε is 4.5e13 m
    TinyModel tiny;
    tiny.add_fixed(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
    tiny.add(Sphere{0.5}, Vec3(x, 0.505, 0));
    const Params params;
    State gpu = tiny.state, cpu = tiny.state;
    StepReport of_gpu, of_cpu;
    engine.step(tiny.model, params, {}, gpu, of_gpu);
    StepWorkspace workspace;
    step(tiny.model, params, {}, cpu, workspace, of_cpu);
    CAPTURE(x);
    CHECK((of_cpu.status == StepStatus::non_finite) == (x > 4.5e13));
    CHECK((of_gpu.status == StepStatus::non_finite) == (x > 4.5e13));
    CHECK(std::isnan(of_gpu.kinetic) == (x > 4.5e13));
    if (x > 4.5e13) CHECK(same_bits(gpu, tiny.state));
    engine.forget();
  }
  // As fast as that is none either, where it touches.
  TinyModel tiny;
  tiny.add_fixed(Plane{Vec3::UnitY(), 0}, Vec3::Zero());
  tiny.add(Sphere{0.5}, Vec3(0, 0.505, 0));
  Params params;
  params.h = 1;
  tiny.state.v[1] = Vec3(6e13, 0, 0);
  params.contact.mu_static = params.contact.mu_dynamic = 0;
  State gpu = tiny.state, cpu = tiny.state;
  StepReport of_gpu, of_cpu;
  engine.step(tiny.model, params, {}, gpu, of_gpu);
  StepWorkspace workspace;
  step(tiny.model, params, {}, cpu, workspace, of_cpu);
  CHECK(of_cpu.status == StepStatus::non_finite);
  CHECK(of_gpu.status == StepStatus::non_finite);
}

}  // namespace pabd::test_device_runaway
