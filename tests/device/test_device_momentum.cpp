// SPDX-License-Identifier: MIT
// Momentum of two bodies that meet where nothing else is: kept by the GPU as by the processor.
#include <catch2/catch.hpp>

#include "render/device/device_solver.h"
#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_scenes.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_momentum {

namespace {

struct Momentum {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
};

Momentum momentum(const Model& model, const State& state) {
  Momentum out;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    out.P += model.mass[i] * state.v[i];
    out.L += model.mass[i] * state.c[i].cross(state.v[i]) +
             state.R[i] * inertia_tensor(model.J[i]) * state.R[i].transpose() * state.omega[i];
  }
  return out;
}

Params weightless(double h) {
  Params params;
  params.gravity = Vec3::Zero();
  params.h = h;
  params.solver.iterations = 200;
  return params;
}

TinyModel glancing(const Shape& a, const Shape& b, double speed) {
  TinyModel tiny;
  tiny.add(a, Vec3(-1.2, 0, 0.1));
  tiny.add(b, Vec3(1, 0.4, 0));
  tiny.state.v[0] = Vec3(speed, 0, 0);
  tiny.state.v[1] = Vec3(-speed, 0.1, 0);
  tiny.state.omega[1] = Vec3(1, -2, 3);
  return tiny;
}

}  // namespace

TEST_CASE("two bodies that meet in free flight keep their momentum, linear and angular") {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  const Sphere ball{0.5}, small{0.2};
  const Box crate{Vec3(0.4, 0.3, 0.5)};
  const Shape can = make_shape("cylinder", {0.4, 0.7}), cone = make_shape("cone", {0.5, 0.8});
  const auto stone = [](const Vec3& at) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back(at + 0.3 * Vec3(k & 1 ? 1.3 : -1, k & 2 ? 1 : -1.2, k & 4 ? 1.1 : -1));
    return Hull{make_hull(corners).hull};
  };
  const Shape two_stones = make_compound({stone(Vec3(0, 0, 0.3)), stone(Vec3(0.2, 0.1, -0.4))});
  const std::pair<Shape, Shape> pairs[] = {{ball, ball}, {ball, small}, {crate, ball},      {crate, crate},
                                           {can, ball},  {can, cone},   {two_stones, crate}};
  const bool exact = testing::keeps_doubles(*context);
  for (const auto& [a, b] : pairs) {
    for (const double speed : {4.0, 20.0}) {
      for (const auto precision : {DevicePrecision::single, DevicePrecision::twofold}) {
        const TinyModel tiny = glancing(a, b, speed);
        DeviceSolver solver(*context, tiny.model, tiny.state, {.precision = precision});
        const Momentum before = momentum(tiny.model, tiny.state);
        State state;
        bool met = false;
        const double rounding = precision == DevicePrecision::single ? 3e-5 : exact ? 1e-11 : 1e-7;
        const double mass = tiny.model.mass[0] + tiny.model.mass[1];
        for (int k = 0; k < 30; ++k) {
          met = solver.step(weightless(1.0 / 60)).contacts > 0 || met;
          solver.read_state(state);
          const Momentum now = momentum(tiny.model, state);
          CAPTURE(speed, k, precision == DevicePrecision::single);
          CHECK((now.P - before.P).norm() < rounding * mass * speed);
          CHECK((now.L - before.L).norm() < rounding * mass * speed);
        }
        CHECK(met);
      }
    }
  }
}

TEST_CASE("a pair's step in double is the processor's, turned as a whole") {
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  const TinyModel tiny = glancing(Box{Vec3(0.4, 0.3, 0.5)}, Sphere{0.3}, 4);
  Params params = weightless(1.0 / 60);
  params.contact.mu_static = params.contact.mu_dynamic = 0;  // bounds of friction are found otherwise
  params.solver.method = SolverMethod::descent;
  params.solver.tolerance = 0;
  params.solver.iterations = 400;
  DeviceSolver solver(*context, tiny.model, tiny.state, {.precision = DevicePrecision::twofold});
  State gpu, cpu = tiny.state;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 25; ++k) {
    solver.step(params);
    solver.read_state(gpu);
    step(tiny.model, params, {}, cpu, workspace, report);
    CAPTURE(k);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK((gpu.c[i] - cpu.c[i]).norm() < 1e-8);
      CHECK((gpu.v[i] - cpu.v[i]).norm() < 1e-6);
      CHECK((gpu.omega[i] - cpu.omega[i]).norm() < 1e-6);
    }
  }
}

}  // namespace pabd::test_device_momentum
